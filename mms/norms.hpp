#pragma once
#include <functional>
#include <vector>

#include "lib/geometry/ghosts.hpp"
#include "lib/kernel/correction.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "mms/error_norms.hpp"

namespace plumb::mms {

/// Displacement [m], its gradient (dimensionless), velocity [m/s] and first Piola-Kirchhoff stress [Pa] at
/// one point.
template <int d>
struct PointValue {
  Vec<d> u = Vec<d>::Zero();
  Mat<d> gradient = Mat<d>::Zero();
  Vec<d> v = Vec<d>::Zero();
  Mat<d> stress = Mat<d>::Zero();
};

/// What a scheme knows at its particles: u_i, F_i - I and P(F_i) with the scheme's own F, and v_i.
template <int d>
using NodalValues = std::vector<PointValue<d>>;

/// P of F [Pa].
template <int d>
using StressFunction = std::function<Mat<d>(const Mat<d>& F)>;

/// Collects what the scheme knows at its particles, with the stress that `stress` makes of its F.
template <int d>
NodalValues<d> nodal_values(const Solid<d>& solid, const State<d>& state, const StressFunction<d>& stress);

/// Compares the stress that a body shows with what the law of the solution makes of its F, particle by particle. They come
/// by two paths: the scene's material through the scheme, and the solution's own. Throws std::logic_error if they differ
/// by more than rounding. `modulus`: rho c^2 [Pa], the size of a stress at a strain of one.
template <int d>
void require_same_law(const NodalValues<d>& by_body, const NodalValues<d>& by_solution, double modulus);

/// a - b, particle by particle.
template <int d>
NodalValues<d> difference(const NodalValues<d>& a, const NodalValues<d>& b);

/// The field that the numerical one is compared with, as a function of X.
template <int d>
using ExactField = std::function<PointValue<d>(const Vec<d>& X)>;

/// Nodal norms: the integrals are sums over particles with their volumes, the gradient is F_i - I and the
/// stress P(F_i).
template <int d>
ErrorNorms nodal_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact);

/// Computes the norms of the exact field itself: what an error is relative to.
template <int d>
ErrorNorms nodal_size(const Cloud<d>& cloud, const ExactField<d>& exact);

/// How fields are interpolated between particles: with the corrected pair of the scheme,
///   u_h(X) = sum V_j u_j W~_j(X),  Grad u_h(X) = sum V_j u_j (x) grad W~_j(X),
/// velocity and stress as u_h, from v_j and P(F_j).
template <int d>
struct Interpolation {
  RadialKernel<d> kernel;
  double smoothing_length;  ///< h [m]
  Correction pair;
  std::vector<Wall> walls = {};  ///< with images behind them, which carry the mirrored displacement
};

/// The paper's norms: `tiles` equal tiles per axis over the cloud's box with `points` Gauss points each (5.1:
/// 10 and 5). linf is the largest error over these points. Throws InputError if a point lies where the
/// correction is singular (cell layout with a small support: the corner points see one particle).
template <int d>
ErrorNorms gauss_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact,
                       const Interpolation<d>& interpolation, int tiles = 10, int points = 5);

/// Computes the norms of the exact field itself, by the points of gauss_norms().
template <int d>
ErrorNorms gauss_size(const Box<d>& box, const ExactField<d>& exact, int tiles = 10, int points = 5);

}  // namespace plumb::mms
