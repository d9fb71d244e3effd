#pragma once
#include <string>
#include <utility>
#include <vector>

#include "oned/cloud.hpp"

namespace plumb::oned {

/// All kernels and gradients of one particle, as seen from the evaluation point. Kernels in [1/m], gradients
/// in [1/m^2], with respect to the evaluation point, without the volume.
struct KernelRow {
  double x;                                       ///< position of the particle [m]
  double W, W0, W1;                               ///< plain, Shepard (10), first order (6)
  double gradW, LgradW, gradW0, LgradW0, gradW1;  ///< plain; L-corrected; (13) corrected; (11); (A.4)
};

/// What `plumb oned kernels --at x` shows.
struct KernelView {
  double at, dx, R, h;  ///< [m]
  double alpha, beta;   ///< of the first-order kernel: (8) [-] and (7) [1/m]
  std::vector<std::pair<std::string, double>>
      sums;                     ///< "VW1": sum V W1 (5a), "VXgradW1": sum V (X_j - x) grad W1 (9b), ..
  std::vector<KernelRow> rows;  ///< one per particle of the support, ascending
};

/// The kernels as seen from any point x of [0, L], particle or not. InputError if x lies outside or fewer
/// than 2 particles lie in the support.
KernelView explore(const Discretisation& discretisation, double x);

/// W, W0 and W1 as functions of the place s, for the evaluation point of a view: what the kernels are between
/// the particles, too. Lists of equal length.
struct KernelCurves {
  std::vector<double> s;          ///< [m]
  std::vector<double> W, W0, W1;  ///< [1/m]
};
/// So many points over the part of the support that lies in the body.
KernelCurves kernel_curves(const Discretisation& discretisation, const KernelView& view, Index count);

}  // namespace plumb::oned
