#include "reports/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/results.hpp"

namespace plumb::reports {
namespace {

using Json = nlohmann::ordered_json;

/// A number of the object, or an empty cell where it has none.
Entry cell(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? Entry(found->get<double>()) : Entry();
}

Entry end_of(const Json& fit, std::size_t which) {
  const auto found = fit.find("ci95");
  return found != fit.end() && found->is_array() && found->at(which).is_number()
             ? Entry(found->at(which).get<double>())
             : Entry();
}

std::string short_number(const Entry& entry) {
  const auto* value = std::get_if<double>(&entry);
  return value ? fmt::format("{:.2f}", *value) : "?";
}

const Json& fit_of(const Json& result, const std::string& norm) {
  for (const auto& fit : result.at("fits"))
    if (text(fit, "norm") == norm) return fit;
  throw MissingResult("a study has no fit of " + norm);
}

/// What the levels say about failed runs; empty if all completed.
std::string failures(const Json& result) {
  std::string out;
  for (const auto& level : result.at("levels"))
    if (const auto found = level.find("status"); found != level.end() && found->is_string())
      out += fmt::format("; d = {:g} m: {}", number(level, "d"), found->get<std::string>());
  return out;
}

}  // namespace

Check study_check(std::string what, const Json& result, const std::string& norm) {
  const Json& fit = fit_of(result, norm);
  const Entry declared = cell(fit, "declared");
  Check check{std::move(what), "no order declared", {}, text(fit, "verdict")};
  check.measured = fmt::format("{}, 95 % interval [{}, {}]{}", short_number(cell(fit, "order")),
                               short_number(end_of(fit, 0)), short_number(end_of(fit, 1)), failures(result));
  if (const auto* order = std::get_if<double>(&declared)) check.expected = fmt::format("order {:g}", *order);
  const auto& known = verdict_names();
  if (std::find(known.begin(), known.end(), check.verdict) == known.end()) {
    check.measured += ", " + check.verdict;
    check.verdict = "inconclusive";
  }
  return check;
}

Job refinement_job(const Refinement& entry, const std::string& command) {
  const std::string file = "verification/studies/" + entry.file;
  Job job{entry.id, {command, file}, {file}};
  for (const auto& set : entry.set) job.arguments.insert(job.arguments.end(), {"--set", set});
  return job;
}

Figure levels_figure(const Results& results, const std::string& id, const std::string& title,
                     const std::vector<Refinement>& entries, const std::string& caption) {
  Figure figure{
      id,
      {title, {"particle spacing d", "m", Scale::log}, {"error in L₂ of the displacement", "", Scale::log}},
      caption,
      {}};
  figure.picture.labels = Labels::legend;
  figure.picture.height = 480;
  for (const auto& entry : entries) {
    Series series{entry.name, {}, {}};
    const Json result = results.json(entry.id);
    for (const auto& level : result.at("levels"))
      if (!level.at("l2").is_null())
        series.x.push_back(number(level, "d")), series.y.push_back(number(level, "l2"));
    if (!series.x.empty()) figure.picture.series.push_back(series);
    figure.jobs.push_back(entry.id);
  }
  if (!figure.picture.series.empty()) figure.picture.triangles = {{2, figure.picture.series.size() - 1}};
  return figure;
}

DataTable fits_table(std::string id, std::string title, std::vector<std::string> jobs) {
  return {std::move(id),
          std::move(title),
          {{"study"},
           {"norm"},
           {"order", "", 3},
           {"95 % from", "", 3},
           {"to", "", 3},
           {"declared", "", 2},
           {"verdict"}},
          {},
          std::move(jobs)};
}

void add_fits(DataTable& table, const std::string& name, const std::string& job, const Json& result,
              const std::string& figure) {
  for (const auto& fit : result.at("fits")) {
    table.rows.push_back({name, text(fit, "norm"), cell(fit, "order"), end_of(fit, 0), end_of(fit, 1),
                          cell(fit, "declared"), text(fit, "verdict")});
    table.figures.push_back(figure);
  }
  table.jobs.push_back(job);
}

DataTable levels_table(std::string id, std::string title, std::vector<std::string> jobs) {
  return {std::move(id),
          std::move(title),
          {{"study"},
           {"d", "m", 3},
           {"particles", "", 0},
           {"steps", "", 0},
           {"l2", "m", 4},
           {"h1", "", 4},
           {"linf", "m", 4},
           {"l2_gauss", "m", 4},
           {"h1_gauss", "", 4},
           {"relative l2", "", 4},
           {"relative velocity l2", "", 4},
           {"relative stress l2", "", 4},
           {"CPU time", "s", 3},
           {"pair evaluations", "", 4}},
          {},
          std::move(jobs)};
}

void add_levels(DataTable& table, const std::string& name, const std::string& job, const Json& result) {
  for (const auto& level : result.at("levels")) {
    std::vector<Entry> row{name};
    for (const char* key : {"d", "n", "steps", "l2", "h1", "linf", "l2_gauss", "h1_gauss", "relative_l2",
                            "relative_velocity_l2", "relative_stress_l2", "cpu_s", "pair_evaluations"})
      row.push_back(cell(level, key));
    table.rows.push_back(std::move(row));
  }
  table.jobs.push_back(job);
}

}  // namespace plumb::reports
