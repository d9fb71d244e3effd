#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> outcomes = {"stable",        "non-finite",         "inverted",
                                           "energy-growth", "time-step-collapse", "hourglass"};

std::string word(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
}

int outcome_at(const Json& row, double parameter) {
  const double stable = number(row, "limit"), unstable = number(row, "y");
  if (parameter <= stable) return 0;
  if (std::isnan(unstable) || parameter < unstable) return -1;  // not known
  const auto found = std::find(outcomes.begin(), outcomes.end(), text(row, "cause"));
  return static_cast<int>(found - outcomes.begin());
}

std::vector<std::string> variants_of(const Json& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows)
    if (std::find(names.begin(), names.end(), text(row, "variant")) == names.end())
      names.push_back(text(row, "variant"));
  return names;
}

/// Columns: the values of the second parameter, one after the other. Rows: the first parameter.
Figure map_of(const Json& study, const std::string& job, const std::string& variant, std::size_t place) {
  constexpr int cells = 48;
  std::vector<Json> rows;
  std::string columns;
  for (const auto& row : study.at("rows")) {
    if (text(row, "variant") != variant) continue;
    rows.push_back(row);
    columns += (columns.empty() ? "" : ", ") + word(row.at("x"));
  }
  double top = number(study, "from");
  for (const auto& row : study.at("rows"))
    for (const char* key : {"limit", "y"})
      if (const double value = number(row, key); std::isfinite(value)) top = std::max(top, value);
  CategoryMap map;
  map.names = outcomes;
  for (std::size_t k = 0; k < rows.size(); ++k) map.x.push_back(static_cast<double>(k + 1));
  for (int j = 0; j < cells; ++j) {
    map.y.push_back(1.15 * top * (j + 0.5) / cells);
    for (const auto& row : rows) map.z.push_back(outcome_at(row, map.y.back()));
  }
  Picture picture{variant, {text(study, "over") + ": " + columns}, {text(study, "parameter")}};
  picture.x.ticks = map.x;
  picture.map = std::move(map);
  return {fmt::format("{}-{}", job, place),
          std::move(picture),
          text(study, "study") + ". Columns from left to right: " + columns + ".",
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

/// The bisected limits of small motion against those of the linearised operator.
void compare_with_theory(const Results& results, Section& s) {
  double worst = 0;
  for (const auto& limit : results.json("edge-small-motion").at("rows"))
    for (const auto& spectrum : results.json("edge-theory").at("rows"))
      if (text(spectrum, "method.integrator") == text(limit, "variant") &&
          std::stod(text(spectrum, "method.beta")) == number(limit, "x"))
        worst = std::max(worst, std::abs(number(limit, "limit") / number(spectrum, "stable_cfl") - 1));
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
    if (text(study, "parameter") != "stretch") {
      const auto variants = variants_of(study.at("rows"));
      for (std::size_t k = 0; k < variants.size(); ++k)
        s.figures.push_back(map_of(study, job.id, variants[k], k));
    }
    s.tables.push_back(table_of(study, job.id));
  }
  s.answer = fmt::format(
      "{:.0f} runs of {} studies were driven to their edge in {:.0f} s of CPU time; the causes are in "
      "colour.",
      runs, jobs.size() - 1, cpu);
  s.notes = {
      "Each cell is bisected until stable and unstable values are as close as the study says; that a scheme "
      "might "
      "become stable again beyond its first edge is not looked for."};
  return s;
}

}  // namespace

/// Maps of stability.
SectionPlan stability_maps(bool long_run) {
  const std::string folder = "verification/stability/", scenes = "verification/scenes/";
  const auto job = [&](const std::string& study, const std::string& scene) {
    return Job{
        "edge-" + study, {"stability", folder + study + ".toml"}, {folder + study + ".toml", scenes + scene}};
  };
  std::vector<Job> jobs = {{"edge-theory",
                            {"spectrum", scenes + "free_plate.toml", "--over", "method.integrator=verlet,rk3",
                             "--over", "method.beta=0.9,1.2,1.5"},
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

}  // namespace plumb::reports::sections
