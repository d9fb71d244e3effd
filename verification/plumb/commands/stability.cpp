#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/output/file.hpp"
#include "lib/scene/readers.hpp"
#include "lib/stability/edge.hpp"
#include "lib/stability/stability_study.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/drawing.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/run/kept_folder.hpp"
#include "verification/plumb/run/kept_trials.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct StabilityOptions {
  std::string study;
  std::vector<std::string> overrides;
  std::string cache = kept_folder("stability").string();
};

/// One place of the map.
struct Cell {
  const Variant* variant;
  std::string over_value;
  Edge edge{};
  std::vector<std::pair<double, Trial>> trials;  ///< in the order of the runs
  bool done = false;
};

/// Everything that decides how a run ends.
std::string content_of(const StabilityStudy& study, const std::vector<std::string>& overrides, double value) {
  std::string content = build_identity() + "\n";
  for (const auto& [key, text] :
       settings_of(parse_document(study.scene, study.file, overrides, scene_alternatives())))
    content.append(key).append(" = ").append(text).append("\n");
  content += fmt::format("bounds {} {}", study.bounds.energy_growth.value_or(-1),
                         study.bounds.hourglass.value_or(-1));
  return content + (study.parameter == EdgeParameter::twist ? fmt::format(" twist {}", value) : "");
}

struct Stopped {};  ///< thrown out of a bisection when a signal asks for the end

class Map {
 public:
  Map(const StabilityStudy& study, ResultStore store) : study_(study), store_(std::move(store)) {
    for (const auto& variant : study.variants)
      for (const auto& value : study.values) cells.push_back({&variant, value, {}, {}, false});
  }

  /// All cells, several at a time; false if a signal came. What is finished is in the cells and in the cache.
  bool make(Progress& progress) {
    const InterruptGuard guard;
    std::exception_ptr problem;  // of the first cell that fails; others look at `failed` only
    std::atomic<bool> failed = false;
    std::atomic<int> finished = 0;
#pragma omp parallel for schedule(dynamic)
    // NOLINTNEXTLINE(modernize-loop-convert): OpenMP shares out indices
    for (std::size_t n = 0; n < cells.size(); ++n) {
      if (interrupted() || failed) continue;
      try {
        fill(cells[n]);
#pragma omp critical
        progress.update(static_cast<double>(++finished) / static_cast<double>(cells.size()),
                        fmt::format("{} of {} edges", finished.load(), cells.size()));
      } catch (const Stopped&) {
        continue;
      } catch (...) {
#pragma omp critical
        if (!failed.exchange(true)) problem = std::current_exception();
      }
    }
    if (problem) std::rethrow_exception(problem);
    return !interrupted();
  }

  std::vector<Cell> cells;

 private:
  void fill(Cell& cell) {
    const auto stable = [&](double value) { return trial(cell, value).stable(); };
    if (study_.parameter == EdgeParameter::stretch) {
      stable(0);
      cell.edge.runs = 1;
    } else {
      cell.edge = find_edge(study_.from, study_.to, study_.tolerance, stable);
    }
    cell.done = true;
  }

  const Trial& trial(Cell& cell, double value) {
    const auto overrides = overrides_of(study_, *cell.variant, cell.over_value, value);
    const std::string content = content_of(study_, overrides, value);
    auto found = find_trial(store_, content);
    if (!found) {
      found = try_scene(varied_scene(study_, overrides, value), study_.bounds, [] { return !interrupted(); });
      if (!found) throw Stopped{};
      if (found->refused.empty()) keep_trial(store_, content, *found);
    }
    return cell.trials.emplace_back(value, *found).second;
  }

  const StabilityStudy& study_;
  ResultStore store_;
};

/// The run that shows how it ends beyond the edge: the one at the least unstable value.
const Trial* beyond(const Cell& cell, EdgeParameter parameter) {
  for (const auto& [value, trial] : cell.trials)
    if (!trial.stable() && (parameter == EdgeParameter::stretch || value == cell.edge.unstable))
      return &trial;
  return nullptr;
}

Json row_of(const Cell& cell, EdgeParameter parameter) {
  const Trial* end = beyond(cell, parameter);
  const bool pulled = parameter == EdgeParameter::stretch, refused = end && !end->cause;
  double cpu = 0;
  for (const auto& [value, trial] : cell.trials) cpu += trial.cpu;
  const double number = cell.over_value.empty() ? NAN : std::strtod(cell.over_value.c_str(), nullptr);
  Json row{
      {"variant", cell.variant->name},
      {"x", cell.over_value.find_first_not_of("0123456789.e-+") == std::string::npos ? Json(number)
                                                                                     : Json(cell.over_value)},
      {"y", pulled ? Json() : Json(cell.edge.unstable)},
      {"limit",
       pulled ? (refused ? Json() : Json(cell.trials.front().second.stretch)) : Json(cell.edge.stable)},
      {"cause", end ? (refused ? Json("refused") : Json(name_of(*end->cause))) : Json()},
      {"time", end && !refused ? Json(end->time) : Json()},
      {"hourglass", refused ? Json() : Json((end ? *end : cell.trials.back().second).hourglass)},
      {"runs", cell.edge.runs},
      {"cpu_s", cpu}};
  if (refused) row["status"] = "refused: " + end->refused;
  for (const char* key : {"y", "limit", "x"})
    if (row[key].is_number() && !std::isfinite(row[key].get<double>())) row[key] = nullptr;
  return row;
}

