#include "verification/plumb/run/kept_trials.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lib/output/sitting.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Visits the numbers of a trial by name.
void for_each_number(auto&& trial, auto&& visit) {
  visit("time", trial.time);
  visit("stretch", trial.stretch);
  visit("hourglass", trial.hourglass);
  visit("energy", trial.energy);
  visit("cpu_s", trial.cpu);
}

}  // namespace

std::optional<Trial> find_trial(const ResultStore& store, const std::string& content) {
  const auto kept = store.find(content);
  if (!kept) return std::nullopt;
  const Json json = Json::parse(*kept);
  Trial trial;
  for_each_number(trial, [&](const char* name, double& value) { value = number_or_nan(json.at(name)); });
  trial.steps = json.at("steps");
  if (!json.at("cause").is_null()) trial.cause = cause_named(json.at("cause").get<std::string>());
  return trial;
}

void keep_trial(const ResultStore& store, const std::string& content, const Trial& trial) {
  Json json;
  for_each_number(trial, [&](const char* name, double value) { json[name] = value; });
  json["steps"] = trial.steps;
  json["cause"] = trial.cause ? Json(std::string(name_of(*trial.cause))) : Json();
  store.keep(content, json.dump(), "--cache");
}

}  // namespace plumb::app
