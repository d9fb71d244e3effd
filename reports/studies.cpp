#include "reports/studies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "lib/convergence/verdict.hpp"
#include "reports/named.hpp"
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

/// "1.87, 95 % interval [1.60, 2.13]", and without an interval where there is none.
std::string order_text(const Json& fit) {
  const Entry order = cell(fit, "order"), low = end_of(fit, 0), high = end_of(fit, 1);
  if (!std::holds_alternative<double>(order)) return "no order can be fitted";
  std::string text = fmt::format("{:.2f}", std::get<double>(order));
  if (!std::holds_alternative<double>(low) || !std::holds_alternative<double>(high))
    return text + ", no interval (fewer than three levels)";
  return text +
         fmt::format(", 95 % interval [{:.2f}, {:.2f}]", std::get<double>(low), std::get<double>(high));
}

/// "l2" as L₂, for people.
std::string shown_norm(const std::string& norm) {
  return norm == "l2" ? "L₂" : norm == "h1" ? "H₁" : norm;
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

const Json& fit_of(const Json& result, const std::string& norm) {
  for (const auto& fit : result.at("fits"))
    if (text(fit, "norm") == norm) return fit;
  throw MissingResult("a study has no fit of " + norm);
}

Check study_check(std::string what, const Json& result, const std::string& norm) {
  const Json& fit = fit_of(result, norm);
  const Entry declared = cell(fit, "declared");
  Check check{std::move(what), "no order declared", {}, text(fit, "verdict")};
  check.measured = order_text(fit) + failures(result);
  if (const auto* order = std::get_if<double>(&declared)) check.expected = fmt::format("order {:g}", *order);
  const auto& known = verdict_names();
  if (std::find(known.begin(), known.end(), check.verdict) == known.end()) {
    check.measured += ", " + check.verdict;
    check.verdict = "inconclusive";
  }
  return check;
}

bool declares(const Json& result, const std::string& norm) {
  return std::holds_alternative<double>(cell(fit_of(result, norm), "declared"));
}

std::optional<Check> exclusion_check(std::string what, const Json& result, const std::string& norm,
                                     double order) {
  const Json& found = fit_of(result, norm);
  OrderFit fit;
  if (const Entry upper = end_of(found, 1); std::holds_alternative<double>(upper))
    fit.upper = std::get<double>(upper);
  fit.levels.resize(found.at("levels").get<std::size_t>());
  fit.not_finite = failures(result).empty() ? 0 : 1;
  if (!excludes(fit, order)) return std::nullopt;
  return Check{std::move(what), fmt::format("an interval below order {:g}", order),
               order_text(found) + fmt::format(": order {:g} is contradicted", order), "pass"};
}

Job refinement_job(const Refinement& entry, const std::string& command) {
  const std::string file = "verification/studies/" + entry.file;
  Job job{entry.id, {command, file}, {file}};
  for (const auto& set : entry.set) job.arguments.insert(job.arguments.end(), {"--set", set});
  return job;
}

Figure levels_figure(const Results& results, const std::string& id, const std::string& title,
                     const std::vector<Refinement>& entries, const std::string& caption) {
  Figure figure{id,
                {title,
                 {"particle spacing d", "m", Scale::log},
                 {"relative error in L₂ of the displacement", "", Scale::log}},
                caption,
                {}};
  figure.picture.labels = Labels::legend;
  figure.picture.height = 480;
  for (const auto& entry : entries) {
    Series series{entry.name, {}, {}};
    const Json result = results.json(entry.id);
    for (const auto& level : result.at("levels"))
      if (!level.at("relative_l2").is_null())
        series.x.push_back(number(level, "d")), series.y.push_back(number(level, "relative_l2"));
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
    table.row_jobs.push_back(job);
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
           {"relative l2", "", 4},
           {"relative h1", "", 4},
           {"relative linf", "", 4},
           {"relative l2_gauss", "", 4},
           {"relative h1_gauss", "", 4},
           {"relative velocity l2", "", 4},
           {"relative stress l2", "", 4},
           {"l2", "m^(1+d/2)", 4},
           {"CPU time", "s", 3},
           {"pair evaluations", "", 4}},
          {},
          std::move(jobs)};
}

void add_levels(DataTable& table, const std::string& name, const std::string& job, const Json& result) {
  for (const auto& level : result.at("levels")) {
    std::vector<Entry> row{name};
    for (const char* key : {"d", "n", "steps", "relative_l2", "relative_h1", "relative_linf",
                            "relative_l2_gauss", "relative_h1_gauss", "relative_velocity_l2",
                            "relative_stress_l2", "l2", "cpu_s", "pair_evaluations"})
      row.push_back(cell(level, key));
    table.rows.push_back(std::move(row));
    table.row_jobs.push_back(job);
  }
  table.jobs.push_back(job);
}

Figure orders_figure(std::string id, std::string title, const DataTable& fits, const std::string& norm) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto value = [](const Entry& entry) {
    const auto* found = std::get_if<double>(&entry);
    return found ? *found : nan;
  };
  Intervals rows;
  for (const auto& row : fits.rows) {
    const auto in = [&](const char* column) -> const Entry& { return cell_of(fits, row, column); };
    if (std::get<std::string>(in("norm")) != norm) continue;
    rows.names.push_back(std::get<std::string>(in("study")));
    rows.value.push_back(value(in("order")));
    rows.low.push_back(value(in("95 % from")));
    rows.high.push_back(value(in("to")));
    rows.expected.push_back(value(in("declared")));
  }
  if (rows.names.empty()) throw MissingResult("no fits of " + norm);
  double least = 0, most = 2.5;
  for (const auto* values : {&rows.low, &rows.high, &rows.value})
    for (const double v : *values)
      if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  Picture picture{
      std::move(title), {"order of the error in " + shown_norm(norm), "", Scale::linear}, {"", ""}};
  picture.x.min = std::max(least - 0.1, -1.0);
  picture.x.max = std::min(most + 0.1, 5.0);
  picture.height = 110 + 20 * static_cast<int>(rows.names.size());
  picture.map = std::move(rows);
  return {std::move(id), std::move(picture),
          "Fitted orders with their 95 % intervals; the grey stroke is "
          "the declared order. A triangle: the interval does not hold it.",
          fits.jobs};
}

void add_interval(Series& series, const Json& result, const std::string& norm) {
  const Json& fit = fit_of(result, norm);
  const Entry low = end_of(fit, 0), high = end_of(fit, 1);
  if (!std::holds_alternative<double>(low) || !std::holds_alternative<double>(high)) return;
  const double from = std::get<double>(low), to = std::get<double>(high);
  const auto levels = std::min(series.x.size(), fit.at("levels").get<std::size_t>());
  if (!(to - from <= 2) || levels < 3) return;
  std::vector<std::size_t> order(series.x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return series.x[a] > series.x[b]; });
  double x = 0, y = 0;
  for (std::size_t k = 0; k < levels; ++k) {
    x += std::log(series.x[order[k]]) / static_cast<double>(levels);
    y += std::log(series.y[order[k]]) / static_cast<double>(levels);
  }
  if (!std::isfinite(y)) return;
  Band band{series.y, series.y};
  for (std::size_t k = 0; k < levels; ++k) {
    const std::size_t at = order[k];
    const double one = std::exp(y + from * (std::log(series.x[at]) - x)),
                 other = std::exp(y + to * (std::log(series.x[at]) - x));
    band.low[at] = std::min(one, other);
    band.high[at] = std::max(one, other);
  }
  series.band = band;
}

}  // namespace plumb::reports
