#pragma once
#include "lib/core/field.hpp"

namespace plumb {

/// The evolving unknowns. The displacement is kept instead of the position: F = I + sum (u_j - u_i) (x) c_ij
/// has no cancellation for small strains, and empty slots (u = 0) have F = I.
template <int d>
struct State {
  Field u;          ///< displacement x - X [m]
  Field v;          ///< velocity [m/s]; the paper's momentum is rho_0 v
  double time = 0;  ///< [s]
  long step = 0;
};

}  // namespace plumb
