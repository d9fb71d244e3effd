#pragma once
#include <optional>
#include <string>

#include "plumbline/gradient/bond_table.hpp"

namespace plumb {

/// The averaging across axis k that multiplies the difference along it in c_k: I + sum_m once_m T_m, in 3D
/// with + twice T_m T_n over the two axes across. THEORY (11.10), (11.11).
template <int d>
struct Averaging {
  Vec<d> once = Vec<d>::Zero();  ///< per axis, zero for axis k itself
  double twice = 0;              ///< zero in 2D
};

/// The interior weights of an estimator on a lattice whose bonds reach one layer: all that it leaves to
/// choose.
template <int d>
struct LatticeClosure {
  Vec<d> step;                            ///< distance of particles along each axis [m]
  std::array<Averaging<d>, d> averaging;  ///< of c_k
};

/// Why compatible bonds on this cloud are not known in closed form, as the end of a sentence that begins with
/// "because"; nullopt if they are: a whole lattice with particles on the faces, two or more along each axis,
/// whose bonds (shorter than R [m]) reach one layer.
template <int d>
std::optional<std::string> reason_against_closure(const Cloud<d>& cloud, double R);

/// The interior weights of the options' estimator, kernel and pair. Throws InputError if it is not exact for
/// affine maps.
template <int d>
LatticeClosure<d> lattice_closure(const Cloud<d>& cloud, const BondOptions<d>& options);

/// The row of one particle: c_k = D_k (I + ..) with one-sided differences at the faces, where the averaging
/// keeps its symmetry in the tributary weights. Affine maps are exact, and sum_k V_k c_ki = B_i, whatever the
/// interior weights are. Zero for the particle itself. THEORY (11.9)-(11.12).
template <int d>
std::vector<Vec<d>> closed_stencil(const LatticeClosure<d>& closure, Neighbourhood<d> neighbours);

/// Makes closed_stencil the estimator of the options. The momentum form must be the adjoint one: bonds within
/// a face are not antisymmetric, so that no other form has the same force.
template <int d>
LatticeClosure<d> close_on_lattice(BondOptions<d>& options, const Cloud<d>& cloud);

}  // namespace plumb
