#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::gradients_1d {
namespace {

using Json = nlohmann::ordered_json;

constexpr double dx = 0.125;  // spacing of Figures 4 and 5 [m]

/// The method of one line: its keys in the JSON and its name.
struct Method {
  std::string estimator, pair, name;
};
const std::vector<Method> methods{{"standard", "W1", "standard, W1"},
                                  {"improved", "W1", "improved, W1"},
                                  {"improved", "W0", "improved, W0"}};

Json rows_of(const Json& rows, const std::string& estimator, const std::string& pair) {
  Json out = Json::array();
  for (const auto& row : rows)
    if (text(row, "estimator") == estimator && text(row, "pair") == pair) out.push_back(row);
  if (out.empty()) throw MissingResult("no rows for " + estimator + " " + pair);
  return out;
}

/// Positions of the first particle and of one that no end is near to [m].
constexpr double first = 0.5 * dx, inside = 20.5 * dx;

/// The error at the particle at X.
double error_at(const Json& rows, const std::string& estimator, const std::string& pair, double X) {
  return number(row_at(rows_of(rows, estimator, pair), "X", X), "error");
}

/// The largest error of the standard and the improved estimate with W1.
double worst_of_exact(const Json& rows) {
  double worst = 0;
  for (const char* estimator : {"standard", "improved"})
    for (const auto& row : rows_of(rows, estimator, "W1"))
      worst = std::max(worst, std::abs(number(row, "error")));
  return worst;
}

Figure linear(const Json& rows) {
  Picture p{"Figure 4b: estimates for x = X + 1", {"position X", "m"}, {"estimate of dx/dX", ""}};
  for (const char* estimator : {"standard", "bond", "improved"})
    p.series.push_back(series_of(rows, {{"estimator", estimator}}, "X", "value", estimator));
  p.lines = {{1, "exact"}};
  return {"fig4b",
          p,
          fmt::format(
              "Cubic B-spline, W1, Δx = 1/8 m, R = 4Δx. The standard and the improved estimate are within "
              "{:.0e} of the exact line.",
              worst_of_exact(rows)),
          {"gradient-linear"}};
}

Figure compared(const Json& rows, const std::string& job, const std::string& id, const std::string& title,
                bool errors) {
  Picture p{title, {"position X", "m"}, {errors ? "error of the estimate" : "estimate of dx/dX", ""}};
  for (const auto& m : methods)
    p.series.push_back(series_of(rows, {{"estimator", m.estimator}, {"pair", m.pair}}, "X",
                                 errors ? "error" : "value", m.name));
  if (errors) p.lines = {{0, ""}};
  return {id,
          p,
          errors ? "The same as errors: estimate minus exact value." : "Cubic B-spline, Δx = 1/8 m, R = 4Δx.",
          {job}};
}

std::vector<Check> checks(const Json& line, const Json& square, const Json& cube) {
  const std::string exact = "exact rational of the lattice, round-off";
  const auto bond = rows_of(line, "bond", "W1");
  return {bound_check("standard and improved are exact for x = X + 1 (largest error)", worst_of_exact(line),
                      1e-12, "round-off"),
          number_check("plain bond for x = X + 1, inside", number(row_at(bond, "X", inside), "value"),
                       2.0 / 3, 1e-12, exact),
          number_check("plain bond for x = X + 1, first particle", number(row_at(bond, "X", first), "value"),
                       71.0 / 583, 1e-12, exact),
          number_check("X²: standard W1, first particle, error / (f'' Δx)",
                       std::abs(error_at(square, "standard", "W1", first)) / (2 * dx), 267780.0 / 339889,
                       1e-12, exact),
          number_check("X²: improved W1, first particle, error / (f'' Δx)",
                       std::abs(error_at(square, "improved", "W1", first)) / (2 * dx), 0.691899, 1e-6,
                       "six digits known"),
          number_check("X²: improved W0, first particle, error / (f'' Δx)",
                       std::abs(error_at(square, "improved", "W0", first)) / (2 * dx), 8291.0 / 9664, 1e-12,
                       exact),
          number_check("X³: standard W1, inside, error / (f''' Δx²)",
                       error_at(cube, "standard", "W1", inside) / (6 * dx * dx), 2.0 / 3, 1e-10, exact),
          number_check("X³: improved W1, inside, error / (f''' Δx²)",
                       error_at(cube, "improved", "W1", inside) / (6 * dx * dx), 4.0 / 9, 1e-10, exact)};
}

Section write(const Results& results) {
  const Json line = results.json("gradient-linear").at("rows"),
             square = results.json("gradient-square").at("rows"),
             cube = results.json("gradient-cube").at("rows");
  Section s;
  s.question = "What does each estimate make of a linear, a quadratic and a cubic field?";
  s.checks = checks(line, square, cube);
  const auto ratio = [](const Json& rows, double X) {
    return error_at(rows, "improved", "W1", X) / error_at(rows, "standard", "W1", X);
  };
  s.answer = fmt::format(
      "At R = 4Δx the improved estimate has {:.3g} of the standard one's error inside (X³) and {:.3g} at "
      "the first particle (X²); the plain bond estimate gives {:.4g} in place of 1 for a linear field.",
      ratio(cube, inside), ratio(square, first),
      number(row_at(rows_of(line, "bond", "W1"), "X", inside), "value"));
  s.figures = {linear(line),
               compared(square, "gradient-square", "fig5a", "Figure 5a: estimates for x = X² + 1", false),
               compared(square, "gradient-square", "fig5a-error", "Figure 5a as errors: x = X² + 1", true),
               compared(cube, "gradient-cube", "fig5b", "Figure 5b: estimates for x = X³ + 1", false),
               compared(cube, "gradient-cube", "fig5b-error", "Figure 5b as errors: x = X³ + 1", true)};
  s.notes = {
      "The paper does not state the set-up of Figure 5; that of "
      "Figure 4 and the fields X² + 1 and X³ + 1 are assumed."};
  return s;
}

}  // namespace

/// Figures 4 and 5 of paper 000: estimates of the gradient of polynomials.
SectionPlan planned(Extent) {
  const auto of = [](const char* field, const char* estimators, const char* pairs) {
    return std::vector<std::string>{"oned",        "gradient",         "--length", "5",       "--n",
                                    "40",          "--radius-over-dx", "4",        "--field", field,
                                    "--estimator", estimators,         "--pair",   pairs};
  };
  return {120,
          "gradients",
          "Gradient estimates in one dimension",
          {{"gradient-linear", of("poly:1,1", "standard,bond,improved", "W1")},
           {"gradient-square", of("poly:1,0,1", "standard,improved", "W1,W0")},
           {"gradient-cube", of("poly:1,0,0,1", "standard,improved", "W1,W0")}},
          write};
}

}  // namespace plumb::reports::sections::gradients_1d
