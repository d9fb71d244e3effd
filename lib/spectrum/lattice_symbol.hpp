#pragma once
#include "lib/material/material.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {

/// A scheme on the infinite uniform lattice, seen by plane waves exp(i theta . X / d). There the cosines
/// cancel and every table is one odd vector of sines. THEORY (9.4), (9.5).
template <int d>
class LatticeSymbol {
 public:
  /// Options as for a body; the smoothing length is `beta` spacings, the Laplacian is not used.
  LatticeSymbol(BondOptions<d> options, double beta);

  /// g(theta): the scheme's gradient of exp(i theta . X / d) is i g / d times it; exact would be theta.
  Vec<d> gradient(const Vec<d>& theta) const;
  /// Returns g(theta) of the force weights: the divergence that the momentum form makes; equal to g for the adjoint
  /// form.
  Vec<d> divergence(const Vec<d>& theta) const;
  /// D(theta): omega^2 (d/c_p)^2 are its eigenvalues; symmetric if gradient and divergence agree.
  Mat<d> dynamical_matrix(const Vec<d>& theta, const Elastic& elastic) const;

 private:
  std::vector<Vec<d>> separation_, stencil_, force_;  ///< in spacings and per spacing
  Vec<d> own_force_ = Vec<d>::Zero();                 ///< vanishes by symmetry
};

}  // namespace plumb
