#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "lib/output/table.hpp"
#include "reports/picture.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/foreign/compare_runs.hpp"
#include "verification/plumb/optional_json.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::string a, b;
  PointOptions points;
  std::optional<double> within;
};

void draw_differences(const Session& session, const std::vector<Difference>& all, double size) {
  reports::Picture picture;
  picture.title = "difference over the largest displacement";
  picture.x = {"time", "s"};
  picture.y = {"relative L2 difference", "", reports::Scale::log};
  reports::Series series{"displacement", {}, {}};
  for (const Difference& one : all) {
    if (!one.time || !(one.l2 > 0)) continue;
    series.x.push_back(*one.time);
    series.y.push_back(one.l2 / size);
  }
  if (series.x.empty()) return session.warn("there is no difference to draw");
  picture.series.push_back(series);
  for (const auto& dropped : reports::save(picture, session.plot))
    session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
}

int compare_action(const Session& session, const CompareOptions& options) {
  const std::vector<Difference> all = compare_runs(options.a, options.b, options.points);
  double size = 0, largest = 0;
  for (const Difference& one : all) size = std::max(size, one.size), largest = std::max(largest, one.l2);
  const std::optional<double> relative = size > 0 ? std::optional(largest / size) : std::nullopt;
  Json rows = Json::array();
  for (const Difference& one : all)
    rows.push_back({{"time", optional_json(one.time)},
                    {"l2", one.l2},
                    {"relative_l2", size > 0 ? Json(one.l2 / size) : Json()},
                    {"linf", one.linf},
                    {"velocity_l2", optional_json(one.velocity_l2)},
                    {"points", one.points},
                    {"same_points", one.same_points},
                    {"interpolated_in_time", one.between}});
  session.write_table(rows);
  std::string status = "completed";
  if (options.within) {
    const bool passed = relative ? *relative <= *options.within : largest == 0;
    status = passed ? "pass" : "fail";
  }
  session.text() << fmt::format(
      "largest difference: {:.4g}{}\n", largest,
      relative ? fmt::format(", {:.4g} of the largest displacement", *relative) : "");
  if (options.within) session.text() << "status: " << status << '\n';
  session.write_json({{"a", options.a},
                      {"b", options.b},
                      {"largest_l2", largest},
                      {"largest_relative_l2", optional_json(relative)},
                      {"rows", rows},
                      {"status", status}});
  if (!session.plot.empty()) draw_differences(session, all, size > 0 ? size : 1);
  return status == "fail" ? 1 : 0;
}

}  // namespace

/// `plumb compare`: how far two runs are from each other.
void add_compare(CLI::App& program, Session& session) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App& command = add_command(
      program, session,
      {"compare", "difference of two runs, own or of other programs, on common times and points",
       "plumb compare verification/campaigns/first.csv verification/campaigns/second.csv --within 0.01"},
      {.table = true, .plot = true}, [&session, options] { return compare_action(session, *options); });
  command
      .add_option("a", options->a,
                  "the first run: its folder (.pvd, .vtp or .vtu files), "
                  "or one file (.vtp, .vtu, .csv or a LAMMPS dump)")
      ->type_name("A")
      ->required();
  command
      .add_option("b", options->b,
                  "the second run, likewise; it is interpolated to the times and points of the first")
      ->type_name("B")
      ->required();
  command
      .add_option("--within", options->within,
                  "passes if no relative L2 difference is larger; exit code 1 else")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--positions", options->points.positions,
                  "whether positions are those of the body at rest or those of now "
                  "(default: current in .vtp and dumps, reference in .vtu and .csv)")
      ->check(CLI::IsMember({"reference", "current"}));
}

}  // namespace plumb::app
