#pragma once
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/convergence/order_fit.hpp"

namespace plumb {

/// A computed quantity on one grid.
struct Sample {
  double spacing;  ///< [m]
  double value;    ///< any unit, the same on all grids
};

/// Grid convergence index of one grid against the next coarser one: Fs |f1 - f2| / (r^p - 1).
struct GridIndex {
  double absolute = 0;             ///< [unit of the value]
  std::optional<double> relative;  ///< over |f1|, the value of the finer grid [1]; none where that is zero
};

/// Richardson extrapolation from the three finest grids, and the grid convergence index of every pair of
/// neighbouring grids (Roache 1994; ASME V&V 20; Celik et al., J. Fluids Eng. 130, 078001, 2008).
struct Extrapolation {
  enum class Behaviour {
    monotone,     ///< the differences shrink with one sign: order, limit and index exist
    oscillatory,  ///< the differences change sign: no order can be read off three grids
    divergent,    ///< the differences do not shrink as the grid is refined
    converged     ///< the finest difference is at round-off: nothing to extrapolate
  };
  Behaviour behaviour = Behaviour::divergent;
  /// The following exist (are not NaN, not empty) for `monotone` only.
  double order = std::numeric_limits<double>::quiet_NaN();  ///< observed order
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< value at spacing 0 [unit of the value]
  /// One per pair, finest first, with the order of the pair's own three grids (of the three finest where they
  /// have none or are not three).
  std::vector<GridIndex> gci;
  /// Index of the second pair over r^p times that of the first, 1 in the asymptotic range. None where it
  /// cannot fail: with three grids and their own order it is 1 by construction. With a declared order it is
  /// formed with that, else from four grids, with the orders of the three finest and of the next three.
  std::optional<double> asymptotic_ratio;
};

/// Extrapolates from three grids or more, of any refinement ratio above 1.05 (below it, differences drown).
/// The safety factor is Roache's 1.25 for studies of three grids and more. Throws InputError otherwise.
Extrapolation richardson(std::span<const Sample> samples, double safety = 1.25,
                         std::optional<double> declared_order = {});

/// The grids from fine to coarse. Throws InputError for values that are not finite, spacings that are not
/// positive, and ratios below 1.05.
std::vector<Sample> fine_to_coarse(std::span<const Sample> samples);

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

/// Gives the word of a behaviour, as in words.hpp: "monotone", "oscillatory".
std::string_view name_of(Extrapolation::Behaviour behaviour);

}  // namespace plumb
