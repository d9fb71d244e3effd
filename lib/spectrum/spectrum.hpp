#pragma once
#include <string>
#include <vector>

#include "plumbline/spectrum/linear_operator.hpp"

namespace plumb {

/// One low mode of the linearised operator.
struct Mode {
  double value = 0;      ///< (omega d/c_p)^2, the real part
  double imaginary = 0;  ///< of the eigenvalue
  /// Rms over nearest pairs of u_ij - (H_i + H_j) X_ij / 2, relative to rms u_ij, with H the gradient that
  /// the scheme sees: the part of the motion that neighbouring gradients do not explain. THEORY (9.2).
  double unexplained = 0;
  bool spurious() const { return unexplained > 0.5; }
  Eigen::VectorXd motion;  ///< of the free components
};

/// What the eigenvalues of the linearised operator say. Dimensionless as in LinearOperator.
struct Spectrum {
  Index unknowns = 0;
  bool complete = false;      ///< all eigenvalues (dense); otherwise the ends of the spectrum (Krylov)
  double asymmetry = 0;       ///< |S - S^T| / |S| of the mass-scaled operator: 0 if the force has an energy
  int rigid = 0;              ///< small rigid motions that the supports allow
  double rigid_residual = 0;  ///< what the operator makes of them, relative to its largest eigenvalue
  double largest = 0;         ///< largest modulus
  double lowest_nonrigid = 0;
  double lowest_smooth = 0;       ///< lowest mode that is not rigid and not spurious; 0 if none was found
  std::vector<Mode> low;          ///< lowest modes that are not rigid, ascending
  int negative = 0;               ///< real negative eigenvalues: motion that grows without oscillating
  int near_zero_not_rigid = 0;    ///< spurious modes within near_zero_share of the lowest smooth one
  int spurious_below_smooth = 0;  ///< spurious modes below the lowest smooth one
  int complex_pairs = 0;
  double largest_imaginary = 0;  ///< of an eigenvalue, relative to the largest modulus
  double growth_undamped = 0;    ///< fastest growth [c_p/d] without dissipation
  double growth = 0;             ///< with the dissipation of the body's terms, if it has any
  bool growth_known = true;      ///< false: dissipation present and the body too large for the full problem
};

/// A spurious mode counts as one of nearly no energy below this share of the lowest smooth eigenvalue.
inline constexpr double near_zero_share = 0.1;

struct SpectrumOptions {
  Index dense_limit = 1200;  ///< unknowns up to which all eigenvalues are computed
  int low_modes = 24;        ///< as many low modes as are wanted
};

/// Eigenvalues: all of them for small bodies (Eigen), both ends for larger ones (Spectra). Throws InputError
/// if the body has fewer than three free components, or std::runtime_error if the iteration does not
/// converge.
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
