#pragma once
#include "lib/schemes/tlsph/compatible/area_vectors.hpp"

namespace plumb {

/// Components of A are handled together; in 3D a fourth, unused one fills the register.
template <int d>
inline constexpr int lanes = d == 3 ? 4 : d;

/// One particle's multipliers, or what its constraints lack: column 0 is l (closedness), column 1 + b column
/// b of L (exactness in X_b). Row a belongs to component a of A.
template <int d>
using MultiplierBlock = Eigen::Matrix<double, lanes<d>, d + 1>;
template <int d>
using Multipliers = std::vector<MultiplierBlock<d>>;

/// The normal matrix C W C^T of THEORY (11.5), applied bond by bond without being stored. In units of the
/// spacing.
template <int d>
struct BondOperator {
  using Row = Eigen::Matrix<double, d + 1, 1>;
  using Square = Eigen::Matrix<double, d + 1, d + 1>;

  std::vector<Vec<d>> X;                 ///< positions
  std::vector<Index> begin;              ///< per particle: its first bond; one more at the end
  std::vector<std::int32_t> other;       ///< per bond, both directions
  std::vector<double> weight;            ///< per bond: w_ij
  std::vector<Square> inverse_diagonal;  ///< of one component, with fixed volumes
  double volume_weight;                  ///< w_V; 0: fixed volumes

  Index particles() const { return static_cast<Index>(begin.size()) - 1; }
  Vec<d> half(Index i, Index bond) const { return 0.5 * (X[other[bond]] - X[i]); }
};

/// X: positions [m].
template <int d>
BondOperator<d> bond_operator(const AreaTable<d>& table, const std::vector<Vec<d>>& X, double volume_weight);

/// result = C W C^T x.
template <int d>
void apply(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result);

/// tr L of one particle: its volume shrinks by w_V times that.
template <int d>
double trace(const MultiplierBlock<d>& x);

/// Computes result = C W C^T x as if volumes were fixed.
template <int d>
void apply_bonds(const BondOperator<d>& N, const Multipliers<d>& x, Multipliers<d>& result);

/// No eigenvalue of (diagonal blocks)^-1 times the matrix with fixed volumes is larger: each bond joins two
/// particles, and (a + b)^2 <= 2 a^2 + 2 b^2.
inline constexpr double smoothing_bound = 2;

}  // namespace plumb
