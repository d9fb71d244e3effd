#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/order_fit.hpp"
#include "lib/convergence/verdict.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::implicit_dynamics {
namespace {

using Json = nlohmann::ordered_json;

/// A rule that steps in time.
struct Rule {
  std::string id, name;
  std::vector<std::string> set;
};

std::vector<Rule> rules() {
  return {
      {"midpoint", "implicit midpoint", {"method.scheme=implicit", "implicit.dynamics=midpoint"}},
      {"energy-momentum", "energy-momentum", {"method.scheme=implicit", "implicit.dynamics=energy-momentum"}},
      {"verlet", "Verlet", {"method.integrator=verlet"}}};
}

/// What is moved, by which rules and with which steps [s], and by which share of its limit Verlet steps: its finest one is the reference.
struct Motion {
  std::string id, name, scene, probe;
  std::vector<std::string> implicit_rules;
  std::vector<std::string> steps;
  std::vector<std::string> cfl;  ///< descending
  std::vector<std::string> set = {};
};

/// The beam swings a hundred times in a long report, ten times else.
std::vector<Motion> motions(bool long_run) {
  const std::vector<std::string> end =
      long_run ? std::vector<std::string>() : std::vector<std::string>{"scene.end_time=19 s"};
  return {{"thrown",
           "free plate, spun and pulled",
           "thrown-plate",
           "corner",
           {"midpoint", "energy-momentum"},
           {"2.5e-4", "1.25e-4", "6.25e-5", "3.125e-5"},
           {"0.5", "0.005"}},
          {"stiff",
           "plate with nu = 0.4999",
           "stiff-plate",
           "side",
           {"midpoint", "energy-momentum"},
           {"2.46288e-3", "1.23144e-3", "6.1572e-4"},
           {"0.5", "0.1"}},
          {"slender",
           long_run ? "beam 1 : 40, 100 periods" : "beam 1 : 40, 10 periods",
           "slender-beam",
           "tip",
           {"midpoint", "energy-momentum"},
           {"95e-3", "23.75e-3"},
           {"0.8", "0.4"},
           end}};
}

/// Those that move it.
std::vector<Rule> rules_of(const Motion& motion) {
  std::vector<Rule> all;
  for (const auto& id : motion.implicit_rules) all.push_back(by_id(rules(), id));
  all.push_back(by_id(rules(), "verlet"));
  return all;
}

const std::vector<std::string>& steps_of(const Motion& motion, const Rule& rule) {
  return rule.id == "verlet" ? motion.cfl : motion.steps;
}

std::string id_of(const Motion& motion, const Rule& rule, const std::string& step) {
  std::string id = fmt::format("dynamics-{}-{}-{}", motion.id, rule.id, step);
  std::replace(id.begin(), id.end(), '.', '-');
  return id;
}

/// Where the probe is carried to [m].
std::vector<double> end_of(const Json& result, const Motion& motion) {
  return result.at("probes").at(motion.probe).at("displacement").get<std::vector<double>>();
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

std::vector<double> reference_of(const Results& results, const Motion& motion) {
  const Rule verlet = by_id(rules(), "verlet");
  return end_of(results.json(id_of(motion, verlet, motion.cfl.back())), motion);
}

/// Off the reference, over what that one has moved.
double error_of(const Results& results, const Motion& motion, const Json& result) {
  const std::vector<double> reference = reference_of(results, motion);
  return distance(end_of(result, motion), reference) /
         distance(reference, std::vector<double>(reference.size(), 0));
}

double energy_change(const Json& result) {
  return number(result.at("energy"), "relative_change");
}

bool is_reference(const Motion& motion, const Rule& rule, const std::string& step) {
  return rule.id == "verlet" && step == motion.cfl.back();
}

DataTable runs_table(const Results& results, bool long_run) {
  DataTable table{"dynamics-runs",
                  "Steps in time: what they keep, what they are off by and what they cost",
                  {{"motion"},
                   {"rule"},
                   {"step", "s", 4},
                   {"steps", "", 0},
                   {"off the reference", "", 3},
                   {"change of energy", "", 3},
                   {"drift of momentum", "", 3},
                   {"drift of angular momentum", "", 3},
                   {"CPU time", "s", 3}},
                  {}};
  for (const Motion& motion : motions(long_run))
    for (const Rule& rule : rules_of(motion))
      for (const auto& step : steps_of(motion, rule)) {
        const std::string job = id_of(motion, rule, step);
        const Json result = results.json(job);
        const bool free = motion.id == "thrown";
        table.rows.push_back(
            {motion.name, rule.name, number(result.at("dt"), "first"), number(result, "steps"),
             is_reference(motion, rule, step) ? Entry() : error_of(results, motion, result),
             energy_change(result), free ? Entry(number(result, "linear_drift")) : Entry(),
             free ? Entry(number(result, "angular_drift")) : Entry(), number(result.at("timing"), "cpu_s")});
        table.row_jobs.push_back(job);
        table.jobs.push_back(job);
      }
  return table;
}

OrderFit fit_of(const Results& results, const Motion& motion, const Rule& rule) {
  std::vector<Level> levels;
  for (const auto& step : motion.steps)
    levels.push_back({std::stod(step), error_of(results, motion, results.json(id_of(motion, rule, step)))});
  return fit_order(levels);
}

DataTable orders_table(const Results& results, bool long_run, std::vector<Check>& checks) {
  DataTable table{"dynamics-orders",
                  "Orders in time of a free plate",
                  {{"rule"}, {"order", "", 3}, {"95 % interval"}, {"levels", "", 0}},
                  {}};
  const Motion motion = by_id(motions(long_run), "thrown");
  for (const Rule& rule : rules()) {
    if (rule.id == "verlet") continue;
    const OrderFit fit = fit_of(results, motion, rule);
    const std::string interval = fmt::format("[{:.2f}, {:.2f}]", fit.lower, fit.upper);
    table.rows.push_back({rule.name, fit.order, interval, static_cast<double>(motion.steps.size())});
    for (const auto& step : motion.steps) table.jobs.push_back(id_of(motion, rule, step));
    checks.push_back({rule.name + ": order in time", "order 2",
                      fmt::format("{:.3f}, {}", fit.order, interval), std::string(name_of(judge(fit, 2)))});
  }
  return table;
}

void check_momenta(const Results& results, bool long_run, std::vector<Check>& checks) {
  // searches end at 1e-10 of the forces, and round-off adds up over hundreds of steps
  constexpr double kept = 1e-8;
  const Motion motion = by_id(motions(long_run), "thrown");
  const auto check = [&](const std::string& what, double found, const std::string& job) {
    checks.push_back({what, fmt::format("at most {:g}", kept), fmt::format("{:.2e}", found),
                      pass_if(std::abs(found) <= kept), job});
  };
  for (const Rule& rule : rules()) {
    if (rule.id == "verlet") continue;
    const std::string job = id_of(motion, rule, motion.steps.front());
    const Json result = results.json(job);
    check(rule.name + ": drift of momentum", number(result, "linear_drift"), job);
    check(rule.name + ": drift of angular momentum", number(result, "angular_drift"), job);
    if (rule.id == "energy-momentum") check(rule.name + ": change of energy", energy_change(result), job);
  }
}

/// Errors and costs of Verlet's longest steps and of the shortest of the midpoint rule.
std::string against_verlet(const Results& results, const Motion& motion) {
  const Rule verlet = by_id(rules(), "verlet"), midpoint = by_id(rules(), "midpoint");
  const Json explicit_run = results.json(id_of(motion, verlet, motion.cfl.front())),
             implicit_run = results.json(id_of(motion, midpoint, motion.steps.back()));
  return fmt::format("{}: Verlet is {:.2g} off in {:.2g} CPU-s, the midpoint rule {:.2g} in {:.2g}",
                     motion.name, error_of(results, motion, explicit_run),
                     number(explicit_run.at("timing"), "cpu_s"), error_of(results, motion, implicit_run),
                     number(implicit_run.at("timing"), "cpu_s"));
}

Section write(const Results& results, bool long_run) {
  Section s;
  s.question = "What do implicit steps in time keep, and when are they worth their cost?";
  check_momenta(results, long_run, s.checks);
  s.tables = {orders_table(results, long_run, s.checks), runs_table(results, long_run)};
  s.answer = against_verlet(results, by_id(motions(long_run), "stiff")) + "; " +
             against_verlet(results, by_id(motions(long_run), "slender")) + ".";
  s.notes = {
      "What is off is the end of the probe, over how far it has gone. Verlet's error is that of its own steps: all rules move the same particles with the same forces.",
      "A step of an implicit rule is a search with two or three factors and costs some hundred of Verlet's on bodies as small as these.",
      "The midpoint rule sees a body that turns by an angle in a step as pressed by an eighth of its square. With a twentieth of a period a step the beam gains energy by that; energy-momentum takes its stress from the stretches of both ends and does not."};
  return s;
}

}  // namespace

/// Implicit midpoint and energy-momentum beside Verlet: orders, what is kept, work and precision.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{
      505, "implicit-dynamics", "Implicit steps in time", {}, [long_run](const Results& results) {
        return write(results, long_run);
      }};
  for (const Motion& motion : motions(long_run))
    for (const Rule& rule : rules_of(motion))
      for (const auto& step : steps_of(motion, rule)) {
        const std::string file = "verification/scenes/" + motion.scene + ".toml";
        const std::string key = rule.id == "verlet" ? "method.cfl=" : "implicit.time_step=";
        Job job{id_of(motion, rule, step), {"run", file, "--out", "{out}"}, {file}};
        for (const auto* sets : {&motion.set, &rule.set})
          for (const auto& set : *sets) job.arguments.insert(job.arguments.end(), {"--set", set});
        job.arguments.insert(job.arguments.end(), {"--set", key + step});
        plan.jobs.push_back(std::move(job));
      }
  return plan;
}

}  // namespace plumb::reports::sections::implicit_dynamics
