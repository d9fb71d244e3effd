#include "verification/plumb/body_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/body.hpp"

namespace plumb::app {
namespace {

constexpr const char* von_mises = "von Mises stress [Pa]";

std::map<std::string, std::vector<double>> columns_of(const Table& table) {
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    for (const auto& row : table.rows)
      if (const auto* number = std::get_if<double>(&row[k])) columns[table.columns[k]].push_back(*number);
  return columns;
}

/// Pa, kPa, MPa or GPa: so that the largest number has one to three digits before its point.
reports::ColourScale stress_scale(double largest) {
  for (const auto& [unit, size] : {std::pair("GPa", 1e9), std::pair("MPa", 1e6), std::pair("kPa", 1e3)})
    if (largest >= size) return {"von Mises stress", unit, 1 / size, 0, largest / size};
  return {"von Mises stress", "Pa", 1, 0, largest > 0 ? largest : 1};
}

}  // namespace

template <int d>
reports::Picture body_plot(const std::string& name, const Snapshot<d>& shown, double spacing) {
  const auto columns = columns_of(Frame<d>(shown).table());
  const std::string title = fmt::format("{} at t = {:.4g} s", name, shown.time);
  const std::vector<double>& stress = columns.at(von_mises);
  if constexpr (d == 1) {
    reports::Picture picture{title, {"x", "m"}, {"von Mises stress", "Pa"}};
    picture.series.push_back({"stress", columns.at("position x [m]"), stress});
    return picture;
  } else {
    const reports::BodyState state = reports::last_state(columns, shown.time, von_mises);
    const double largest = *std::max_element(stress.begin(), stress.end());
    const reports::View view = d == 2 ? reports::View{'x', 'y', 'z'} : reports::View{'x', 'z', 'y'};
    return reports::body_picture(title, state, view, stress_scale(largest), spacing, {state});
  }
}

template reports::Picture body_plot<1>(const std::string&, const Snapshot<1>&, double);
template reports::Picture body_plot<2>(const std::string&, const Snapshot<2>&, double);
template reports::Picture body_plot<3>(const std::string&, const Snapshot<3>&, double);

}  // namespace plumb::app
