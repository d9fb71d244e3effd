#include "verification/plumb/foreign/export_solution.hpp"

#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "lib/core/dimension.hpp"
#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/table.hpp"
#include "mms/export/source_text.hpp"
#include "verification/plumb/foreign/points.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

template <int d>
std::vector<std::string> heads() {
  const std::string axes = "xyz", large = "XYZ";
  std::vector<std::string> names;
  for (int a = 0; a < d; ++a) names.push_back(fmt::format("{} [m]", large[static_cast<std::size_t>(a)]));
  for (const auto& [key, unit] : {std::pair("u", "m"), {"v", "m/s"}, {"a", "m/s^2"}})
    for (int a = 0; a < d; ++a)
      names.push_back(fmt::format("{}{} [{}]", key, axes[static_cast<std::size_t>(a)], unit));
  for (const auto& [key, unit] : {std::pair("F", ""), {"P", " [Pa]"}})
    for (int i = 1; i <= d; ++i)
      for (int A = 1; A <= d; ++A) names.push_back(fmt::format("{}{}{}{}", key, i, A, unit));
  for (const auto& [key, unit] : {std::pair("b", "N/m^3"), {"g", "N/kg"}, {"s", "N/m^3"}})
    for (int a = 0; a < d; ++a)
      names.push_back(fmt::format("{}{} [{}]", key, axes[static_cast<std::size_t>(a)], unit));
  return names;
}

template <int d>
Table table_at(const SolutionChoice& choice, const std::vector<double>& positions, double time) {
  const mms::ExactFields<d> exact = choice.fields<d>();
  Table table{heads<d>(), {}};
  for (std::size_t k = 0; k < positions.size(); k += 3) {
    const Vec<d> X = Eigen::Map<const Vec<d>>(positions.data() + k);
    const mms::Motion<d> m = exact.motion(X, time);
    const Mat<d> P = exact.first_piola(X, time);
    const Vec<d> b = exact.body_force(X, time);
    std::vector<Cell> row;
    for (const Vec<d>& v : {X, m.displacement, m.velocity, m.acceleration})
      row.insert(row.end(), v.data(), v.data() + d);
    for (const Mat<d>& M : {m.F, P})
      for (int i = 0; i < d; ++i)
        for (int A = 0; A < d; ++A) row.emplace_back(M(i, A));
    for (const Vec<d>& v : {b, Vec<d>(b / exact.density), Vec<d>(-exact.stress_divergence(X, time))})
      row.insert(row.end(), v.data(), v.data() + d);
    table.rows.push_back(row);
  }
  return table;
}

std::string exported(const ExportOptions& options) {
  SolutionOptions asked = options.solution;
  if (options.format != "csv") {
    if (!options.points.empty() || !options.time.empty())
      throw InputError("--at and --time with --export " + options.format,
                       "source text holds for all points and times", "leave them out, or export csv");
    const SolutionChoice choice = solution_choice(asked);
    return mms::source_text(options.format, choice.name, choice.dimension, choice.parameters, choice.elastic,
                            choice.law);
  }
  if (options.points.empty() || options.time.empty())
    throw InputError("--export csv without points or time", "a table has values at some points and one time",
                     "give --at POINTS.csv and --time \"5 ms\"");
  const PointFile points = read_points(options.points);
  if (asked.dimension == 0 && mms::solution_entry(asked.name).dimensions.size() > 1)
    asked.dimension = dimension_of(points);
  return values_at(solution_choice(asked), points.positions, seconds_of(options.time));
}

}  // namespace

std::string values_at(const SolutionChoice& choice, const std::vector<double>& positions, double time) {
  return csv_text(
      plumb::with_dimension(choice.dimension, [&]<int d>() { return table_at<d>(choice, positions, time); }));
}

int export_solution(const Session& session, const ExportOptions& options) {
  if (!options.out.empty()) require_writable(options.out, "--out");
  const std::string text = exported(options);
  if (options.out.empty())
    std::cout << text;
  else
    replace_file(options.out, text);
  session.write_json({{"solution", options.solution.name}, {"format", options.format}, {"out", options.out}});
  return 0;
}

}  // namespace plumb::app
