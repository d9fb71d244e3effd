#include "lib/input/explored_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

TomlValue value_of(const std::string& toml) {
  return *parse_document("v = " + toml, "sample").find("v");
}

std::string list_of(const std::string& entry, std::size_t count) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += (k == 0 ? "" : ", ") + entry;
  return "[" + all + "]";
}

/// Lists of as many entries as the getter asks for; of one to three if any number will do.
std::vector<std::string> lists_of(const std::string& entry, std::size_t count) {
  if (count > 0) return {list_of(entry, count)};
  return {list_of(entry, 1), list_of(entry, 2), list_of(entry, 3)};
}

/// Whole numbers from the least on: a dimension, say, of which readers do different things.
std::vector<std::string> whole_numbers(long least) {
  std::vector<std::string> all;
  for (long n = std::max(least, 1L); n <= std::max(least, 3L); ++n) all.push_back(std::to_string(n));
  return all;
}

/// Values that a getter takes, as TOML. Numbers are such that most ranges hold one of them.
std::vector<std::string> samples(const ValueForm& form) {
  const std::vector<std::string> numbers =
      form.quantity.unit.empty() ? std::vector<std::string>{"0.25", "2"} : std::vector<std::string>{"1"};
  std::vector<std::string> words;
  switch (form.kind) {
    case ValueKind::number:
      return numbers;
    case ValueKind::any_number:
      return {"1"};
    case ValueKind::integer:
      return whole_numbers(form.least);
    case ValueKind::flag:
      return {"true", "false"};
    case ValueKind::text:
      return {"\"sample\""};
    case ValueKind::choice:
      for (const std::string& word : form.words) words.push_back("\"" + word + "\"");
      return words;
    case ValueKind::choices:
      for (const std::string& word : form.words) words.push_back("[\"" + word + "\"]");
      return words;
    case ValueKind::numbers:
      return lists_of("1", form.count);
    case ValueKind::integers:
      return lists_of(std::to_string(std::max(form.least, 1L)), form.count);
    case ValueKind::points:
      return {"[" + list_of("1", form.count) + "]"};
    case ValueKind::texts:
      return lists_of("\"sample\"", form.count);
    case ValueKind::formula:
      return {"\"0\""};
    case ValueKind::formulas:
      return lists_of("\"0\"", form.count);
    case ValueKind::number_rows:
    case ValueKind::formula_rows:
      return {"[[1]]", "[[1, 0], [0, 1]]"};
    case ValueKind::section:
      return {"{}"};
    case ValueKind::sections:
      return {"[{}]"};
  }
  return {};
}

/// All that are worth a try: of a key of which no getter was called yet, one that no getter takes, to see
/// which one complains.
std::vector<std::string> samples(const KeyNote& key) {
  if (key.forms.empty()) return {"{}", "true"};
  std::vector<std::string> all;
  for (const ValueForm& form : key.forms)
    for (std::string& one : samples(form)) all.push_back(std::move(one));
  return all;
}

/// Says whether there is something at a dotted path.
bool holds(const TomlValue& document, const std::string& path) {
  const TomlValue* at = &document;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    const std::string part = path.substr(from, dot - from);
    from = dot + 1;
    at = !at->is(TomlValue::Kind::array) ? at->find(part) : at->items.empty() ? nullptr : &at->items.front();
    if (at == nullptr) return false;
  }
  return true;
}

/// Sets a value by its dotted path; sections on the way are there.
void set(TomlValue& document, const std::string& path, const TomlValue& value) {
  TomlValue* at = &document;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    const std::string part = path.substr(from, dot - from);
    from = dot + 1;
    if (at->is(TomlValue::Kind::array)) {
      at = &at->items.at(0);
      continue;
    }
    if (!at->find(part)) {
      at->names.push_back(part);
      at->items.emplace_back();
    }
    at = at->find(part);
  }
  *at = value;
}

class Exploration {
 public:
  explicit Exploration(const NotingReader& read) : read_(read) {}

  KeyNotes from(TomlValue first) {
    look_at(first);
    for (open_.push_back(first); !open_.empty(); open_.pop_front()) {
      KeyNotes here;
      reads(open_.front(), here);
      for (const KeyNote& key : here.keys()) vary(key);
    }
    return std::move(notes_);
  }

 private:
  bool reads(const TomlValue& document, KeyNotes& notes) const {
    try {
      read_(document, notes);
    } catch (const InputError&) {
      return false;
    }
    return true;
  }

  /// Reads the document, and puts in what it lacks. True if the reader asked for something new.
  bool look_at(TomlValue& document) {
    const std::size_t before = notes_.extent();
    accepted_ = reads(document, notes_);
    while (!accepted_) {
      const std::string missing = notes_.demanded();
      if (missing.empty() || holds(document, missing)) break;
      set(document, missing, value_of(samples(*notes_.find(missing)).front()));
      ++lacked_;
      accepted_ = reads(document, notes_);
    }
    return notes_.extent() > before;
  }

  /// A section that no document has opened yet belongs to a choice that is still to be made.
  bool stays_shut(const std::string& path, const std::string& sample) const {
    return (sample == "{}" && !notes_.closed(path)) || (sample == "[{}]" && !notes_.closed(path + ".0"));
  }

  void vary(const KeyNote& key) {
    const KeyNote known = *notes_.find(key.path);
    for (const std::string& sample : samples(known)) {
      if (!tried_.insert(key.path + "=" + sample).second && !stays_shut(key.path, sample)) continue;
      TomlValue document = open_.front();
      set(document, key.path, value_of(sample));
      const TomlValue bare = document;
      const std::size_t lacking = lacked_;
      const bool more = look_at(document);
      const bool chosen = accepted_ && sample.starts_with('"');  // other sections may belong to the word
      if (more && lacked_ > lacking) open_.push_back(bare);      // there may be something else to put in
      if (more || chosen) open_.push_back(std::move(document));
    }
  }

  const NotingReader& read_;
  KeyNotes notes_;
  std::deque<TomlValue> open_;
  std::set<std::string> tried_;
  bool accepted_ = false;
  std::size_t lacked_ = 0;  ///< keys that were put in because a reader stopped for them
};

}  // namespace

KeyNotes explored_keys(const std::vector<TomlValue>& first, const NotingReader& read) {
  KeyNotes all;  // each document is a world of its own: other things are new in three dimensions
  for (const TomlValue& document : first) all.add(Exploration(read).from(document));
  return all;
}

}  // namespace plumb
