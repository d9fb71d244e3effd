#include "verification/plumb/run/trial_cache.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "lib/output/file.hpp"
#include "lib/output/json.hpp"
#include "lib/output/sitting.hpp"

namespace plumb::app {
namespace {

std::optional<Cause> cause_named(const std::string& name) {
  for (const Cause cause : {Cause::non_finite, Cause::inverted, Cause::energy_growth,
                            Cause::time_step_collapse, Cause::hourglass})
    if (name == name_of(cause)) return cause;
  return std::nullopt;
}

}  // namespace

std::filesystem::path TrialCache::file_of(const std::string& content) const {
  return folder_ / (name_of_content(content) + ".json");
}

std::optional<Trial> TrialCache::find(const std::string& content) const {
  if (folder_.empty()) return std::nullopt;
  std::ifstream in(file_of(content));
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (json.is_discarded() || json.value("run", "") != content)
    return std::nullopt;  // none, or the part of one
  return Trial{cause_named(json["cause"].get<std::string>()),
               json["time"],
               json["steps"],
               json["stretch"],
               json["hourglass"].is_null() ? 0 : json["hourglass"].get<double>(),
               json["energy"].is_null() ? 0 : json["energy"].get<double>(),
               json["cpu_s"]};
}

void TrialCache::keep(const std::string& content, const Trial& trial) const {
  if (folder_.empty()) return;
  const nlohmann::ordered_json json{
      {"run", content},           {"cause", trial.cause ? std::string(name_of(*trial.cause)) : "stable"},
      {"time", trial.time},       {"steps", trial.steps},
      {"stretch", trial.stretch}, {"hourglass", trial.hourglass},
      {"energy", trial.energy},   {"cpu_s", trial.cpu}};
  replace_file(file_of(content), json.dump(1) + "\n");
}

}  // namespace plumb::app
