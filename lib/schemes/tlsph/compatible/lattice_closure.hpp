#pragma once
#include <array>
#include <optional>
#include <string>

#include "lib/schemes/tlsph/bonds/bond_table.hpp"

namespace plumb {

/// Layers that bonds of a closed table may reach.
inline constexpr int closure_reach = 2;

/// The interior weights of one component of the gradient, all that an estimator leaves to choose:
/// c_k = sum over m, p, q of weight[m - 1][p][q] D_m N_p N_q, with the difference D_m over m layers along
/// axis k and N_p, N_q over p and q layers along the axes after it (cyclic; in 2D q = 0, in 1D p = q = 0). THEORY (11.15).
using InteriorWeights =
    std::array<std::array<std::array<double, closure_reach + 1>, closure_reach + 1>, closure_reach>;

/// How the bonds of a lattice are closed at its faces.
template <int d>
struct LatticeClosure {
  Vec<d> step;                            ///< distance of particles along each axis [m]
  std::array<InteriorWeights, d> weight;  ///< of c_k
};

/// Why compatible bonds on this cloud are not known in closed form, as the end of a sentence that begins with
/// "because"; nullopt if they are: a whole lattice with particles on the faces, two or more along each axis,
/// whose bonds (shorter than R [m]) reach two layers at most.
template <int d>
std::optional<std::string> reason_against_closure(const Cloud<d>& cloud, double R);

/// The interior weights of the options' estimator, kernel and pair. Throws InputError if it is not exact for
/// affine maps.
template <int d>
LatticeClosure<d> lattice_closure(const Cloud<d>& cloud, const BondOptions<d>& options);

/// The factor of T_m in what multiplies D_1 in c_k, with bonds that reach one layer: a of THEORY (11.10),
/// alpha of (11.11). In 2D and 3D.
template <int d>
double averaging(const LatticeClosure<d>& closure, int k, int m);

/// The row of one particle, closed at the faces so that affine maps are exact and sum_k V_k c_ki = B_i,
/// whatever the interior weights are. Zero for the particle itself. THEORY (11.9)-(11.12), (11.15).
template <int d>
std::vector<Vec<d>> closed_stencil(const LatticeClosure<d>& closure, Neighbourhood<d> neighbours);

/// Makes closed_stencil the estimator of the options. The momentum form must be the adjoint one: bonds within
/// a face are not antisymmetric, so that no other form has the same force.
template <int d>
LatticeClosure<d> close_on_lattice(BondOptions<d>& options, const Cloud<d>& cloud);

}  // namespace plumb
