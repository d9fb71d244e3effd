#pragma once
#include <memory>

#include "lib/material/history.hpp"
#include "lib/material/tangent.hpp"
#include "lib/schemes/tlsph/bonds/mirror_bonds.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"
#include "lib/schemes/tlsph/loops/lattice_sweeps.hpp"
#include "lib/schemes/tlsph/loops/sweeps.hpp"

/// The loops of laws with history, slot by slot in three dimensions.
namespace plumb {

/// Returns F in three dimensions; directions that it lacks are not stretched.
template <int d>
Mat<3> with_unit_thickness(const Mat<d>& F) {
  Mat<3> whole = Mat<3>::Identity();
  whole.template topLeftCorner<d, d>() = F;
  return whole;
}

/// Calls use(slot, F) for the slots of a block, where gradient(bonds, u, pack) finds F.
template <int d, int W, class Gradient, class Use>
void for_gradients(const Gradient& gradient, const BondTable<d>& bonds, const Field& u, const Block& block,
                   Use&& use) {
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    Mat<d, Pack<W>> packed = gradient(bonds, u, pack);
    if (bonds.mirror) add_image_gradient<d, W>(*bonds.mirror, bonds.row[pack], u, pack, packed);
    for (int lane = 0; lane < W; ++lane) {
      Mat<d> F;
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) F(a, b) = packed(a, b)[lane];
      use(pack * W + lane, F);
    }
  }
}

/// dP/dF of an increment from that history, in d dimensions.
template <int d, HistoryLaw M>
Tangent<d> increment_tangent(const M& law, const Mat<d>& F, const typename M::History& before) {
  return part_in<d>(law.tangent(with_unit_thickness<d>(F), before));
}

/// Makes the history of every particle of a table, as the law begins with it.
template <int d, HistoryLaw M>
std::shared_ptr<BodyHistory<d>> make_history(const M& law, const BondTable<d>& bonds) {
  using History = typename M::History;
  const auto kept = std::make_shared<BodyHistory<d>>();
  kept->values = history_values<History>();
  const HistoryValue& last = kept->values.back();
  kept->values.push_back({"plastic work", "J/m^3", last.first + last.components(), false});
  kept->field = Field(kept->components(), bonds.slots.count(), bonds.margin);
  History fresh;
  for (Index slot = 0; slot < bonds.slots.count(); ++slot) store_history(fresh, kept->field, slot);
  kept->first_piola = [law, memory = kept.get()](const Mat<3>& F, Index slot) -> Mat<3> {
    History history;
    load_history(history, memory->field, slot);
    return law.stress(F, history).P;
  };
  kept->tangent = [law, memory = kept.get()](const Mat<d>& F, Index slot) {
    History history;
    load_history(history, memory->field, slot);
    return increment_tangent<d>(law, F, history);
  };
  return kept;
}

/// Everything but the force: stress, energy, tangent at the start, and the commitment of the history.
template <int d, int W, HistoryLaw M, class Gradient>
void add_history_loops(Sweeps<d>& s, const M& law, const BondTable<d>& all, const Gradient& gradient) {
  using History = typename M::History;
  s.history = make_history<d>(law, all);
  const auto kept = s.history;
  s.stress = [law, kept, gradient](const BondTable<d>& bonds, const Field& u, const Block& block,
                                   StressWindow& P, Field* F_out) {
    bool sound = true;
    for_gradients<d, W>(gradient, bonds, u, block, [&](Index slot, const Mat<d>& F) {
      const bool sane = determinant<d, double>(F) > 0;
      sound = sound && sane;
      Mat<3> stress = Mat<3>::Zero();
      if (sane) {
        History history;
        load_history(history, kept->field, slot);
        stress = law.stress(with_unit_thickness<d>(F), history).P;
      }
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) {
          P[a * d + b][P.place(slot)] = stress(a, b);
          if (F_out) (*F_out)[a * d + b][slot] = F(a, b);
        }
    });
    return sound;
  };
  const auto sum_of = [memory = kept.get(), gradient](const auto& density) {
    return [memory, gradient, density](const BondTable<d>& bonds, const Field& u, const Block& block,
                                       const double* volume) {
      double sum = 0;
      for_gradients<d, W>(gradient, bonds, u, block, [&](Index slot, const Mat<d>& F) {
        if (volume[slot] == 0) return;
        History history;
        load_history(history, memory->field, slot);
        sum += volume[slot] * density(with_unit_thickness<d>(F), history);
      });
      return sum;
    };
  };
  s.energy = sum_of([law](const Mat<3>& F, const History& history) { return law.energy(F, history); });
  kept->potential =
      sum_of([law](const Mat<3>& F, const History& history) { return law.potential(F, history); });
  kept->commit = [law, memory = kept.get(), gradient](const BondTable<d>& bonds, const Field& u,
                                                      const Block& block) {
    const int work = memory->plastic_work().first;
    for_gradients<d, W>(gradient, bonds, u, block, [&](Index slot, const Mat<d>& F) {
      if (!(determinant<d, double>(F) > 0)) return;  // the next evaluation says so
      History history;
      load_history(history, memory->field, slot);
      memory->field[work][slot] += law.stress(with_unit_thickness<d>(F), history).plastic_work;
      store_history(history, memory->field, slot);
    });
  };
  s.tangent = [law](const Mat<d>& F) { return increment_tangent<d>(law, F, History()); };
}

/// The loops of law M that fit the table.
template <int d, HistoryLaw M>
Sweeps<d> history_sweeps(const M& law, const BondTable<d>& bonds) {
  Sweeps<d> s;
  if (bonds.width == 1) {
    s.force = &force_sweep<d, 1>;
    add_history_loops<d, 1>(s, law, bonds, [](const BondTable<d>& table, const Field& u, Index pack) {
      return deformation_gradient<d, 1>(table, u, pack);
    });
  } else {
    constexpr int W = native_width;
    const auto lattice = std::make_shared<const LatticeTable<d>>(make_lattice_table(bonds));
    s.bytes = lattice->bytes();
    s.force = [lattice](const BondTable<d>&, const StressWindow& P, const Block& block,
                        BlockForce<d>& force) { lattice_force_sweep<d>(*lattice, P, block, force); };
    add_history_loops<d, W>(s, law, bonds, [lattice](const BondTable<d>& table, const Field& u, Index pack) {
      return lattice_deformation_gradient<d, W>(table, *lattice, u, pack);
    });
  }
  return s;
}

}  // namespace plumb
