#pragma once
#include <functional>
#include <vector>

#include "plumbline/geometry/ghosts.hpp"
#include "plumbline/gradient/correction.hpp"
#include "plumbline/solid/solid.hpp"

namespace plumb::mms {

/// Displacement [m] and its gradient (dimensionless) at one point.
template <int d>
struct PointValue {
  Vec<d> u = Vec<d>::Zero();
  Mat<d> gradient = Mat<d>::Zero();
};

/// Displacements and gradients at the particles: u_i and F_i - I with the scheme's own F.
template <int d>
using NodalValues = std::vector<PointValue<d>>;

template <int d>
NodalValues<d> nodal_values(const Solid<d>& solid, const State<d>& state);

/// a - b, particle by particle.
template <int d>
NodalValues<d> difference(const NodalValues<d>& a, const NodalValues<d>& b);

/// The field that the numerical one is compared with, as a function of X.
template <int d>
using ExactField = std::function<PointValue<d>(const Vec<d>& X)>;

/// Absolute norms of an error. In d dimensions l2 has the unit m^(1 + d/2), h1 m^(d/2), linf m.
struct ErrorNorms {
  double l2 = 0;    ///< (44): square root of the integral of |u - u_h|^2
  double h1 = 0;    ///< (45): seminorm, the same for the gradients
  double linf = 0;  ///< largest |u - u_h|
};

/// Nodal norms: the integrals are sums over particles with their volumes, the gradient is F_i - I.
template <int d>
ErrorNorms nodal_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact);

/// How fields are interpolated between particles: with the corrected pair of the scheme,
///   u_h(X) = sum V_j u_j W~_j(X),  Grad u_h(X) = sum V_j u_j (x) grad W~_j(X).
template <int d>
struct Interpolation {
  RadialKernel<d> kernel;
  double smoothing_length;  ///< h [m]
  Pair pair;
  std::vector<Wall> walls = {};  ///< with images behind them, which carry the mirrored displacement
};

/// The paper's norms: `tiles` equal tiles per axis over the cloud's box with `points` Gauss points each (5.1:
/// 10 and 5). linf is the largest error over these points. Throws InputError if a point lies where the
/// correction is singular (cell layout with a small support: the corner points see one particle).
template <int d>
ErrorNorms gauss_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact,
                       const Interpolation<d>& interpolation, int tiles = 10, int points = 5);

}  // namespace plumb::mms
