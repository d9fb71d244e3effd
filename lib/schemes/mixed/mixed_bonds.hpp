#pragma once
#include <optional>
#include <vector>

#include "lib/material/material.hpp"
#include "lib/schemes/mixed/mixed_options.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

namespace plumb {

/// The bonds of a body with what the scheme of paper 003 needs beside them. The table's constants are
/// c_ab = F_chi,a^T g_chi,ab, material vectors, whatever the reference is: then F = sum x_ab (x) c_ab, its
/// rate is sum v_ab (x) c_ab, and V_chi sigma_chi g_chi of (57) is V P c. THEORY (16.1).
template <int d>
struct MixedBonds {
  BondTable<d> table;
  AlignedVector impedance;      ///< per bond, width: rho |C^Skew|/(2 V_a) of (60) [kg/m^(d+1)]
  AlignedVector smoothing;      ///< per bond, width: V_b W~_b(a) of (38); empty unless positions are smoothed
  AlignedVector own_smoothing;  ///< per row, width: that of the particle itself
  Field inverse_h;              ///< by slot [1/m]; 0 for empty slots
  Field volume;                 ///< by slot: in the kernel sums [m^d], or 1; 0 for empty slots
  Field strength;               ///< by slot: that volume over h^d
  /// Per bond, width: the place of the bond back in arrays of one number per bond and lane; -1 where a lane
  /// has no bond. Empty unless the reference is updated.
  std::vector<std::int64_t> reverse;
};

/// Bonds of the material configuration. `surface`: of the body, for compatible bonds, which may change the cloud's volumes; that
/// of its box where there is none. InputError where neighbours do not span the space.
template <int d>
MixedBonds<d> make_mixed_bonds(Cloud<d>& cloud, const MixedOptions& options, double density,
                               const std::optional<Surface<d>>& surface = {});

/// Moves the reference to the positions X + chi, where the deformation gradient is F: options 2 to 4 make new
/// constants, all options new impedances unless the upwinding is the adjoint one. `volume`: V_a by slot
/// [m^d].
template <int d>
void update_reference(MixedBonds<d>& bonds, const MixedOptions& options, const AlignedVector& volume,
                      const Field& chi, const Field& F, double density);

}  // namespace plumb
