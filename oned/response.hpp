#pragma once
#include <optional>
#include <string>
#include <utility>
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

/// Up to which waves an estimate is within an error: its share of the exact derivative stays below `error` for
/// all waves that are at least so long.
struct Resolution {
  std::string estimator;
  Correction pair;
  double error;  ///< 0.01 is 1 %
  /// k dx of the shortest such wave and its length over dx; nullopt: even long waves are off by more.
  std::optional<double> theta, particles_per_wave;
};
/// Every method with every error, by a search in 1000 waves and bisection between the two that bracket it.
std::vector<Resolution> resolutions(const std::string& kernel, double radius_over_dx,
                                    const std::vector<GradientMethod>& methods,
                                    const std::vector<double>& errors);

/// Pairs of methods (places in the list) that are one and the same operator inside a lattice.
std::vector<std::pair<std::size_t, std::size_t>> same_operators(const std::string& kernel,
                                                                double radius_over_dx,
                                                                const std::vector<GradientMethod>& methods);

/// All methods at theta = pi/points, 2 pi/points, .., pi.
std::vector<ResponseRow> response_rows(const std::string& kernel, double radius_over_dx,
                                       const std::vector<GradientMethod>& methods, Index points);

}  // namespace plumb::oned
