#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/named.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::work_precision {
namespace {

using Json = nlohmann::ordered_json;

const std::string file = "verification/studies/swinging_plate_finite_strain.toml";

/// One comparison: what it varies, everything else being the default scheme.
struct Comparison {
  std::string id, title;
  std::vector<std::string> vary;
};

std::vector<Comparison> comparisons() {
  return {
      {"work-forms",
       "Estimators, momentum forms, kernel pairs",
       {"method.gradient=standard,improved,compatible", "method.momentum=adjoint,symmetrised",
        "method.pair=W1,W0"}},
      {"work-kernels",
       "Kernels and supports",
       {"method.kernel=cubic,wendland-c2,quintic", "method.beta=0.6,0.9,1.2"}},
      {"work-time", "Integrators and steps", {"method.integrator=verlet,rk3", "method.cfl=0.25,0.5,0.9"}}};
}

Job job_of(const Comparison& comparison, bool long_run) {
  Job job{comparison.id,
          {"mms", file, "--work-precision", "--repeats", "3", "--set",
           long_run ? "study.spacings=[0.2,0.1,0.05,0.025,0.0125]" : "study.spacings=[0.2,0.1,0.05]", "--set",
           "study.periods=0.125", "--set", "method.integrator=verlet"},
          {file}};
  for (const auto& axis : comparison.vary) {
    job.arguments.emplace_back("--vary");
    job.arguments.push_back(axis);
  }
  return job;
}

/// Errors over one cost, a line per method, the front as points.
Figure cost_figure(const Comparison& comparison, const Json& points, const std::string& cost,
                   const std::string& front, const Axis& axis) {
  Picture p{comparison.title, axis, {"relative error in L₂", "", Scale::log}};
  p.labels = Labels::legend;
  Series best{"Pareto front", {}, {}, Style::points};
  for (const auto& point : points) {
    if (point.at("error").is_null()) continue;
    const std::string method = text(point, "method");
    const auto same = [&method](const Series& series) { return series.label == method; };
    if (std::none_of(p.series.begin(), p.series.end(), same)) p.series.push_back({method, {}, {}});
    Series& series = *std::find_if(p.series.begin(), p.series.end(), same);
    series.x.push_back(number(point, cost));
    series.y.push_back(number(point, "error"));
    if (point.at(front) == true)
      best.x.push_back(number(point, cost)), best.y.push_back(number(point, "error"));
  }
  p.series.push_back(best);
  return {comparison.id + (cost == "cpu_s" ? "-cpu" : "-pairs"),
          p,
          "Swinging plate, finite strain, U = 0.01 m, at T/8.",
          {comparison.id}};
}

/// The cheapest method of one comparison for the largest error that was asked for.
std::string answer_of(const Comparison& comparison, const DataTable& cheapest) {
  for (const auto& row : cheapest.rows) {
    const auto in = [&](const char* column) -> const Entry& { return cell_of(cheapest, row, column); };
    if (std::get<std::string>(in("comparison")) != comparison.title) continue;
    return fmt::format(
        "Of all combinations of gradient, force and kernel pair, \"{}\" reaches a relative error of {:g} in "
        "the least CPU time, {:.2g} s.",
        std::get<std::string>(in("method by CPU time")), std::get<double>(in("relative error")),
        std::get<double>(in("CPU time")));
  }
  return "No combination of gradient, force and kernel pair reaches an error of 0.01.";
}

Section write(const Results& results) {
  Section s;
  s.question = "Which method reaches an error at the least cost?";
  DataTable cheapest{"work-cheapest",
                     "Cheapest method for an error",
                     {{"comparison"},
                      {"relative error", "", 1},
                      {"method by CPU time"},
                      {"CPU time", "s", 3},
                      {"method by work"},
                      {"pair evaluations", "", 3}},
                     {},
                     {}};
  DataTable all{"work-points",
                "All points",
                {{"method"},
                 {"d", "m", 3},
                 {"relative error", "", 4},
                 {"CPU time", "s", 3},
                 {"spread", "s", 2},
                 {"pair evaluations", "", 4},
                 {"on the front (CPU)"},
                 {"on the front (work)"}},
                {},
                {}};
  std::size_t points_on_front = 0;
  int threads = 0;
  for (const auto& comparison : comparisons()) {
    const Json result = results.json(comparison.id);
    threads = result.at("threads").get<int>();
    s.figures.push_back(
        cost_figure(comparison, result.at("points"), "cpu_s", "front_cpu", {"CPU time", "s", Scale::log}));
    s.figures.push_back(cost_figure(comparison, result.at("points"), "pair_evaluations", "front_work",
                                    {"pair evaluations", "", Scale::log}));
    std::map<double, std::pair<Json, Json>, std::greater<>> by_error;
    for (const auto& row : result.at("cheapest")) {
      auto& both = by_error[number(row, "error")];
      (text(row, "measure") == "cpu_s" ? both.first : both.second) = row;
    }
    for (const auto& entry : by_error) {
      cheapest.row_jobs.push_back(comparison.id);
      cheapest.rows.push_back({comparison.title, entry.first, text(entry.second.first, "method"),
                               number(entry.second.first, "cost"), text(entry.second.second, "method"),
                               number(entry.second.second, "cost")});
    }
    for (const auto& point : result.at("points")) {
      const bool broken = point.at("error").is_null();
      all.row_jobs.push_back(comparison.id);
      points_on_front += point.at("front_cpu") == true;
      all.rows.push_back({text(point, "method"), number(point, "d"),
                          broken ? Entry(text(point, "status")) : Entry(number(point, "error")),
                          number(point, "cpu_s"), number(point, "cpu_spread_s"),
                          number(point, "pair_evaluations"), point.at("front_cpu") == true ? "yes" : "no",
                          point.at("front_work") == true ? "yes" : "no"});
    }
    cheapest.jobs.push_back(comparison.id);
    all.jobs.push_back(comparison.id);
  }
  s.tables = {cheapest, all};
  s.answer = answer_of(by_id(comparisons(), "work-forms"), cheapest);
  s.notes = {fmt::format("CPU time of the steps, without set-up: least of 3 runs after a warm-up, {} "
                         "threads; the spread is how far the "
                         "slowest of them was above it. {} of {} points lie on a front of CPU time.",
                         threads, points_on_front, all.rows.size()),
             "Errors that no method reaches with the levels computed are left out of the first table; --long "
             "adds two finer levels."};
  return s;
}

}  // namespace

/// Error against run time and against work.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{410, "work", "Error against run time", {}, write};
  for (const auto& comparison : comparisons()) plan.jobs.push_back(job_of(comparison, long_run));
  return plan;
}

}  // namespace plumb::reports::sections::work_precision
