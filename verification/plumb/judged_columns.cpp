#include "verification/plumb/judged_columns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "lib/convergence/status.hpp"
#include "lib/convergence/verdict.hpp"
#include "lib/core/error.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const JudgedColumn& column) {
  Json levels = Json::array();
  for (const RunsOfLevel& run : column.runs)
    levels.push_back({{"h", run.spacing},
                      {"error", run.typical()},
                      {"runs", run.values.size()},
                      {"spread", run.spread() ? Json(*run.spread()) : Json()}});
  return {{"norm", column.name},
          {"order", column.fit.order},
          {"ci95", {column.fit.lower, column.fit.upper}},
          {"pairwise", column.fit.pairwise},
          {"drift", column.fit.drift},
          {"levels", column.fit.levels.size()},
          {"declared", column.declared ? Json(*column.declared) : Json()},
          {"verdict", column.verdict},
          {"rows", levels}};
}

reports::Picture picture_of(const std::string& title, const std::vector<JudgedColumn>& columns) {
  reports::Picture picture;
  picture.title = title;
  picture.x = {"spacing", "", reports::Scale::log};
  picture.y = {"error", "", reports::Scale::log};
  picture.labels = reports::Labels::legend;
  for (const JudgedColumn& column : columns) {
    reports::Series series;
    series.label = column.name;
    for (const RunsOfLevel& run : column.runs)
      series.x.push_back(run.spacing), series.y.push_back(std::abs(run.typical()));
    if (column.declared && picture.triangles.empty())
      picture.triangles.push_back({*column.declared, picture.series.size()});
    picture.series.push_back(series);
  }
  return picture;
}

}  // namespace

JudgedColumn judged_column(const std::string& name, std::vector<RunsOfLevel> runs,
                           std::optional<double> declared) {
  JudgedColumn column{name, std::move(runs), {}, declared, {}};
  std::vector<Level> levels;
  for (const RunsOfLevel& run : column.runs) levels.push_back({run.spacing, run.typical()});
  FitOptions options;
  options.round_off = 0;  // the unit of the errors is not known, so their floor is not either
  column.fit = fit_order(levels, options);
  column.verdict = declared ? name_of(judge(column.fit, *declared)) : name_of(classify(column.fit));
  return column;
}

std::vector<std::optional<double>> declared_orders(const std::vector<double>& expect, std::size_t count) {
  if (expect.size() > 1 && expect.size() != count)
    throw InputError(fmt::format("{} declared orders for {} columns of errors", expect.size(), count),
                     "each column has one", "Give one order for all of them, or one for each.");
  std::vector<std::optional<double>> orders;
  for (std::size_t k = 0; k < count; ++k)
    orders.push_back(expect.empty() ? std::nullopt : std::optional(expect[expect.size() == 1 ? 0 : k]));
  return orders;
}

std::string status_of(const std::vector<JudgedColumn>& columns) {
  std::vector<Judged> judged;
  for (const JudgedColumn& column : columns) judged.push_back({column.verdict, column.declared.has_value()});
  return std::string(status_of(judged));
}

nlohmann::ordered_json fits_json(const std::vector<JudgedColumn>& columns) {
  Json fits = Json::array();
  for (const JudgedColumn& column : columns) fits.push_back(json_of(column));
  return fits;
}

void tell_columns(const Session& session, const std::vector<JudgedColumn>& columns) {
  std::vector<FitLine> lines;
  for (const JudgedColumn& column : columns) {
    lines.push_back({column.name, column.fit, column.declared, column.verdict});
    for (const RunsOfLevel& run : column.runs)
      if (const auto spread = run.spread())
        session.text() << fmt::format("{}, h = {:g}: {:.4g} from {} runs, spread {:.2g} of it\n", column.name,
                                      run.spacing, run.typical(), run.values.size(), *spread);
  }
  session.text() << fits_text(lines);
}

void draw_columns(const Session& session, const std::string& title,
                  const std::vector<JudgedColumn>& columns) {
  if (session.plot.empty()) return;
  for (const auto& dropped : reports::save(picture_of(title, columns), session.plot))
    session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
}

}  // namespace plumb::app
