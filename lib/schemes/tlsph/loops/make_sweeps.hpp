#pragma once
#include <memory>

#include "lib/material/tangent.hpp"
#include "lib/schemes/tlsph/loops/lattice_sweeps.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"
#include "lib/schemes/tlsph/loops/sweeps.hpp"

/// The loops behind Sweeps, made for a material. Apart from solid.hpp, so that only who makes loops compiles
/// them.
namespace plumb {

/// The loops of material M over packs of W, where gradient(bonds, u, pack) finds F.
template <int d, int W, MaterialModel<d> M, class Gradient>
Sweeps<d> sweeps_over(const M& material, const Gradient& gradient) {
  Sweeps<d> s;
  s.stress = [material, gradient](const BondTable<d>& bonds, const Field& u, const Block& block,
                                  StressWindow& P, Field* F) {
    const auto of_pack = [&](Index pack) { return gradient(bonds, u, pack); };
    return stress_sweep<d, W>(material, of_pack, block, P, F);
  };
  s.energy = [material, gradient](const BondTable<d>& bonds, const Field& u, const Block& block,
                                  const double* volume) {
    const auto of_pack = [&](Index pack) { return gradient(bonds, u, pack); };
    return energy_sweep<d, W>(material, of_pack, block, volume);
  };
  s.tangent = [material](const Mat<d>& F) { return tangent_of<d>(material, F); };
  return s;
}

/// Makes the sweeps of sweeps_over(), with what images do to F if there are any. Their force is a term
/// (mirror_term()).
template <int d, int W, MaterialModel<d> M, class Gradient>
Sweeps<d> sweeps_with_images(const M& material, const BondTable<d>& all, const Gradient& gradient) {
  if (!all.mirror) return sweeps_over<d, W>(material, gradient);
  return sweeps_over<d, W>(material, [gradient](const BondTable<d>& bonds, const Field& u, Index pack) {
    Mat<d, Pack<W>> F = gradient(bonds, u, pack);
    add_image_gradient<d, W>(*bonds.mirror, bonds.row[pack], u, pack, F);
    return F;
  });
}

/// The loops of material M over rows of single particles.
template <int d, MaterialModel<d> M>
Sweeps<d> plain_sweeps(const M& material, const BondTable<d>& all) {
  Sweeps<d> s = sweeps_with_images<d, 1>(material, all, [](const auto& bonds, const Field& u, Index pack) {
    return deformation_gradient<d, 1>(bonds, u, pack);
  });
  s.force = &force_sweep<d, 1>;
  return s;
}

/// The loops of material M over the shared rows of a lattice.
template <int d, MaterialModel<d> M>
Sweeps<d> lattice_sweeps(const M& material, const BondTable<d>& all) {
  constexpr int W = native_width;
  const auto table = std::make_shared<const LatticeTable<d>>(make_lattice_table(all));
  Sweeps<d> s =
      sweeps_with_images<d, W>(material, all, [table](const auto& bonds, const Field& u, Index pack) {
        return lattice_deformation_gradient<d, W>(bonds, *table, u, pack);
      });
  s.force = [table](const BondTable<d>&, const StressWindow& P, const Block& block, BlockForce<d>& force) {
    lattice_force_sweep<d>(*table, P, block, force);
  };
  s.bytes = table->bytes();
  return s;
}

/// The loops of material M that fit the table. A material of one's own, outside of the catalogue:
/// body.sweeps = sweeps_of<d>(material, body.bonds).
template <int d, MaterialModel<d> M>
Sweeps<d> sweeps_of(const M& material, const BondTable<d>& bonds) {
  return bonds.width == 1 ? plain_sweeps<d>(material, bonds) : lattice_sweeps<d>(material, bonds);
}

}  // namespace plumb
