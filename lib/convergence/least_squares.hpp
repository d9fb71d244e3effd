#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/convergence/richardson.hpp"

namespace plumb {

/// What the least-squares procedure says about one grid. All in the unit of the value.
struct GridUncertainty {
  double spacing;      ///< [m]
  double value;        ///< as given
  double fitted;       ///< the expansion at this spacing
  double error;        ///< |estimated discretisation error|
  double uncertainty;  ///< U: the exact value is expected within value -U .. +U, in 95 of 100 cases
};

/// A noisy sequence of values on four grids or more, fitted by an expansion of the discretisation error
/// (Eca and Hoekstra, J. Comput. Phys. 262, 104, 2014). Made for schemes of up to second order.
struct GridFit {
  enum class Expansion {
    power,            ///< limit + a h^p
    first,            ///< limit + a h
    second,           ///< limit + a h^2
    first_and_second  ///< limit + a h + b h^2
  };
  Expansion expansion = Expansion::power;
  bool weighted = false;        ///< weights proportional to 1/h; else all equal
  std::optional<double> order;  ///< p of the power law, whether it was used or not; none: there is no least
                                ///< sum for an order from 0.01 to 20
  double limit = 0;             ///< value at spacing 0 [unit of the value]
  double deviation = 0;         ///< standard deviation of the fit, sigma [unit of the value]
  double range = 0;             ///< (largest - least value)/(grids - 1), Delta phi [unit of the value]
  double safety = 3;            ///< 1.25 for 0.5 <= p < 2.1 and sigma < Delta phi, else 3
  std::vector<GridUncertainty> grids;  ///< fine to coarse
};

/// Fits four grids or more. The power law, weighted or not, is used where its order is between 0.5 and 2;
/// above 2 the better one of `first` and `second`; below 0.5 the best of the three others. "Better" is a
/// smaller standard deviation: sum of n w_i r_i^2 over the degrees of freedom (n - 3, or n - 2 for `first`
/// and `second`). The uncertainty is Fs error + sigma + |value - fitted| if sigma < Delta phi, else 3
/// sigma/Delta phi (error + sigma + |value - fitted|). Throws InputError for fewer grids, and as
/// fine_to_coarse().
GridFit fit_grids(std::span<const Sample> samples);

/// Gives the expansion as people write it: "limit + a h^p".
std::string_view name_of(GridFit::Expansion expansion);

}  // namespace plumb
