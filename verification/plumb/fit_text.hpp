#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lib/convergence/order_fit.hpp"

namespace CLI {
class App;
}

namespace plumb::app {

/// One fitted order as a line for people.
struct FitLine {
  std::string name;  ///< of the norm, the operator or the integrator
  const OrderFit& fit;
  std::optional<double> declared;
  std::string verdict;  ///< a word of lib/convergence/words.hpp
};

/// Writes the lines below each other with their orders in one column: "l2  order 2.016 [1.856, 2.177] from 4
/// levels, declared 2: pass". Where no order exists it says so, and where no interval exists there is none.
/// Then every word that is neither "pass" nor "asymptotic" is explained once.
std::string fits_text(const std::vector<FitLine>& lines);

/// Renames the columns of levels for people: "d" as "d [m]", "dt" as "dt [s]", "relative_l2" as "relative
/// l2", "l2" as "l2 [m^2]" in 2D.
nlohmann::ordered_json with_units(const nlohmann::ordered_json& levels, int dimension);

/// Says in the help of a command where its verdicts are explained.
void point_to_verdicts(CLI::App& command);

}  // namespace plumb::app
