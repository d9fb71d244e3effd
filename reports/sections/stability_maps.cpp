#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::stability_maps {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> outcomes = {
    "stable", "non-finite", "inverted", "energy-growth", "time-step-collapse", "hourglass", "refused"};

std::string word(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
}

int outcome_at(const Json& row, double parameter) {
  const double stable = number(row, "limit"), unstable = number(row, "y");
  if (parameter <= stable) return 0;
  if (row.at("cause").is_null() || parameter < unstable) return -1;  // not known
  const auto found = std::find(outcomes.begin(), outcomes.end(), text(row, "cause"));
  return static_cast<int>(found - outcomes.begin());
}

/// Schemes of the study, in its order.
std::vector<std::string> variants_of(const Json& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    if (std::find(names.begin(), names.end(), text(row, "variant")) == names.end())
      names.push_back(text(row, "variant"));
  return names;
}

/// The rows of a scheme, in the order of the second parameter.
std::vector<Json> rows_of(const Json& study, const std::string& variant) {
  std::vector<Json> rows;
  for (const auto& row : study.at("rows"))
    if (text(row, "variant") == variant) rows.push_back(row);
  return rows;
}

/// Top of the map: a little above the largest value that was found, stable or unstable.
double top_of(const Json& study) {
  double top = number(study, "from");
  for (const auto& row : study.at("rows"))
    for (const char* key : {"limit", "y"})
      if (const double value = number(row, key); std::isfinite(value)) top = std::max(top, value);
  return 1.15 * top;
}

/// One group of columns for each scheme, around 1, 2, ..: the values of the second parameter from left to
/// right, and an empty column. Upwards: the first parameter.
Figure map_of(const Json& study, const std::string& job) {
  constexpr int cells = 60;
  const auto variants = variants_of(study.at("rows"));
  const double top = top_of(study);
  CategoryMap map;
  map.names = outcomes;
  Picture picture{text(study, "study"), {"scheme"}, {text(study, "parameter")}};
  std::vector<Json> columns;
  std::string schemes, values;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const auto rows = rows_of(study, variants[k]);
    const auto width = static_cast<double>(rows.size() + 1);
    for (std::size_t n = 0; n <= rows.size(); ++n) {
      map.x.push_back(static_cast<double>(k + 1) + (static_cast<double>(n) - 0.5 * (width - 2)) / width);
      columns.push_back(n < rows.size() ? rows[n] : Json());
      if (k == 0 && n < rows.size()) values += (n ? ", " : "") + word(rows[n].at("x"));
    }
    picture.x.ticks.push_back(static_cast<double>(k + 1));
    schemes += fmt::format("{}{}: {}", k ? "; " : "", k + 1, variants[k]);
  }
  for (int j = 0; j < cells; ++j) {
    map.y.push_back(top * (j + 0.5) / cells);
    for (const auto& row : columns) map.z.push_back(row.is_null() ? -1 : outcome_at(row, map.y.back()));
  }
  picture.width = 1100;
  picture.map = std::move(map);
  return {
      job + "-map",
      std::move(picture),
      fmt::format("Schemes: {}. For each from left to right {} = {}.", schemes, text(study, "over"), values),
      {job}};
}

DataTable table_of(const Json& study, const std::string& job) {
  DataTable table{job + "-limits",
                  text(study, "study"),
                  {{"scheme"},
                   {text(study, "over")},
                   {"stable up to " + text(study, "parameter")},
                   {"unstable from"},
                   {"cause"},
                   {"at", "s"},
                   {"hourglass share", "", 2},
                   {"runs", "", 0},
                   {"CPU", "s", 3}},
                  {},
                  {job},
                  {}};
  const auto entry = [](const Json& value) -> Entry {
    if (value.is_null()) return {};
    if (value.is_string()) return value.get<std::string>();
    return value.get<double>();
  };
  for (const auto& row : study.at("rows")) {
    std::vector<Entry> line;
    for (const char* key : {"variant", "x", "limit", "y", "cause", "time", "hourglass", "runs", "cpu_s"})
      line.push_back(entry(row.at(key)));
    table.rows.push_back(std::move(line));
  }
  return table;
}

