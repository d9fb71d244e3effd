#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/order_fit.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::solver_scaling {
namespace {

using Json = nlohmann::ordered_json;

/// A way to the equilibrium of one cantilever.
struct Way {
  std::string id, name, file;
  std::vector<std::string> set;
  double exact;  ///< its tip may differ by that share from that of factors
};

std::vector<Way> ways() {
  const std::string newton = "verification/scenes/cantilever.toml";
  return {
      {"direct", "Newton's method, factors", newton, {"implicit.solver=direct"}, 0},
      {"iterative",
       "Newton's method, conjugate gradients on two levels",
       newton,
       {"implicit.solver=iterative"},
       1e-8},
      {"paper-004",
       "the same with the table of paper 004",
       newton,
       {"implicit.solver=iterative", R"(method.paper="004")"},
       1},
      {"relaxed", "explicit steps with damping", "verification/scenes/cantilever-relaxed.toml", {}, 1e-3}};
}

/// Spacings of 595, 1750 and 3861 particles, and of 12103.
std::vector<std::string> spacings(bool long_run) {
  std::vector<std::string> all{"0.5", "0.3333333333333333", "0.25"};
  if (long_run) all.emplace_back("0.16666666666666666");
  return all;
}

std::string id_of(const Way& way, const std::string& spacing) {
  return fmt::format("scaling-{}-{}", way.id, spacing.substr(2, 2));
}

double tip_of(const Json& result) {
  return result.at("probes").at("tip").at("displacement").at(1).get<double>();
}

double cost_of(const Json& result) {
  return number(result.at("timing"), "cpu_s");
}

DataTable runs_table(const Results& results, const std::vector<std::string>& sizes) {
  DataTable table{"scaling-runs",
                  "Cost of one equilibrium",
                  {{"way"},
                   {"particles", "", 0},
                   {"set-up", "s", 3},
                   {"CPU time", "s", 3},
                   {"peak memory", "MB", 3},
                   {"tip", "m", 7}},
                  {}};
  for (const Way& way : ways())
    for (const auto& spacing : sizes) {
      const Json result = results.json(id_of(way, spacing));
      table.rows.push_back({way.name, number(result, "particles"), number(result.at("timing"), "setup_s"),
                            cost_of(result), 1e-6 * number(result.at("memory"), "peak_rss"), tip_of(result)});
      table.row_jobs.push_back(id_of(way, spacing));
    }
  return table;
}

const char* const cube = "verification/scenes/sheared-cube.toml";

/// Spacings of the cube: 729 and 9261 particles, and 97336.
std::vector<std::string> spacings_of_cube(bool long_run) {
  std::vector<std::string> all{"0.125", "0.05"};
  if (long_run) all.emplace_back("0.0222222222222222");
  return all;
}

std::string cube_id(const std::string& spacing) {
  return "scaling-cube-" + spacing.substr(2, 3);
}

/// Irregular particles, compatible bonds and hourglass energy, conjugate gradients.
DataTable cube_table(const Results& results, bool long_run) {
  DataTable table{
      "scaling-cube",
      "Sheared cube of irregular particles, compatible bonds with hourglass energy, conjugate gradients "
      "on two levels",
      {{"particles", "", 0}, {"set-up", "s", 3}, {"CPU time", "s", 3}, {"peak memory", "MB", 3}},
      {}};
  for (const auto& spacing : spacings_of_cube(long_run)) {
    const Json result = results.json(cube_id(spacing));
    table.rows.push_back({number(result, "particles"), number(result.at("timing"), "setup_s"),
                          cost_of(result), 1e-6 * number(result.at("memory"), "peak_rss")});
    table.row_jobs.push_back(cube_id(spacing));
    table.jobs.push_back(cube_id(spacing));
  }
  return table;
}

/// The exponent of the particles in the cost.
DataTable growth_table(const Results& results, const std::vector<std::string>& sizes) {
  DataTable table{"scaling-growth",
                  "Growth of the cost with the number of particles, N to the power",
                  {{"way"}, {"power", "", 3}, {"95 % interval"}, {"levels", "", 0}},
                  {}};
  for (const Way& way : ways()) {
    std::vector<Level> levels;
    for (const auto& spacing : sizes) {
      const Json result = results.json(id_of(way, spacing));
      levels.push_back({number(result, "particles"), cost_of(result)});
      table.jobs.push_back(id_of(way, spacing));
    }
    const OrderFit fit = fit_order(levels);
    table.rows.push_back({way.name, fit.order, fmt::format("[{:.2f}, {:.2f}]", fit.lower, fit.upper),
                          static_cast<double>(levels.size())});
  }
  return table;
}

Figure cost_figure(const Results& results, const std::vector<std::string>& sizes) {
  Picture picture{"Cost of one equilibrium", {"particles", "", Scale::log}, {"CPU time", "s", Scale::log}};
  picture.labels = Labels::legend;
  std::vector<std::string> jobs;
  for (const Way& way : ways()) {
    Series series{way.name, {}, {}};
    for (const auto& spacing : sizes) {
      const Json result = results.json(id_of(way, spacing));
      series.x.push_back(number(result, "particles"));
      series.y.push_back(cost_of(result));
      jobs.push_back(id_of(way, spacing));
    }
    picture.series.push_back(series);
  }
  return {"scaling-cost", picture, "Cantilever of paper 004, linear elasticity, one load step.", jobs};
}

Section write(const Results& results, bool long_run) {
  const auto sizes = spacings(long_run);
  Section s;
  s.question = "What does an equilibrium cost as the body grows?";
  s.figures = {cost_figure(results, sizes)};
  s.tables = {runs_table(results, sizes), growth_table(results, sizes), cube_table(results, long_run)};
  const auto cost = [&](const char* id) {
    return cost_of(results.json(id_of(by_id(ways(), id), sizes.back())));
  };
  s.answer = fmt::format(
      "On {:.0f} particles factors take {:.2g} s, conjugate gradients {:.2g} s and explicit steps {:.2g} s.",
      number(results.json(id_of(by_id(ways(), "direct"), sizes.back())), "particles"), cost("direct"),
      cost("iterative"), cost("relaxed"));
  for (const char* id : {"iterative", "relaxed"})
    for (const auto& spacing : sizes) {
      const Way way = by_id(ways(), id);
      const double factors = tip_of(results.json(id_of(by_id(ways(), "direct"), spacing))),
                   found = tip_of(results.json(id_of(way, spacing)));
      s.checks.push_back({fmt::format("{}, d = {:.3g} m: the tip", way.name, std::stod(spacing)),
                          fmt::format("that of factors within {:g}", way.exact),
                          fmt::format("{:.8g} m for {:.8g} m", found, factors),
                          pass_if(std::abs(found - factors) <= way.exact * std::abs(factors)),
                          id_of(way, spacing)});
    }
  s.notes = {
      "The cube takes 9 iterations to 1e-8 at 9261 and at 97336 particles (a long test).",
      "Set-up, which is making the table of bonds, is not in the CPU time; matrices between particles, factors and levels are.",
      "Explicit steps end when the residual is a hundred-thousandth of the forces: their tip has four digits, that of Newton's method nine."};
  return s;
}

}  // namespace

/// Factors, conjugate gradients and explicit relaxation on one cantilever.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{
      508, "solver-scaling", "What an equilibrium costs", {}, [long_run](const Results& results) {
        return write(results, long_run);
      }};
  for (const Way& way : ways())
    for (const auto& spacing : spacings(long_run)) {
      Job job{id_of(way, spacing),
              {"run", way.file, "--out", "{out}", "--set", "body.spacing=" + spacing},
              {way.file}};
      for (const auto& set : way.set) job.arguments.insert(job.arguments.end(), {"--set", set});
      plan.jobs.push_back(std::move(job));
    }
  for (const auto& spacing : spacings_of_cube(long_run))
    plan.jobs.push_back(
        {cube_id(spacing), {"run", cube, "--out", "{out}", "--set", "body.spacing=" + spacing}, {cube}});
  return plan;
}

}  // namespace plumb::reports::sections::solver_scaling
