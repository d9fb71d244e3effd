#pragma once
#include <span>
#include <vector>

#include "plumbline/convergence/order_fit.hpp"

namespace plumb {

/// A computed quantity on one grid.
struct Sample {
  double spacing;  ///< [m]
  double value;    ///< any unit
};

/// Richardson extrapolation and grid convergence index from the three finest grids (Roache 1994; Celik et al.
/// 2008).
struct Extrapolation {
  enum class Behaviour {
    monotone,     ///< the differences shrink with one sign: order, limit and index exist
    oscillatory,  ///< the differences change sign: no order can be read off three grids
    divergent,    ///< the differences do not shrink as the grid is refined
    converged     ///< the finest difference is at round-off: nothing to extrapolate
  };
  Behaviour behaviour = Behaviour::divergent;
  /// The following exist (are not NaN) for `monotone` only.
  double order = std::numeric_limits<double>::quiet_NaN();  ///< observed order
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< extrapolated value at spacing 0
  double gci_fine =
      std::numeric_limits<double>::quiet_NaN();  ///< Fs |f1 - f2| / (r^p - 1), unit of the value
  double gci_coarse = std::numeric_limits<double>::quiet_NaN();  ///< the same for the second grid
  /// gci_coarse / (r^p gci_fine): 1 by construction with three grids; with four or more it is formed with the
  /// order of the next coarser three, and its distance from 1 says how far the range is from asymptotic.
  double asymptotic_ratio = std::numeric_limits<double>::quiet_NaN();
};

/// Needs three grids or more, of any refinement ratio above 1.05 (below it, differences drown). The safety
/// factor is Roache's 1.25 for studies of three grids and more. Throws InputError otherwise.
Extrapolation richardson(std::span<const Sample> samples, double safety = 1.25);

/// Errors against a reference value from a finer grid, refused unless the reference is so fine that its own
/// error is at most a tenth of the finest sample's: (h_ref/h)^p <= 0.1 for the expected order p. Taking the
/// finest of the grids as the reference is refused always: three grids of ratio 2 then show log2(2^p + 1),
/// e.g. 1.585 for p = 1.
std::vector<Level> errors_against(std::span<const Sample> samples, const Sample& reference,
                                  double expected_order);

/// The order that three grids of one ratio r show when the finest is the reference: log_r(r^p + 1).
double order_seen_against_finest(double order, double ratio);
/// Its inverse: log_r(r^seen - 1). Throws InputError if no positive order can show `seen` (seen <= log_r 2).
double order_from_finest(double seen, double ratio);

}  // namespace plumb
