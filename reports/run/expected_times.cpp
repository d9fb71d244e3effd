#include "reports/run/expected_times.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lib/output/file.hpp"
#include "lib/output/json.hpp"

namespace plumb::reports::run {
namespace {

/// Reading a stored result takes some time too; and no study takes none [s].
constexpr double least = 0.01;

}  // namespace

ExpectedTimes::ExpectedTimes(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream in(file_);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return;
  for (const auto& [name, value] : json.items())
    if (value.is_number()) seconds_[name] = value.get<double>();
}

double ExpectedTimes::weight_of(const std::string& name) const {
  const auto known = seconds_.find(name);
  if (known != seconds_.end()) return std::max(known->second, least);
  if (seconds_.empty()) return 1;
  double sum = 0;
  for (const auto& entry : seconds_) sum += entry.second;
  return std::max(sum / static_cast<double>(seconds_.size()), least);
}

void ExpectedTimes::plan(const std::vector<std::string>& all, const std::vector<std::string>& stored) {
  for (const auto& name : all) {
    const bool is_stored = std::find(stored.begin(), stored.end(), name) != stored.end();
    weights_[name] = is_stored ? least : weight_of(name);
    total_ += weights_[name];
  }
}

void ExpectedTimes::finished(const std::string& name, std::optional<double> cpu_s) {
  const auto planned = weights_.find(name);
  if (planned != weights_.end()) {
    done_ += planned->second;
    planned->second = 0;  // once
  }
  if (cpu_s) seconds_[name] = *cpu_s;
}

double ExpectedTimes::fraction() const {
  return total_ > 0 ? std::min(done_ / total_, 1.0) : 0;
}

void ExpectedTimes::save() const {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : seconds_) json[name] = value;
  replace_file(file_, json_text(json));
}

}  // namespace plumb::reports::run
