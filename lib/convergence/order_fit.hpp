#pragma once
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace plumb {

/// One level of a refinement study.
struct Level {
  double spacing;    ///< [m] (or any positive measure of the resolution: a time step, 1/N)
  double error;      ///< norm of the error, or a signed error; any unit, the same for all levels
  double floor = 0;  ///< size of what refinement does not reduce at this level (e.g. eps/dx); 0 if unknown
};

/// What a fit has to know beside the errors.
struct FitOptions {
  /// Round-off part of every error, in the unit of the error. The default fits a quantity of size 1: some
  /// tens of units in the last place. Multiply it by the size of the quantity.
  double round_off = 64 * std::numeric_limits<double>::epsilon();
  /// Difference between the model that is computed and the exact solution of another one (e.g. finite against
  /// infinitesimal strain), in the unit of the error.
  double modelling_floor = 0;
  /// Levels with |error| <= floor_factor * floor are not fitted. At ten floors the logarithm of the error is
  /// off by at most 0.1, which moves the order of four halvings by at most 0.05.
  double floor_factor = 10;
  double confidence = 0.95;
  /// One weight per level, proportional to 1/variance of log(error); empty: all equal.
  std::span<const double> weights = {};
};

/// Order of convergence p of error = C spacing^p.
/// Orders are signed: errors that grow under refinement have a negative order. NaN means "not determined"
/// (too few levels) and is written as null; the verdict says why.
struct OrderFit {
  double order = std::numeric_limits<double>::quiet_NaN();  ///< from at least 2 usable levels
  double lower =
      std::numeric_limits<double>::quiet_NaN();  ///< ends of the interval, from at least 3 usable levels
  double upper = std::numeric_limits<double>::quiet_NaN();
  double log_constant = std::numeric_limits<double>::quiet_NaN();  ///< ln C
  /// Change of the local slope over the fitted range, from coarsest to finest (weighted quadratic fit in
  /// logarithms); 0 for an exact power law. Needs 3 usable levels.
  double drift = std::numeric_limits<double>::quiet_NaN();
  /// Half-width of the interval of the drift, from the residuals of the quadratic fit. Needs 4 usable levels.
  double drift_half_width = std::numeric_limits<double>::quiet_NaN();
  /// Order between each level and the next finer one, for all given levels, fitted or not. NaN where an error
  /// is 0 or not finite, or where its sign changes.
  std::vector<double> pairwise;
  std::vector<double> levels;      ///< spacings of the fitted levels, coarse to fine
  std::vector<double> errors;      ///< |error| of the fitted levels
  std::size_t given = 0;           ///< levels handed in
  std::size_t at_round_off = 0;    ///< levels left out because of round-off
  std::size_t at_model_floor = 0;  ///< levels left out because of the modelling floor
  std::size_t not_finite = 0;      ///< levels left out because the error is infinite or NaN (the run broke)
  bool sign_changes = false;       ///< signed errors that cross zero
  double half_width() const { return (upper - lower) / 2; }
};

/// Weighted least-squares fit of ln|error| = ln C + p ln spacing over the levels above the floor (GSL), with
/// the Student-t interval of p for n - 2 degrees of freedom (Boost.Math); the scatter is estimated from the
/// residuals. Levels may come in any order and with any refinement ratio. A level at the floor ends the
/// usable range: the finer ones are left out too. THEORY: lib/convergence/README.md. Throws InputError for
/// spacings that are not positive, not finite or equal, and for weights of another number.
OrderFit fit_order(std::span<const Level> levels, const FitOptions& options = {});

/// Fits an order to levels that count by weights, one per level.
OrderFit fit_order(std::span<const Level> levels, std::span<const double> weights);

/// Signed order between two levels: ln(coarse/fine errors) / ln(coarse/fine spacings). NaN if it does not
/// exist.
double pairwise_order(const Level& coarse, const Level& fine);

}  // namespace plumb
