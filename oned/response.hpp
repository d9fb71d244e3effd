#pragma once
#include <string>
#include <vector>

#include "oned/gradient.hpp"

namespace plumb::oned {

/// One line of `plumb oned response`.
struct ResponseRow {
  double theta;  ///< k dx, in (0, pi]
  std::string estimator;
  Correction pair;
  double value;  ///< dx times the estimate of the derivative of exp(ikX), over i exp(ikX); theta if it were
                 ///< exact
};

/// Response of an estimate inside the infinite uniform lattice to exp(ikX) at theta = k dx. The stencil c of
/// a particle gives dx sum_j c_j sin(j theta); the cosines cancel, since c_-j = -c_j.
std::vector<double> response(const RadialKernel<1>& kernel, double radius_over_dx,
                             const GradientMethod& method, const std::vector<double>& thetas);

/// All methods at theta = pi/points, 2 pi/points, .., pi.
std::vector<ResponseRow> response_rows(const std::string& kernel, double radius_over_dx,
                                       const std::vector<GradientMethod>& methods, Index points);

}  // namespace plumb::oned