/// "compatible F at 0.6: refused: .." for every cell whose body cannot be built, once for each reason.
std::vector<std::string> refusals(const Results& results, const std::vector<Job>& jobs) {
  std::map<std::string, std::string> places;  // by reason
  for (const auto& job : jobs)
    for (const Json study = results.json(job.id); const auto& row : study.at("rows"))
      if (row.contains("cause") && row.at("cause") == "refused") {
        std::string& found = places[text(row, "status")];
        found += fmt::format("{}{}, {} ({})", found.empty() ? "" : "; ", text(row, "variant"),
                             word(row.at("x")), text(study, "study"));
      }
  std::vector<std::string> notes;
  for (const auto& [reason, where] : places) notes.push_back(where + ": " + reason + ".");
  return notes;
}

/// The bisected limits of small motion against those of the linearised operator.
void compare_with_theory(const Results& results, Section& s) {
  double worst = 0;
  const Json limits = results.json("edge-small-motion"), theory = results.json("edge-theory");
  for (const auto& limit : limits.at("rows"))
    for (const auto& spectrum : theory.at("rows"))
      if (text(spectrum, "method.integrator") + ", " + text(spectrum, "method.gradient") ==
              text(limit, "variant") &&
          std::stod(text(spectrum, "method.beta")) == number(limit, "x")) {
        const double apart = std::abs(number(limit, "limit") / number(spectrum, "stable_cfl") - 1);
        worst = std::max(worst, std::isfinite(apart) ? apart : std::numeric_limits<double>::infinity());
      }
  s.checks.push_back(
      bound_check("cfl limit of small motion, found by running, against the largest eigenvalue", worst, 0.05,
                  "relative; steps near the limit grow slowly"));
}

Section write(const Results& results, const std::vector<Job>& jobs) {
  Section s;
  s.question = "Where does each scheme become unstable, and of what?";
  compare_with_theory(results, s);
  double cpu = 0, runs = 0;
  for (const auto& job : jobs) {
    if (job.id == "edge-theory") continue;
    const Json study = results.json(job.id);
    for (const auto& row : study.at("rows")) cpu += number(row, "cpu_s"), runs += number(row, "runs");
    s.figures.push_back(map_of(study, job.id));
    s.tables.push_back(table_of(study, job.id));
  }
  s.answer = fmt::format(
      "{:.0f} runs of {} studies were driven to their edge "
      "in {:.0f} s of CPU time; the causes are in colour.",
      runs, jobs.size() - 1, cpu);
  s.notes = {
      "Each cell is bisected until stable and unstable values are as close "
      "as the study says. Whether a scheme becomes stable again beyond its "
      "first edge, or loses its stability below one, is not looked for.",
      "JST limits the step, too (THEORY 6.5). Where its limit lies below that "
      "of sound, a larger cfl changes nothing, and the bar is stable to its top."};
  for (auto& note : refusals(results, jobs)) s.notes.push_back(std::move(note));
  return s;
}

}  // namespace

/// Maps of stability.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const std::string folder = "verification/stability/", scenes = "verification/scenes/";
  const auto job = [&](const std::string& study, const std::string& scene) {
    return Job{"edge-" + study,
               {"stability", folder + study + ".toml"},
               {folder + study + ".toml", folder + "schemes.toml", scenes + scene}};
  };
  std::vector<Job> jobs = {
      {"edge-theory",
       {"spectrum", scenes + "free_plate.toml", "--set", "body.layout=node", "--over",
        "method.integrator=verlet,rk3", "--over", "method.gradient=standard,improved,compatible", "--over",
        "method.beta=0.9,1.2,1.5"},
       {scenes + "free_plate.toml"}},
      job("small-motion", "free_plate.toml"),
      job("plate-eta4-step", "free_plate.toml"),
      job("plate-jitter-beta", "free_plate.toml"),
      job("plate-cfl-kernel", "free_plate.toml"),
      job("strip-cfl-thickness", "free_plate.toml")};
  if (long_run) {
    jobs.push_back(job("bending-cfl-nu", "bending-column.toml"));
    jobs.push_back(job("bending-cfl-beta", "bending-column.toml"));
    jobs.push_back(job("pulling-stretch-nu", "pulling-column-nu-45.toml"));
    jobs.push_back(job("twisting-rate-resolution", "twisting-column-105.toml"));
  }
  return {710, "stability-maps", "Maps of stability", jobs,
          [jobs](const Results& results) { return write(results, jobs); }};
}

}  // namespace plumb::reports::sections::stability_maps
