#include "lib/output/sitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "lib/output/file.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
/// If the program is killed, so much work is lost beside the part at hand. A write costs some milliseconds.
constexpr std::chrono::milliseconds at_most_lost{250};
/// A listener is told no oftener from inside a part: putting a note together takes longer than a small step.
constexpr std::chrono::milliseconds at_most_silent{50};

}  // namespace

std::string name_of_content(const std::string& text) {
  return to_string(boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text));
}

double number_or_nan(const Sitting::Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Sitting::Sitting(const fs::path& folder, std::string content, std::function<bool()> go_on)
    : content_(std::move(content)), go_on_(std::move(go_on)) {
  if (folder.empty()) return;
  file_ = folder / (name_of_content(content_) + ".json");
  std::ifstream in(file_);
  const Json kept = Json::parse(in, nullptr, false);
  const bool ours = kept.is_object() && kept.contains("parts") && kept.value("content", Json()) == content_;
  if (!ours) return;  // none, or damaged
  for (const auto& [name, part] : kept["parts"].items()) parts_[name] = part.dump();
}

void Sitting::tell(double whole, Listener listener, std::string unit) {
  work_ = {std::move(listener), std::move(unit), "", whole, 0, 0, 0, 0, {}};
}

Sitting::Json Sitting::part(const std::string& name, const std::function<Json()>& make, double work) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = parts_.find(name); found != parts_.end()) {
      ++recalled_;
      work_.whole -= work;
      return Json::parse(found->second);
    }
  }
  check();
  return make_part(name, make, work);
}

Sitting::Json Sitting::make_part(const std::string& name, const std::function<Json()>& make, double work) {
  {
    const std::lock_guard lock(mutex_);
    work_.part = name;
    work_.at_hand = work;
    work_.done = work_.rate = 0;
  }
  Json made = make();
  const std::lock_guard lock(mutex_);
  parts_[name] = made.dump();
  work_.made += work;
  work_.at_hand = 0;
  say();
  if (std::chrono::steady_clock::now() - saved_ > at_most_lost) try_to_save();
  return made;
}

void Sitting::say() {
  if (!work_.listener || !(work_.whole > 0)) return;
  const double made = work_.made + work_.done * work_.at_hand;
  const std::string rate =
      work_.rate > 0 ? fmt::format(", {:.2g} {}/s", work_.rate, work_.unit) : std::string();
  work_.listener(std::min(1.0, made / work_.whole), work_.part + rate);
  work_.said = std::chrono::steady_clock::now();
}

void Sitting::check(double done, double rate) {
  if (!go_on_ || go_on_()) {
    if (!(done > 0)) return;
    const std::lock_guard lock(mutex_);
    work_.done = std::clamp(done, work_.done, 1.0);  // a part of two runs goes through its share once
    work_.rate = rate;
    if (std::chrono::steady_clock::now() - work_.said > at_most_silent) say();
    return;
  }
  const std::lock_guard lock(mutex_);
  if (!parts_.empty()) try_to_save();
  if (parts_.empty() || file_.empty()) throw SittingEnded("interrupted: nothing was kept");
  if (!problem_.empty()) throw SittingEnded("interrupted: what was finished is lost, " + problem_);
  throw SittingEnded(
      fmt::format("interrupted: {} finished parts are kept in {}; the same call goes on from there",
                  parts_.size(), file_.string()));
}

void Sitting::try_to_save() {
  if (file_.empty()) return;
  saved_ = std::chrono::steady_clock::now();
  try {
    make_folder(file_.parent_path(), "unfinished studies");
    Json whole{{"content", content_}, {"parts", Json::object()}};
    for (const auto& [name, part] : parts_) whole["parts"][name] = Json::parse(part);
    replace_file(file_, whole.dump() + "\n");
    problem_.clear();
  } catch (const std::exception& error) {  // no reason to give up the study
    problem_ = error.what();
  }
}

void Sitting::close() {
  if (file_.empty()) return;
  std::error_code none;  // nothing was kept, or somebody else uses the folder: both are fine
  fs::remove(file_, none);
  fs::remove(file_.parent_path(), none);
}

}  // namespace plumb
