#pragma once
#include <optional>
#include <vector>

#include "lib/spectrum/eigen_pairs.hpp"
#include "lib/spectrum/linear_operator.hpp"

namespace plumb {

/// Tells rigid motions, waves that the particles resolve, and modes of the discretisation alone.
enum class ModeKind { rigid, smooth, spurious };

/// One mode of the linearised operator.
struct Mode {
  double value = 0;      ///< (omega d/c_p)^2, the real part
  double imaginary = 0;  ///< of the eigenvalue
  /// Rms over nearest pairs of u_ij - (H_i + H_j) X_ij / 2, relative to rms u_ij, with H the gradient that
  /// the scheme sees: the part of the motion that neighbouring gradients do not explain. THEORY (9.2).
  double unexplained = 0;
  ModeKind kind = ModeKind::smooth;
  Eigen::VectorXd motion;  ///< of the free components

  bool spurious() const { return kind == ModeKind::spurious; }
  /// Oscillations per unit of time d/c_p: the real part of the root of the eigenvalue over 2 pi. 0 for motion
  /// that does not oscillate.
  double frequency() const;
};

/// A number of modes; a lower bound where not all of them were looked at.
struct Count {
  int found = 0;
  bool at_least = false;
  friend bool operator==(const Count&, const Count&) = default;
};

/// The modes that cost least energy.
struct LowModes {
  std::vector<Mode> modes;  ///< ascending by value, without rigid ones
  /// The lowest smooth one among `modes`; nothing if none of those looked at is smooth.
  std::optional<double> lowest_smooth;
  /// Spurious ones below the lowest smooth one; all that were looked at if no smooth one was.
  Count spurious_below_smooth;
  /// Those of them within near_zero_share of the lowest smooth one; nothing if that is not known.
  std::optional<Count> near_zero_not_rigid;
};

/// A spurious mode counts as one of nearly no energy below this share of the lowest smooth eigenvalue.
inline constexpr double near_zero_share = 0.1;

/// The `wanted` lowest of the pairs up to the value `reach`, and more until a smooth one is among them.
/// Vectors of pairs are those of the mass-scaled operator; `root`: LinearOperator::root_masses().
/// `complete`: no eigenvalue is missing below `reach`.
template <int d>
LowModes low_modes(const LinearOperator<d>& op, const EigenPairs& pairs, const Eigen::VectorXd& root,
                   int wanted, double reach, bool complete);

/// The rigid motions that the supports allow, as modes of the value that the operator gives them.
template <int d>
std::vector<Mode> rigid_modes(const LinearOperator<d>& op, const SparseMatrix& K);

}  // namespace plumb
