#include "verification/plumb/fit_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/norm_units.hpp"
#include "lib/convergence/words.hpp"

namespace plumb::app {
namespace {

/// "order 2.016 [1.856, 2.177] from 4 of 5 levels".
std::string order_text(const OrderFit& fit) {
  std::string text = std::isfinite(fit.order) ? fmt::format("order {:.3f}", fit.order) : "no order";
  if (std::isfinite(fit.lower)) text += fmt::format(" [{:.3f}, {:.3f}]", fit.lower, fit.upper);
  text += fmt::format(" from {}", fit.levels.size());
  if (fit.levels.size() != fit.given) text += fmt::format(" of {}", fit.given);
  return text + (fit.given == 1 ? " level" : " levels");
}

}  // namespace

std::string fits_text(const std::vector<FitLine>& lines) {
  std::size_t width = 0;
  for (const FitLine& line : lines) width = std::max(width, line.name.size());
  std::string text, meanings;
  std::vector<std::string> explained{"pass", "asymptotic"};
  for (const FitLine& line : lines) {
    text += fmt::format("{:<{}}  {}{}: {}\n", line.name, width, order_text(line.fit),
                        line.declared ? fmt::format(", declared {:g}", *line.declared) : "", line.verdict);
    if (std::find(explained.begin(), explained.end(), line.verdict) != explained.end()) continue;
    explained.push_back(line.verdict);
    meanings += fmt::format("  {}: {}\n", line.verdict, meaning_of(line.verdict));
  }
  return text + meanings;
}

nlohmann::ordered_json with_units(const nlohmann::ordered_json& levels, int dimension) {
  const auto head = [dimension](const std::string& key) {
    if (key == "d") return std::string("d [m]");
    if (key == "dt") return std::string("dt [s]");
    if (key.ends_with("_s")) return key.substr(0, key.size() - 2) + " [s]";
    if (key.starts_with("relative_")) return "relative " + key.substr(9);
    return with_unit(key, dimension);
  };
  auto rows = nlohmann::ordered_json::array();
  for (const auto& level : levels) {
    nlohmann::ordered_json row;
    for (const auto& [key, value] : level.items()) row[head(key)] = value;
    rows.push_back(row);
  }
  return rows;
}

void point_to_verdicts(CLI::App& command) {
  command.footer(command.get_footer() + "\nVerdicts are explained by: plumb verdicts");
}

}  // namespace plumb::app
