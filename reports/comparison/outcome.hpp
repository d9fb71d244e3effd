#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lib/convergence/order_fit.hpp"
#include "reports/comparison/table.hpp"
#include "reports/results.hpp"

/// What became of a scheme on a problem.
namespace plumb::reports::comparison {

enum class State { ran, refused, unstable };

/// One spacing. What a broken run has no value of is absent.
struct LevelFound {
  double spacing;               ///< [m]
  std::optional<double> error;  ///< relative
  std::optional<double> cpu_s;  ///< of the steps, without set-up
  std::optional<double> steps;
};

/// Where the energy at the end came from, as shares of the energy at the start. Absent: the scheme does not
/// account for it.
struct EnergyShares {
  double change = 0;                 ///< of the total
  std::optional<double> dissipated;  ///< turned into heat by the scheme
  double plastic = 0;                ///< work of plastic flow, a part of the total
  double more = 0;         ///< other terms: hourglass energy, bonds, what forces do beyond the stress
  double unexplained = 0;  ///< change, plus what was dissipated, less the works of loads and supports
};

struct Outcome {
  State state = State::ran;
  std::string why;  ///< in the program's words, where it refused or broke
  std::vector<LevelFound> levels;
  OrderFit fit;  ///< of the errors over the spacing
  // of the finest spacing that ran to its end
  std::optional<double> bytes_per_particle, peak_rss;  ///< [bytes]
  std::optional<double> linear_drift, angular_drift;   ///< relative
  std::optional<EnergyShares> energy;
  std::string note;
  bool other_law = false;  ///< a part of its error is its law

  /// The level of the finest spacing, if it has an error.
  std::optional<LevelFound> finest() const;
  /// It may be recommended: every spacing ran, and it solves the problem that was set.
  bool sound() const { return state == State::ran && !other_law; }
};

/// Reads what the jobs of a cell gave. Throws MissingResult if a job has no result and the table does not say
/// that the scheme refuses.
Outcome outcome_of(const Results& results, const Problem& problem, const Scheme& scheme);

/// The distance of what was measured from its truth, over the scale. `summary` is of a run, `series` its
/// columns. Empty if it cannot be read: the body has not come back to rest.
std::optional<double> error_of(const Quantity& quantity, double spacing,
                               const nlohmann::ordered_json& summary,
                               const std::map<std::string, std::vector<double>>& series);

/// The run time at which a scheme has an error of that size for good: between two spacings along a straight
/// line in logarithms.
struct CostAtError {
  double cpu_s;
  bool at_most = false;  ///< the coarsest spacing has a smaller error already
};

/// Empty if the finest spacing has a larger error, or none.
std::optional<CostAtError> cost_at(const Outcome& outcome, double error);

}  // namespace plumb::reports::comparison
