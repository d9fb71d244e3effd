#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/comparison/advice.hpp"
#include "reports/comparison/steps.hpp"
#include "tests/support/temporary_folder.hpp"

/// A small table of schemes and problems, with results whose answers can be found by hand.
namespace plumb::side_by_side_tests {

using test::TemporaryFolder;
using namespace reports;
using namespace reports::comparison;
using Json = nlohmann::ordered_json;

inline const std::string schemes = R"(
[[scheme]]
id = "x-printed"
name = "x, printed"
paper = "003"
printed = true
set = ["method.paper=003"]
[[scheme]]
id = "x"
name = "x, mended"
paper = "003"
set = ["method.scheme=mixed"]
[[scheme]]
id = "element"
name = "elements"
paper = "elements"
)";

inline const std::string plate = R"(
[[problem]]
id = "plate"
title = "Plate"
asks = "a plate"
study = "plate.toml"
set = ["material.poisson=0.4"]
spacings = [0.2, 0.1]
long_spacings = [0.05]
quantity = "error"
source = "exact"
equal_error = 0.2
[[problem.cell]]
schemes = ["x"]
set = ["mixed.upwind=none"]
within = 0.5
)";

inline const std::string bar = R"(
[[problem]]
id = "bar"
title = "Bar"
asks = "a bar"
scene = "bar.toml"
spacings = [0.5, 0.25]
quantity = "place of the tip"
at = ["/probes/tip/position/0", "/probes/tip/position/1"]
truth = [1, 2]
scale = 10
source = "by hand"
equal_error = 0.2
free = true
beside = "plate"
[[problem.cell]]
schemes = ["x-printed"]
refuses = "has no bars"
[[problem.cell]]
schemes = ["x"]
set = ["implicit.dynamics=midpoint"]
over_spacing = { "implicit.time_step" = 0.01 }
)";

inline Table table(Extent extent = Extent::full) {
  return read_table(schemes + plate + bar, "table.toml", extent);
}

/// Results in a folder, as the report's jobs leave them.
class Given {
 public:
  void add(const std::string& id, const Json& json, const std::string& series = "time [s]\n0\n") {
    const auto place = folder / id;
    std::filesystem::create_directories(place);
    std::ofstream(place / "result.json") << json.dump();
    std::ofstream(place / "series.csv") << series;
    JobResult job;
    job.folder = place;
    job.peak_rss = 3e7;
    results.add(id, job);
  }
  void refuse(const std::string& id, const std::string& words) {
    JobResult job;
    job.exit_code = 2;
    job.failure = "exit code 2: plumb: " + words;
    results.add(id, job);
  }
  TemporaryFolder folder;
  Results results;
};

inline Json study(const std::vector<std::pair<double, double>>& errors_and_times) {
  Json levels = Json::array();
  double d = 0.2;
  for (const auto& [error, time] : errors_and_times) {
    levels.push_back({{"d", d}, {"relative_l2", error}, {"cpu_s", time}, {"steps", 7}});
    d /= 2;
  }
  return {{"levels", levels}};
}

inline Json run(double x, double y, double cpu_s, double drift = 1e-16) {
  return {{"status", "completed"},
          {"steps", 40},
          {"probes", {{"tip", {{"position", {x, y}}}}}},
          {"memory", {{"bytes_per_particle", 100}}},
          {"linear_drift", 2e-16},
          {"angular_drift", drift},
          {"energy",
           {{"total", 90.0},
            {"initial", 100.0},
            {"dissipated", 4.0},
            {"load_work", 1.0},
            {"damping_work", -2.0},
            {"support_work", nullptr},
            {"terms", {{"hourglass", 3.0}, {"plastic work", 20.0}, {"bonds", 2.0}}}}},
          {"failure", nullptr},
          {"timing", {{"cpu_s", cpu_s}}}};
}

/// Everything of `table()`: x halves its error from 0.4 to 0.1 in four times the time, as printed it has more.
inline void fill(Given& given) {
  given.add("five-plate-x-printed", study({{0.8, 1}, {0.4, 2}}));
  given.add("five-plate-x", study({{0.4, 1}, {0.1, 4}}));
  given.add("five-plate-element", study({{0.1, 0.5}, {0.05, 3}}));
  given.refuse("five-bar-x-printed-1", "the scheme has no bars. Use another.");
  given.add("five-bar-x-1", run(4, 6, 1));  // 3, 4 away: 0.5
  given.add("five-bar-x-2", run(1, 2.5, 3, 1e-5));
  given.add("five-bar-element-1", run(1, 3, 2));
  given.add("five-bar-element-2", run(1, 2, 6, 1e-15));
}

inline Outcome with(const std::vector<std::pair<std::optional<double>, double>>& errors_and_times) {
  Outcome outcome;
  double d = 1;
  for (const auto& [error, time] : errors_and_times) outcome.levels.push_back({d /= 2, error, time, {}});
  return outcome;
}

/// Results of every job of a table, as it declares them: refused, broken, or the same numbers for all.
inline void invent(const Table& all, Given& given) {
  for (const auto& problem : all.problems)
    for (const auto& scheme : all.schemes) {
      const Cell cell = problem.cell(scheme.id);
      for (const auto& job : jobs_of(problem, scheme)) {
        if (!cell.refuses.empty()) {
          given.refuse(job.id, "a scheme " + cell.refuses + ". It has none.");
          continue;
        }
        if (problem.study) {
          given.add(job.id, study({{0.4, 1}, {0.1, 2}, {0.02, 4}, {1e-4, 8}}));
          continue;
        }
        Json result = run(1, 1, 2);
        result["probes"]["tip"]["displacement"] = {0, 1};
        result["probes"]["corner"] = result["probes"]["side of the foot"] = result["probes"]["tip"];
        if (cell.breaks) {
          result["status"] = "unstable";
          result["failure"] = {{"cause", "inverted"}, {"time", 0.125}};
        }
        given.add(job.id, result,
                  "time [s],tip displacement x [m],tip displacement y [m],tip displacement z [m]\n0,0,0,0\n"
                  "0.1,0.1,1,0.1\n0.2,0.1,-1,0.1\n");
      }
    }
  if (!all.ladder) return;
  for (const auto& scheme : all.schemes)
    for (const auto& job : jobs_of(*all.ladder, scheme)) {
      Json result = run(1, 1, 1);
      result["dt"] = {{"first", 1e-3}};
      result["energy"]["relative_change"] = -0.01;
      given.add(job.id, result);
    }
}

}  // namespace plumb::side_by_side_tests