/// A study of which nothing can be built is bad input. Throws InputError.
void require_some(const std::vector<Cell>& cells) {
  const auto refused = [](const Cell& cell) {
    return cell.done &&
           std::ranges::all_of(cell.trials, [](const auto& t) { return !t.second.refused.empty(); });
  };
  if (std::ranges::all_of(cells, refused))
    throw InputError("no scene of the study can be built", cells.front().trials.front().second.refused, "");
}

/// The largest stable value (or the stretch that was reached) over the other parameter, a line for each variant. Values
/// that are no numbers stand side by side.
reports::Picture edge_picture(const StabilityStudy& study, const std::vector<Cell>& cells) {
  const bool pulled = study.parameter == EdgeParameter::stretch;
  reports::Picture picture;
  picture.title = study.name;
  picture.x = {study.over.empty() ? "variant" : study.over};
  picture.y = {fmt::format("largest {} {}", pulled ? "reached" : "stable", name_of(study.parameter))};
  picture.labels = reports::Labels::legend;
  for (const Variant& variant : study.variants) {
    reports::Series series;
    series.label = variant.name;
    for (const Cell& cell : cells) {
      if (cell.variant != &variant) continue;
      const Json row = row_of(cell, study.parameter);
      if (!row["limit"].is_number()) continue;
      series.x.push_back(row["x"].is_number() ? row["x"].get<double>()
                                              : 1 + static_cast<double>(series.x.size()));
      series.y.push_back(row["limit"].get<double>());
    }
    if (!series.x.empty()) picture.series.push_back(std::move(series));
  }
  return picture;
}

int stability(const Session& session, const StabilityOptions& options) {
  const StabilityStudy study = read_stability_study(options.study, options.overrides);
  if (!options.cache.empty()) {
    require_folder(options.cache, "--cache");
    make_folder(options.cache, "--cache");
  }
  Progress progress(study.name, session.progress());
  Map map(study, ResultStore(options.cache));
  const bool whole = map.make(progress);
  progress.finish();
  require_some(map.cells);
  Json rows = Json::array();
  for (const auto& cell : map.cells)
    if (cell.done) rows.push_back(row_of(cell, study.parameter));
  session.write_table(rows);
  if (!whole) session.text() << "interrupted\n";
  if (!options.cache.empty())
    session.text() << "finished runs are kept in " << options.cache << " and will not be run again\n";
  const bool pulled = study.parameter == EdgeParameter::stretch;
  session.write_json(
      {{"study", study.name},
       {"parameter", name_of(study.parameter)},
       {"x_name", study.over.empty() ? Json() : Json(study.over)},
       {"y_name", pulled ? Json() : Json(fmt::format("least unstable {}", name_of(study.parameter)))},
       {"limit_name", fmt::format("largest {} {}", pulled ? "reached" : "stable", name_of(study.parameter))},
       {"over", study.over},
       {"from", study.from},
       {"to", study.to},
       {"tolerance", study.tolerance},
       {"bounds",
        {{"energy_growth", study.bounds.energy_growth ? Json(*study.bounds.energy_growth) : Json()},
         {"hourglass", study.bounds.hourglass ? Json(*study.bounds.hourglass) : Json()}}},
       {"status", whole ? "completed" : "interrupted"},
       {"rows", rows}});
  if (whole) draw(session, edge_picture(study, map.cells));
  return whole ? 0 : interrupt_exit_code();
}

}  // namespace

/// `plumb stability STUDY.toml`: the edge of stability of one parameter over a second one.
void add_stability(CLI::App& program, Session& session) {
  const auto options = std::make_shared<StabilityOptions>();
  CLI::App& command = add_command(
      program, session,
      {"stability", "bisects a parameter to the edge of stability, over a second one",
       "plumb stability verification/stability/small-motion.toml"},
      {.table = true, .plot = true}, [&session, options] { return stability(session, *options); });
  command.add_option("STUDY", options->study, "the study file (.toml)")->required()->type_name("FILE");
  command.add_option("--set", options->overrides, "change one value of the study; may be repeated")
      ->type_name("section.key=value");
  command
      .add_option("--cache", options->cache,
                  "folder of finished runs; empty: none is kept (" + kept_folder_text("stability") + ")")
      ->type_name("DIR");
}

}  // namespace plumb::app
