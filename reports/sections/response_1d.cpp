#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::response_1d {
namespace {

using Json = nlohmann::ordered_json;

/// The closed forms for the cubic spline (method page of the project, from the lattice sums).
double closed_form(const std::string& estimator, double theta, bool wide) {
  const double s = std::sin(theta), c = std::cos(theta);
  if (!wide) return s;
  if (estimator == "standard") return s * std::pow(std::cos(theta / 2), 4);
  if (estimator == "improved") return s * (5 + 3 * c + c * c) / 9;
  return s * (17 + 6 * c + c * c) / 36;
}

double worst_difference(const Json& rows, const std::string& estimator, bool wide) {
  double worst = 0;
  for (const auto& row : rows)
    if (text(row, "estimator") == estimator)
      worst = std::max(worst,
                       std::abs(number(row, "value") - closed_form(estimator, number(row, "theta"), wide)));
  return worst;
}

/// The response at the shortest wave that the lattice carries, theta = pi.
double at_alternating(const Json& rows) {
  double worst = 0;
  for (const auto& row : rows)
    if (number(row, "theta") > 3.1415926) worst = std::max(worst, std::abs(number(row, "value")));
  return worst;
}

/// The share of a wave that an estimate sees: its response over theta, where theta is nearest to the one
/// given.
double share_at(const Json& rows, const std::string& estimator, double theta) {
  double nearest = 10, share = 0;
  for (const auto& row : rows)
    if (const double away = std::abs(number(row, "theta") - theta);
        text(row, "estimator") == estimator && away < nearest) {
      nearest = away;
      share = number(row, "value") / number(row, "theta");
    }
  return share;
}

Figure figure(const Json& rows, const std::string& job, const std::string& id, const std::string& title,
              const std::vector<std::string>& estimators) {
  Picture p{title, {"θ = k Δx", "rad"}, {"response (exact: θ)", "rad"}};
  p.labels = Labels::legend;
  for (const auto& estimator : estimators)
    p.series.push_back(
        series_of(rows, {{"estimator", estimator}}, "theta", "value", estimator, Style::lines));
  Series exact = p.series[0];
  exact.label = "exact";
  exact.y = exact.x;
  exact.colour = 6;
  p.series.push_back(exact);
  return {id, p, "Cubic B-spline, W1, inside a uniform lattice.", {job}};
}

Section write(const Results& results) {
  const Json wide = results.json("response-4").at("rows"), narrow = results.json("response-1.8").at("rows");
  Section s;
  s.question = "Which waves does each estimate see inside a uniform lattice?";
  for (const char* estimator : {"standard", "bond", "improved"})
    s.checks.push_back(
        bound_check(fmt::format("{} at R = 4Δx against its closed form, largest difference", estimator),
                    worst_difference(wide, estimator, true), 1e-12, "round-off"));
  for (const char* estimator : {"standard", "improved"})
    s.checks.push_back(bound_check(fmt::format("{} at R = 1.8Δx is the central difference sin θ", estimator),
                                   worst_difference(narrow, estimator, false), 1e-12, "round-off"));
  const double alternating = std::max(at_alternating(wide), at_alternating(narrow));
  const bool blind = alternating < 1e-12;
  s.answer =
      blind ? fmt::format(
                  "None sees the alternating mode θ = π (largest response {:.0e}); of the wave θ = 3π/4 the "
                  "improved estimate sees {:.0f} %, the standard one {:.0f} % (R = 4Δx).",
                  alternating, 100 * share_at(wide, "improved", 0.75 * std::numbers::pi),
                  100 * share_at(wide, "standard", 0.75 * std::numbers::pi))
            : fmt::format("At θ = π the largest response is {:.3g}.", alternating);
  s.figures = {
      figure(wide, "response-4", "response-wide", "Response at R = 4Δx", {"standard", "bond", "improved"}),
      figure(narrow, "response-1.8", "response-narrow", "Response at R = 1.8Δx (β = 0.9)",
             {"standard", "improved"})};
  s.tables = {
      account("account-response", "What the paper says about zero-energy modes",
              {{"section 4", "the more accurate estimate of the gradient suppresses zero-energy modes",
                blind ? "contradicted" : "open",
                fmt::format("inside a uniform lattice every estimate gives {:.0e} or less for the "
                            "alternating mode, so it costs no "
                            "energy; at R = 1.8Δx standard and improved are one operator",
                            alternating)}},
              {"response-4", "response-1.8"})};
  return s;
}

}  // namespace

/// Interior response of the estimates to exp(ikX).
SectionPlan planned(Extent) {
  const auto at = [](const char* ratio, const char* estimators) {
    return std::vector<std::string>{"oned",        "response", "--radius-over-dx", ratio,
                                    "--estimator", estimators, "--pair",           "W1",
                                    "--points",    "200"};
  };
  return {
      140,
      "response",
      "Response to waves",
      {{"response-4", at("4", "standard,bond,improved")}, {"response-1.8", at("1.8", "standard,improved")}},
      write};
}

}  // namespace plumb::reports::sections::response_1d
