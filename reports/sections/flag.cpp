#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/checks.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"
#include "reports/swing.hpp"

namespace plumb::reports::sections::flag {
namespace {

using Json = nlohmann::ordered_json;

/// One run of the swinging flag.
struct FlagRun {
  std::string id, name, file;
  std::vector<std::string> set;
  bool judged = false;  ///< its last swing is, by 1 %
  bool published =
      false;  ///< it steps as the authors do: the height's extremes of the run are compared with theirs by 1 %
  bool last = false;  ///< all that they print is asked of its last swing by 1 %
};

const std::string particles = "verification/scenes/flag-swinging.toml",
                  elements = "verification/scenes/flag-elements.toml",
                  in_steps = "verification/scenes/flag-in-steps.toml";

const std::vector<std::string> implicit_steps{"element.solve=newton", "implicit.dynamics=midpoint",
                                              "implicit.time_step=0.005"};

std::vector<std::string> with(const std::string& entry, std::vector<std::string> others) {
  others.insert(others.begin(), entry);
  return others;
}

const std::vector<FlagRun> quick{
    {"flag-8",
     "particles, 8 cells across",
     particles,
     {"body.spacing=0.0025", "boundary.0.where=(X + 0.05)^2 + (Y - 0.01)^2 < 0.05125^2"}},
    {"flag-elements-4", "finite elements of second order, 4 across, end held straight", elements, {}},
    {"flag-elements-4-steps", "the same by the implicit midpoint rule, in steps of 5 ms as the authors'",
     elements, implicit_steps, false, true},
    {"flag-8-steps",
     "particles in steps of 5 ms, 8 cells across, end held straight",
     in_steps,
     {"body.spacing=0.0025"},
     false,
     true,
     true}};
const std::vector<FlagRun> slow{
    {"flag-20", "particles, 20 cells across", particles, {}, true},
    {"flag-20-steps",
     "particles in steps of 5 ms, 20 cells across, end held straight",
     in_steps,
     {},
     false,
     true,
     true},
    {"flag-elements-8",
     "finite elements of second order, 8 across, end held straight",
     elements,
     {"body.spacing=0.0025"}},
    {"flag-elements-8-steps", "the same by the implicit midpoint rule, in steps of 5 ms as the authors'",
     elements, with("body.spacing=0.0025", implicit_steps), false, true}};

std::vector<FlagRun> runs_of(bool long_run) {
  std::vector<FlagRun> all = quick;
  if (long_run) all.insert(all.end(), slow.begin(), slow.end());
  return all;
}

/// What Turek and Hron print, and the number of a swing that is compared with it.
struct Number {
  std::string name, column, unit;
  Swing (*of)(const std::vector<double>& time, const std::vector<double>& value);
  double Swing::*member;
  double factor, published;
  std::vector<bool FlagRun::*> judges =
      {};  ///< the runs for which it is a check of the report; in the others it is shown
};

const std::string height = "tip displacement y [m]", along = "tip displacement x [m]";

const std::vector<Number> numbers{
    {"height, mean of the last swing",
     height,
     "mm",
     last_swing,
     &Swing::mean,
     1e3,
     -63.607,
     {&FlagRun::last}},
    {"height, amplitude of the last swing",
     height,
     "mm",
     last_swing,
     &Swing::amplitude,
     1e3,
     65.160,
     {&FlagRun::judged, &FlagRun::last}},
    {"height, frequency",
     height,
     "Hz",
     last_swing,
     &Swing::frequency,
     1,
     1.0995,
     {&FlagRun::judged, &FlagRun::last}},
    {"along the bar, mean of the last swing",
     along,
     "mm",
     last_swing,
     &Swing::mean,
     1e3,
     -14.305,
     {&FlagRun::last}},
    {"along the bar, amplitude of the last swing",
     along,
     "mm",
     last_swing,
     &Swing::amplitude,
     1e3,
     14.305,
     {&FlagRun::last}},
    {"height, mean of the run",
     height,
     "mm",
     widest_swing,
     &Swing::mean,
     1e3,
     -63.607,
     {&FlagRun::published}},
    {"height, amplitude of the run",
     height,
     "mm",
     widest_swing,
     &Swing::amplitude,
     1e3,
     65.160,
     {&FlagRun::published}},
    {"along the bar, mean of the run", along, "mm", widest_swing, &Swing::mean, 1e3, -14.305},
    {"along the bar, amplitude of the run", along, "mm", widest_swing, &Swing::amplitude, 1e3, 14.305},
};

bool is_judged(const FlagRun& run, const Number& of) {
  return std::ranges::any_of(of.judges, [&](bool FlagRun::*one) { return run.*one; });
}

const std::vector<double>& column(const std::map<std::string, std::vector<double>>& table,
                                  const std::string& name) {
  const auto found = table.find(name);
  if (found == table.end()) throw MissingResult("a table has no column \"" + name + "\"");
  return found->second;
}

Figure history(const Results& results, const FlagRun& run) {
  const auto series = results.csv(run.id, "series.csv");
  Picture picture{"Tip of the swinging flag", {"time t", "s"}, {"displacement", "mm"}};
  for (const auto& [label, name] : {std::pair("height", height), std::pair("along the bar", along)}) {
    std::vector<double> shown;
    for (const double u : column(series, name)) shown.push_back(1e3 * u);
    picture.series.push_back({label, column(series, "time [s]"), shown, Style::lines});
  }
  return {run.id + "-tip", picture, run.name + ".", {run.id}};
}

Section write(const Results& results, const std::vector<FlagRun>& all) {
  Section s;
  s.question = "Does the elastic flag of Turek and Hron swing as published?";
  s.tables = {{"flag",
               "Swings of the flag in ten seconds: ours, published, off by",
               {{"run"},
                {"quantity"},
                {"unit"},
                {"ours", "", 5},
                {"published", "", 5},
                {"off by", "%", 2},
                {"particles", "", 0},
                {"CPU time", "s", 3}},
               {}}};
  DataTable& table = s.tables[0];
  double worst = 0;  // of all runs
  for (const FlagRun& run : all) {
    const Json result = results.json(run.id);
    const auto series = results.csv(run.id, "series.csv");
    s.figures.push_back(history(results, run));
    for (const Number& of : numbers) {
      const Swing swing = of.of(column(series, "time [s]"), column(series, of.column));
      const double ours = of.factor * (swing.*of.member), off = ours / of.published - 1;
      worst = std::max(worst, std::abs(off));
      table.rows.push_back({run.name, of.name, of.unit, ours, of.published, 100 * off,
                            number(result, "particles"), number(result.at("timing"), "cpu_s")});
      table.row_jobs.push_back(run.id);
      if (!is_judged(run, of)) continue;
      Check check = as(CheckKind::reproduced, number_check("swinging flag, " + run.name + ", " + of.name,
                                                           ours, of.published, 0.01, "one per cent"));
      check.job = run.id;
      s.checks.push_back(std::move(check));
    }
    table.jobs.push_back(run.id);
  }
  s.answer = fmt::format("All numbers are within {:.2g} % of the published ones.", 100 * worst);
  s.notes = {
      "S. Turek and J. Hron, Proposal for numerical benchmarking of fluid-structure interaction, Lect. Notes Comput. "
      "Sci. Eng. 53, 371 (2006), CSM3. Mean and amplitude are half sum and half difference of the highest and the "
      "lowest value of the last period, as they have them; those of the whole run stand beside them.",
      "They step by a rule of second order, in 5 ms. Particles and elements of ours that do so too have their numbers, of the last swing or of the "
      "run; in short steps the same bodies have others. So what is published has the error of that step: it moves energy between the modes of the bar, and the mean "
      "of a swing drifts by a millimetre in ten seconds.",
      "Of the runs in short steps, 1 % is asked of the height's amplitude and frequency only."};
  return s;
}

}  // namespace

/// CSM3 of Turek and Hron: a clamped bar that is let go under its weight.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const auto all = runs_of(long_run);
  SectionPlan plan{507, "flag", "Swinging flag", {}, [all](const Results& r) { return write(r, all); }};
  for (const FlagRun& run : all) {
    Job job{run.id, {"run", run.file, "--out", "{out}"}, {run.file}};
    for (const auto& entry : run.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
    plan.jobs.push_back(std::move(job));
  }
  plan.least = Extent::full;
  return plan;
}

}  // namespace plumb::reports::sections::flag
