#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::kernels_1d {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::pair<std::string, std::string>> kernels{
    {"W", "W"}, {"W0", "W0 (sum 1)"}, {"W1", "W1 (first order)"}};
const std::vector<std::pair<std::string, std::string>> gradients{
    {"gradW", "∇W"}, {"LgradW", "L∇W"}, {"gradW0", "∇W0"}, {"LgradW0", "L∇W0"}, {"gradW1", "∇W1"}};

Figure figure(const Json& result, const std::string& job, const std::string& id, const std::string& title,
              const std::string& caption, bool of_gradients) {
  Picture p{
      title, {"position x", "m"}, {of_gradients ? "gradient" : "kernel", of_gradients ? "1/m²" : "1/m"}};
  p.labels = Labels::legend;
  for (const auto& [key, name] : of_gradients ? gradients : kernels)
    p.series.push_back(series_of(result.at("rows"), {}, "x", key, name, Style::lines));
  return {id, p, caption, {job}};
}

/// Largest difference of one column from another, relative to the largest value of the other.
double largest_difference(const Json& rows, const std::string& column, const std::string& reference) {
  double difference = 0, size = 0;
  for (const auto& row : rows) {
    difference = std::max(difference, std::abs(number(row, column) - number(row, reference)));
    size = std::max(size, std::abs(number(row, reference)));
  }
  return difference / size;
}

double largest(const Json& rows, const std::string& column) {
  double size = 0;
  for (const auto& row : rows) size = std::max(size, std::abs(number(row, column)));
  return size;
}

double least(const Json& rows, const std::string& column) {
  double value = number(rows.at(0), column);
  for (const auto& row : rows) value = std::min(value, number(row, column));
  return value;
}

std::vector<Check> checks(const Json& middle, const Json& wall) {
  const std::string reason = "round-off of sums over 200 particles";
  std::vector<Check> out;
  for (const auto& [result, place] : {std::pair(&middle, "x = 1"), std::pair(&wall, "x = 0")}) {
    const auto& sums = result->at("sums");
    out.push_back(bound_check(fmt::format("(5a), (5b): ΣVW1 − 1 and ΣV(X−x)W1 at {}", place),
                              std::max(std::abs(number(sums, "VW1") - 1), std::abs(number(sums, "VXW1"))),
                              1e-12, reason));
    for (const auto& [gradient, name] : {std::pair("gradW1", "∇W1"), std::pair("LgradW0", "L∇W0")})
      out.push_back(bound_check(fmt::format("(9a), (9b): ΣV{0} and ΣV(X−x){0} − 1 at {1}", name, place),
                                std::max(std::abs(number(sums, std::string("V") + gradient)),
                                         std::abs(number(sums, std::string("VX") + gradient) - 1)),
                                1e-12, reason));
  }
  return out;
}

Section write(const Results& results) {
  const Json middle = results.json("kernels-middle"), wall = results.json("kernels-wall");
  const Json &inner = middle.at("rows"), &outer = wall.at("rows");
  Section s;
  s.question =
      "Do the corrected kernels and their gradients keep "
      "constants and linear functions, in the body and at its end?";
  s.checks = checks(middle, wall);
  const bool all =
      std::all_of(s.checks.begin(), s.checks.end(), [](const Check& c) { return c.verdict == "pass"; });
  s.answer = all ? "W1 with its full gradient, and W0 with the L-corrected gradient, meet all conditions to "
                   "round-off at both places."
                 : "Not all conditions are met: see the checks.";
  const std::string where = "Cubic B-spline, Ω = (0, 2) m, 200 particles, R = 1 m. ";
  s.figures = {
      figure(middle, "kernels-middle", "fig2a", "Figure 2a: kernels seen from x = 1 m", where, false),
      figure(middle, "kernels-middle", "fig2b", "Figure 2b: gradients seen from x = 1 m", where, true),
      figure(wall, "kernels-wall", "fig2c", "Figure 2c: kernels seen from the end, x = 0", where, false),
      figure(wall, "kernels-wall", "fig2d", "Figure 2d: gradients seen from the end, x = 0", where, true)};
  const double overlap = std::max(largest_difference(inner, "W0", "W"), largest_difference(inner, "W1", "W"));
  double spread = 0;
  for (const auto& [key, name] : gradients)
    spread = std::max(spread, largest_difference(inner, key, "gradW"));
  const double peak = largest(outer, "gradW1");
  double next = 0;
  for (const auto& [key, name] : gradients)
    if (key != "gradW1") next = std::max(next, largest(outer, key));
  const auto status = [](bool holds) { return holds ? "reproduced" : "contradicted"; };
  s.tables = {
      account("account-2", "What section 2.2 says about Figure 2",
              {{"Fig. 2a", "far from the boundary the three kernels overlap", status(overlap < 1e-12),
                fmt::format("they differ by {:.1e} of the peak at x = 1 m", overlap)},
               {"Fig. 2b", "all variants of the gradient share the same values there", status(spread < 1e-12),
                fmt::format("they differ by {:.1e} of the peak at x = 1 m", spread)},
               {"Fig. 2c", "W1 is no longer positive everywhere, and its peak is the highest",
                status(least(outer, "W1") < 0 && largest(outer, "W1") > largest(outer, "W0")),
                fmt::format("its least value is {:.3g}/m, its peak {:.3g}/m against {:.3g}/m of W0",
                            least(outer, "W1"), largest(outer, "W1"), largest(outer, "W0"))},
               {"Fig. 2d", "∇W1 has the highest peak at x = 0", status(peak > next),
                fmt::format("{:.4g}/m² against {:.4g}/m² for the next", peak, next)}},
              {"kernels-middle", "kernels-wall"})};
  return s;
}

}  // namespace

/// Figure 2 of paper 000: kernels and gradients in the body and at its end.
SectionPlan planned(Extent) {
  const auto at = [](const char* x) {
    return std::vector<std::string>{"oned", "kernels", "--at", x,          "--length",
                                    "2",    "--n",     "200",  "--radius", "1"};
  };
  return {110,
          "kernels",
          "Corrected kernels in one dimension",
          {{"kernels-middle", at("1")}, {"kernels-wall", at("0")}},
          write};
}

}  // namespace plumb::reports::sections::kernels_1d
