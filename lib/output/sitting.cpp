#include "lib/output/sitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace plumb {
namespace {

namespace fs = std::filesystem;
/// If the program is killed, so much work is lost beside the part at hand. A write costs some milliseconds.
constexpr std::chrono::milliseconds at_most_lost{250};
/// A listener is told no oftener from inside a part: putting a note together takes longer than a small step.
constexpr std::chrono::milliseconds at_most_silent{50};

}  // namespace

double number_or_nan(const Sitting::Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Sitting::Sitting(const fs::path& folder, std::string content, std::function<bool()> go_on)
    : store_(folder), content_(std::move(content)), go_on_(std::move(go_on)) {
  const auto kept = store_.find(content_);
  if (!kept) return;
  const Json parts = Json::parse(*kept);
  for (const auto& [name, part] : parts.items()) parts_[name] = part.dump();
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
  if (parts_.empty() || !store_.keeps()) throw SittingEnded("interrupted: nothing was kept");
  if (!problem_.empty()) throw SittingEnded("interrupted: what was finished is lost, " + problem_);
  throw SittingEnded(
      fmt::format("interrupted: {} finished parts are kept in {}; the same call goes on from there",
                  parts_.size(), store_.file_of(content_).string()));
}

void Sitting::try_to_save() {
  if (!store_.keeps()) return;
  saved_ = std::chrono::steady_clock::now();
  try {
    Json whole = Json::object();
    for (const auto& [name, part] : parts_) whole[name] = Json::parse(part);
    store_.keep(content_, whole.dump(), "unfinished studies");
    problem_.clear();
  } catch (const std::exception& error) {  // no reason to give up the study
    problem_ = error.what();
  }
}

void Sitting::close() {
  store_.remove(content_);
}

}  // namespace plumb
