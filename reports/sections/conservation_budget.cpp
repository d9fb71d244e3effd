#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/named.hpp"
#include "reports/page/page.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::conservation_budget {
namespace {

using Json = nlohmann::ordered_json;
using Columns = std::map<std::string, std::vector<double>>;

const std::string file = "verification/scenes/spinning-plate.toml";

struct Variant {
  std::string id, name;
  std::vector<std::string> set;
};
const std::vector<Variant> variants{{"budget-paper", "symmetrised, JST, RK3", {}},
                                    {"budget-adjoint", "adjoint, JST, RK3", {"method.momentum=adjoint"}},
                                    {"budget-verlet",
                                     "adjoint, Verlet",
                                     {"method.momentum=adjoint", "method.integrator=verlet", "jst.eta4=0"}}};

Job job_of(const Variant& variant) {
  Job job{variant.id,
          {"run", file, "--out", "{out}", "--set", "output.budget=true", "--set", "body.particles=[20,20]",
           "--set", "scene.end_time=0.1"},
          {file}};
  for (const auto& entry : variant.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

/// What one cause did, step by step: its column "NAME: angular momentum z [..]" or "NAME: energy [..]".
struct Part {
  std::string name;
  std::vector<double> values;
};

std::vector<Part> parts_of(const Columns& columns, const std::string& quantity) {
  std::vector<Part> parts;
  for (const auto& [heading, values] : columns)
    if (const auto at = heading.find(": " + quantity); at != std::string::npos)
      parts.push_back({heading.substr(0, at), values});
  if (parts.empty()) throw MissingResult("a budget has no " + quantity);
  return parts;
}

double largest(const Columns& columns, const std::string& name) {
  const auto found = columns.find(name);
  if (found == columns.end()) throw MissingResult("a budget has no column \"" + name + "\"");
  double most = 0;
  for (const double value : found->second)
    if (!(std::abs(value) <= most)) most = std::abs(value);
  return most;
}

/// The start of a column of the run's series.
double start_of(const Results& results, const std::string& id, const std::string& name) {
  const auto series = results.csv(id, "series.csv");
  for (const auto& [heading, values] : series)
    if (heading.starts_with(name) && !values.empty()) return values.front();
  throw MissingResult("a series has no " + name);
}

/// Change of the angular momentum by every cause, over time.
Figure picture_of(const Results& results, const Variant& variant, double start) {
  const auto columns = results.csv(variant.id, "budget.csv");
  Picture picture{variant.name, {"time t", "s"}, {"change of angular momentum", "%"}};
  for (const auto& part : parts_of(columns, "angular momentum z")) {
    Series series{part.name, columns.at("time [s]"), {}, Style::lines};
    for (const double value : part.values) series.y.push_back(100 * value / start);
    picture.series.push_back(std::move(series));
  }
  return {variant.id,
          std::move(picture),
          "Sums from the start, in percent of the angular momentum at the start.",
          {variant.id}};
}

Section write(const Results& results) {
  Section s;
  s.question = "Which force changes momentum and energy, and does the account close?";
  DataTable table{
      "budget",
      "Changes over the run, by cause",
      {{"scheme"}, {"cause"}, {"angular momentum", "%", 3}, {"energy", "% of the kinetic one", 3}},
      {},
      {}};
  double worst = 0;
  std::string changes;
  for (const auto& v : variants) {
    const Json run = results.json(v.id);
    s.checks.push_back({v.name + ": run to its end", "completed", text(run, "status"),
                        pass_if(text(run, "status") == "completed"), v.id, CheckKind::book_keeping});
    const auto columns = results.csv(v.id, "budget.csv");
    for (const char* gap : {"gap of linear momentum", "gap of angular momentum", "gap of energy"})
      worst = std::max(worst, largest(columns, gap));
    const double momentum = start_of(results, v.id, "angular momentum z"),
                 energy = start_of(results, v.id, "kinetic energy");
    const auto turns = parts_of(columns, "angular momentum z"), powers = parts_of(columns, "energy");
    double turned = 0;
    for (const Part& turn : turns) {
      const Part power = named(powers, turn.name, &Part::name);
      turned += turn.values.back() / momentum;
      table.rows.push_back(
          {v.name, turn.name, 100 * turn.values.back() / momentum, 100 * power.values.back() / energy});
      table.row_jobs.push_back(v.id);
      table.figures.push_back(v.id);
    }
    changes += fmt::format("{}{} % ({})", changes.empty() ? "" : ", ", number_text(100 * turned, 2), v.name);
    table.jobs.push_back(v.id);
    s.figures.push_back(picture_of(results, v, momentum));
  }
  s.checks.push_back(bound_check("largest gap of a step: change that no cause explains, relative", worst,
                                 1e-12, "round-off of sums over 400 particles"));
  s.answer = fmt::format(
      "Change of the angular momentum in 0.1 s: {}; what the causes leave unexplained is at most {} "
      "of it in any step.",
      changes, number_text(worst, 1));
  s.tables = {std::move(table)};
  s.notes = {
      "Spinning plate, 20 × 20 particles. Each force is followed through "
      "the stages of the integrator with the weights that the state sees, "
      "THEORY (8.5), (8.6); what remains of the energy is the integrator's."};
  return s;
}

}  // namespace

/// The conservation budget: momentum and energy by cause.
SectionPlan planned(Extent) {
  SectionPlan plan{620, "budget", "Conservation budget", {}, write};
  for (const auto& v : variants) plan.jobs.push_back(job_of(v));
  return plan;
}

}  // namespace plumb::reports::sections::conservation_budget
