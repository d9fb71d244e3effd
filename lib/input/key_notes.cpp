#include "lib/input/key_notes.hpp"

#include <algorithm>
#include <sstream>

namespace plumb {
namespace {

/// "boundary.2.kind" as "boundary.0.kind": one of a list stands for all.
std::string pattern_of(const std::string& path) {
  std::string out;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) {
    const bool number = part.find_first_not_of("0123456789") == std::string::npos;
    out += (out.empty() ? "" : ".") + (number ? "0" : part);
  }
  return out;
}

/// Makes `form` take what `other` takes, too.
void widen(ValueForm& form, const ValueForm& other) {
  if (form.sign != other.sign) form.sign = Sign::any;
  form.least = std::min(form.least, other.least);
  if (form.count != other.count) form.count = 0;
  for (const std::string& word : other.words)
    if (std::find(form.words.begin(), form.words.end(), word) == form.words.end()) form.words.push_back(word);
}

}  // namespace

void KeyNotes::take(const std::string& section, const Key& key, const std::vector<ValueForm>& forms,
                    bool optional, const std::string& otherwise) {
  const std::string path = pattern_of(section.empty() ? key.name : section + "." + key.name);
  auto at = std::find_if(keys_.begin(), keys_.end(), [&](const KeyNote& one) { return one.path == path; });
  if (at == keys_.end()) at = keys_.insert(at, KeyNote{path, "", {}, {}, false});
  demanded_ = optional ? "" : path;
  if (at->meaning.empty()) at->meaning = key.meaning;
  at->optional = at->optional || optional;
  if (!otherwise.empty()) at->otherwise.insert(otherwise);
  for (const ValueForm& form : forms) {
    const auto same = std::find_if(at->forms.begin(), at->forms.end(), [&](const ValueForm& other) {
      return other.kind == form.kind && other.quantity.dimension == form.quantity.dimension;
    });
    same == at->forms.end() ? at->forms.push_back(form) : widen(*same, form);
  }
}

void KeyNotes::close(const std::string& section, const std::set<std::string>& asked) {
  const auto [at, first] = always_.try_emplace(pattern_of(section), asked);
  if (!first) std::erase_if(at->second, [&](const std::string& key) { return !asked.contains(key); });
}

void KeyNotes::add(const KeyNotes& other) {
  for (const KeyNote& key : other.keys_) {
    take("", {key.path, key.meaning}, key.forms, key.optional);
    for (const std::string& otherwise : key.otherwise)
      take("", {key.path, key.meaning}, {}, key.optional, otherwise);
  }
  for (const auto& [section, asked] : other.always_) close(section, asked);
}

const KeyNote* KeyNotes::find(const std::string& path) const {
  const auto at =
      std::find_if(keys_.begin(), keys_.end(), [&](const KeyNote& one) { return one.path == path; });
  return at == keys_.end() ? nullptr : &*at;
}

bool KeyNotes::required(const KeyNote& key) const {
  const auto dot = key.path.rfind('.');
  const std::string section = dot == std::string::npos ? "" : key.path.substr(0, dot);
  const auto at = always_.find(section);
  return !key.optional && at != always_.end() &&
         at->second.contains(dot == std::string::npos ? key.path : key.path.substr(dot + 1));
}

std::size_t KeyNotes::extent() const {
  std::size_t sum = keys_.size() + always_.size();
  for (const KeyNote& key : keys_)
    for (const ValueForm& form : key.forms) sum += 1 + form.words.size();
  return sum;
}

}  // namespace plumb
