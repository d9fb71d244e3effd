#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "lib/spectrum/damped_growth.hpp"
#include "lib/spectrum/low_modes.hpp"

namespace plumb {

/// What the eigenvalues of the linearised operator say. Dimensionless as in LinearOperator.
struct Spectrum {
  Index unknowns = 0;
  bool complete = false;  ///< all eigenvalues (dense); otherwise the lowest, largest and fastest growing ones
  double asymmetry = 0;   ///< |S - S^T| / |S| of the mass-scaled operator: 0 if the force has an energy
  std::vector<Mode> rigid;    ///< small rigid motions that the supports allow
  double rigid_residual = 0;  ///< what the operator makes of them, relative to its largest eigenvalue
  double largest = 0;         ///< largest modulus
  LowModes low;
  Count negative;                ///< real negative eigenvalues: motion that grows without oscillating
  Count complex_pairs;           ///< pairs of conjugate eigenvalues, each counted once
  double largest_imaginary = 0;  ///< of those found, relative to the largest modulus
  Growth growth_undamped;        ///< fastest growth without dissipation
  Growth growth;                 ///< with the dissipation of the body's terms, if it has any

  /// The algebraically lowest eigenvalue that is not of a rigid motion; nothing if there is none.
  std::optional<double> lowest_nonrigid() const {
    return low.modes.empty() ? std::nullopt : std::optional(low.modes.front().value);
  }
  /// Some count is a lower bound.
  bool partial() const {
    return negative.at_least || complex_pairs.at_least || low.spurious_below_smooth.at_least;
  }
};

/// An asymmetry below this is rounding: the force has an energy.
inline constexpr double symmetric_to_rounding = 1e-11;

/// Chooses how much of a spectrum is computed.
struct SpectrumOptions {
  Index dense_limit = 1200;  ///< unknowns up to which all eigenvalues are computed
  int low_modes = 24;        ///< as many low modes as are wanted
};

/// Eigenvalues: all of them for small bodies (Eigen), the lowest, the largest and those of the fastest
/// growing motions for larger ones (Spectra). Throws InputError if the body has fewer than three free
/// components, or std::runtime_error if an iteration does not converge.
template <int d>
Spectrum spectrum_of(LinearOperator<d>& op, const SpectrumOptions& options = {});

/// The largest eigenvalue of K by power iteration without a matrix, for bodies of any size, to a relative
/// change of `tolerance`; at most `steps` applications.
template <int d>
double largest_eigenvalue(LinearOperator<d>& op, double tolerance = 1e-4, int steps = 2000);

/// Extent of the stability region on the imaginary axis: omega dt below which an undamped mode stays bounded.
/// sqrt 3 for SSP-RK3 (and RK3 of any kind), 2 for velocity Verlet. THEORY (9.3).
double oscillation_limit(std::string_view integrator);

}  // namespace plumb
