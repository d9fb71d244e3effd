#pragma once
#include <algorithm>
#include <cmath>

#include "lib/kernel/kernels/wendland_c2.hpp"
#include "lib/schemes/moving_pairs.hpp"

/// Sums over the pairs of the updated Lagrangian scheme. r_ij = x_i - x_j and v_ij = v_i - v_j as in paper
/// 002; w = W'(r)/r, so that the gradient of the kernel is w r_ij. Rows are summed in ascending order.
namespace plumb {

/// W'(r)/r [m^-(d+2)] of Wendland's kernel C2; not positive, and 0 from 2h on.
struct KernelSlope {
  double factor, per_reach;  ///< value at r = 0; 1/(2h) [1/m]

  double operator()(double r) const {
    const double t = std::max(0.0, 1 - r * per_reach);
    return factor * (t * t * t);
  }
};
/// In 1D the polynomial of 2D and 3D is taken, which is positive definite there too: w = 3/4 (1 - q/2)^4 (2q + 1).
template <int d>
KernelSlope wendland_slope(double h) {
  if constexpr (d == 1) return {-3.75 / (h * h * h), 0.5 / h};
  constexpr double q = 1, t = 1 - 0.5 * q;
  return {WendlandC2::dw<d>(q) / (q * t * t * t) / std::pow(h, d + 2), 0.5 / h};
}

/// Acoustic impedance of a pair, z_i z_j/(z_i + z_j) of (17).
inline double joint(double a, double b) {
  return a * b / (a + b);
}

/// The inverse of M. Where its determinant falls below `least` it is blended with I, so that it stays finite;
/// `kept` [0, 1] is then the share of the inverse, otherwise 1.
template <int d>
struct GuardedCorrection {
  Mat<d> B;
  double kept;
};
template <int d>
GuardedCorrection<d> correction_of(const Mat<d>& M, double least) {
  const double det = M.determinant();
  if (det >= least && det > 0) return {M.inverse(), 1};
  if (!(least > 0)) return {M.inverse(), 1};
  const double kept = det > 0 ? det / least : 0;
  const Mat<d> I = Mat<d>::Identity();
  return {kept > 0 ? Mat<d>(kept * M.inverse() + (1 - kept) * I) : I, kept};
}

/// Sums of Wendland's kernel on a whole lattice; the small-wave moduli of the schemes
/// follow, THEORY (17.10).
struct LatticeSums {
  double m;     ///< -sum r W' e_x^2 V: 1 in the continuum
  double xxxx;  ///< C_xxxx = -sum r W' e_x^4 V: 3/(d + 2)
  double xxyy;  ///< C_xxyy: 1/(d + 2), 0 in 1D
};
template <int d>
LatticeSums lattice_sums(double beta);

}  // namespace plumb
