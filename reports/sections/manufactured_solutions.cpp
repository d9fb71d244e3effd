#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::manufactured_solutions {
namespace {

using Json = nlohmann::ordered_json;

const std::string folder = "verification/studies/";
const std::string clipped = "mms-vortex-clipped";

std::vector<Refinement> others() {
  return {{"mms-vortex", "vortex, A = 0.5, rings", "generalized_vortex.toml", {}},
          {clipped, "vortex, A = 0.5, clipped lattice", "generalized_vortex.toml", {"body.layout=cell"}},
          {"mms-vortex-full", "vortex, A = 1, rings", "generalized_vortex_full.toml", {}},
          {"mms-cube", "cube on rollers, 3D, A = 0.01 m", "trigonometric_cube.toml", {}},
          {"mms-cube-large",
           "cube on rollers, 3D, A = 0.2 m",
           "trigonometric_cube.toml",
           {"study.parameters.amplitude=0.2"}},
          {"mms-column", "column under tractions", "stretched_column.toml", {}}};
}

/// The full vortex with what was tried to let it run at the step of the other studies, and with smaller ones.
std::vector<Refinement> broken() {
  const std::string file = "generalized_vortex_full.toml", step = "method.cfl=0.5";
  return {{"mms-break-plain", "β = 0.9, CFL 0.5", file, {step}},
          {"mms-break-wide", "β = 1.2, CFL 0.5", file, {step, "method.beta=1.2"}},
          {"mms-break-hourglass", "hourglass energy 2, CFL 0.5", file, {step, "hourglass.alpha=2"}},
          {"mms-break-compatible", "compatible table, CFL 0.5", file, {step, "method.gradient=compatible"}},
          {"mms-break-quarter", "β = 0.9, CFL 0.25", file, {"method.cfl=0.25"}},
          {"mms-break-stretch",
           "wave speed C_p / least stretch, CFL 0.5",
           file,
           {step, "method.wave_speed=stretch-inverse"}}};
}

Job temporal_job() {
  const std::string file = folder + "time_step_plate.toml";
  return {"mms-time", {"mms", file, "--temporal"}, {file}};
}

Figure time_figure(const Json& time) {
  Figure figure{"mms-time",
                {"Error of the time steps",
                 {"time step", "s", Scale::log},
                 {"L₂ difference to the fine-step run", text(time.at("units"), "l2"), Scale::log}},
                "One cloud, d = 0.2 m; the reference is RK3 with a quarter of the finest step.",
                {"mms-time"}};
  figure.picture.labels = Labels::legend;
  for (const auto& fit : time.at("fits")) {
    figure.picture.series.push_back(
        series_of(time.at("rows"), {{"integrator", text(fit, "integrator")}}, "dt", "l2",
                  fmt::format("{}: order {:.2f}", text(fit, "integrator"), number(fit, "order"))));
  }
  figure.picture.lines.push_back({number(time, "spatial_error"), "error in space"});
  return figure;
}

/// Runs that break, level by level, and the smaller steps with which they do not.
DataTable broken_table(const Results& results) {
  DataTable table{"mms-broken",
                  "Vortex, A = 1 rad, free circles: which runs break",
                  {{"scheme"}, {"d", "m", 3}, {"steps", "", 0}, {"relative L₂ error", "", 3}, {"outcome"}},
                  {}};
  auto all = broken();
  all.push_back({"mms-vortex-full", "β = 0.9, CFL 0.1", {}, {}});
  for (const auto& entry : all) {
    const Json result = results.json(entry.id);
    for (const auto& level : result.at("levels")) {
      const auto status = level.find("status");
      const Json& error = level.at("relative_l2");
      table.rows.push_back({entry.name, number(level, "d"), number(level, "steps"),
                            error.is_number() ? Entry(error.get<double>()) : Entry(),
                            status == level.end() ? "completed" : status->get<std::string>()});
    }
    table.jobs.push_back(entry.id);
  }
  return table;
}

Section write(const Results& results) {
  Section s;
  s.question = "At which order does each solution converge, in space and in time?";
  DataTable fits = fits_table("mms-fits", "Fitted orders", {}),
            levels = levels_table("mms-levels", "All levels", {});
  std::size_t met = 0, declared = 0;
  for (const auto& entry : others()) {
    const Json result = results.json(entry.id);
    add_fits(fits, entry.name, entry.id, result, "mms-others");
    add_levels(levels, entry.name, entry.id, result);
    if (entry.id == clipped) continue;      // listed with its order and the reason: nothing is claimed of it
    if (!declares(result, "l2")) continue;  // an order to read, not to judge
    s.checks.push_back(study_check("L₂ order, " + entry.name, result, "l2"));
    ++declared;
    met += s.checks.back().verdict == "pass" ? 1 : 0;
  }
  const Json time = results.json("mms-time");
  for (const auto& fit : time.at("fits"))
    s.checks.push_back({"order in time, " + text(fit, "integrator"),
                        fmt::format("{:g}", number(fit, "declared")),
                        fmt::format("{:.3f}", number(fit, "order")), text(fit, "verdict")});
  s.figures = {levels_figure(results, "mms-others", "Vortex, cube and column", others(),
                             "Errors at the end time of each study file."),
               orders_figure("mms-orders", "Orders in L₂", fits, "l2"), time_figure(time)};
  s.tables = {broken_table(results), fits, levels};
  s.answer = fmt::format("{} of {} solutions with natural edges of which an order in L₂ is declared meet it.",
                         met, declared);
  s.notes = {
      fmt::format(
          "The cells of the clipped lattice of the vortex are cut by the circles. Nothing is declared of "
          "it; its order in L₂ was {}.",
          study_check("", results.json(clipped), "l2").measured),
      "At A = 1 rad the fastest wave of the exact state, from the acoustic tensor of (4.3), is many times "
      "faster than C_p, which the time step (31) takes with the smallest distance; the study [vortex] "
      "measures it. The table of broken runs shows which steps are too long for it.",
      "Orders of relative errors are those of the absolute ones: the exact field's norm does not change with "
      "d but by its quadrature.",
      "The column has corners where a held face meets a loaded one: see its order in H1."};
  return s;
}

}  // namespace

/// Refinement of every manufactured solution that is no patch, and the order in time.
SectionPlan planned(Extent) {
  SectionPlan plan{320, "mms", "Manufactured solutions: orders", {}, write};
  for (const auto& entry : others()) plan.jobs.push_back(refinement_job(entry));
  for (const auto& entry : broken()) plan.jobs.push_back(refinement_job(entry));
  plan.jobs.push_back(temporal_job());
  return plan;
}

}  // namespace plumb::reports::sections::manufactured_solutions
