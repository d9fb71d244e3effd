#pragma once
#include <omp.h>

#include <algorithm>
#include <utility>

#include "lib/schemes/tlsph/loops/solid.hpp"

/// The right-hand side of the equations of motion, block by block. Apart from solid.hpp, so that only who
/// advances a body or asks for its forces reads it.
namespace plumb {

/// Stress of one block and what terms do with it; false if some J is not positive or not a number.
template <int d>
bool find_stress(Solid<d>& solid, const State<d>& state, const Block& block, double time) {
  Field* F = solid.F.components() ? &solid.F : nullptr;
  const bool sound = solid.sweeps.stress(solid.bonds, state.u, block, solid.P, F);
  for (const auto& term : solid.terms) {
    if (term.first) term.first(solid, block, state, time);
    if (term.stress) term.stress(solid, block, state, solid.P);
  }
  return sound;
}

/// Force of one block, up to a term that needs all of them; update(block, force) gets it, or stored_force.
template <int d, class Update>
void find_force(Solid<d>& solid, const State<d>& state, const Block& block, double time, Update&& update) {
  BlockForce<d> force(block);
  solid.sweeps.force(solid.bonds, solid.P, block, force);
  for (const auto& term : solid.terms) {
    if (term.whole) break;
    if (term.second) term.second(solid, block, state, time, force);
  }
  if (solid.stored_force.components() == 0) return update(block, force);
  for (int k = 0; k < d; ++k)
    std::copy_n(force.at(k, block.begin()), block.end() - block.begin(),
                solid.stored_force[k] + block.begin());
}

/// The second half of an evaluation, if forces are stored: a term that needs all of them, those behind it,
/// and the update.
template <int d, class Update>
void finish_stored_forces(Solid<d>& solid, const State<d>& state, double time, const Arm<d>& arm,
                          Update&& update) {
  auto rest = std::find_if(solid.terms.begin(), solid.terms.end(),
                           [](const Term<d>& term) { return static_cast<bool>(term.whole); });
  if (rest != solid.terms.end()) (rest++)->whole(solid, state, arm, solid.stored_force);
  const Index blocks = solid.blocks();
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
  for (Index b = 0; b < blocks; ++b) {
    const Block block = solid.block(b);
    BlockForce<d> stored(block);
    for (int k = 0; k < d; ++k)
      std::copy_n(solid.stored_force[k] + block.begin(), block.end() - block.begin(),
                  stored.at(k, block.begin()));
    for (auto term = rest; term != solid.terms.end(); ++term)
      if (term->second) term->second(solid, block, state, time, stored);
    update(block, stored);
  }
}

/// Stresses of a share, and the forces that need no others, `reach` blocks behind. Calls force(b). Ends with
/// false at the first block that is not sound, before any force has read its stress.
template <int d, class Force>
bool go_through_share(Solid<d>& solid, const State<d>& state, double time, Index share, Force&& force) {
  const Index reach = solid.P.reach(), last = solid.P.begin_of(share + 1);
  Index next = solid.P.inner(share).first;
  const Index end = solid.P.inner(share).second;
  for (Index b = solid.P.begin_of(share); b < last; ++b) {
    if (!find_stress(solid, state, solid.block(b), time)) return false;
    if (next < end && next + reach <= b) force(next++);
  }
  while (next < end) force(next++);
  return true;
}

/// The right-hand side at one instant: stress from displacements, force from stress, terms; then
/// update(block, force) for every block, which may change u and v of its own slots. Returns false if some
/// J <= 0 or is not a number; some blocks, far from there, have then been updated, and the integrator goes
/// back. `arm`: of an integrator that keeps angular momentum about other points than the positions of the
/// evaluation.
///
/// A block's force follows as soon as the stresses that it reads are known, while they are still in the
/// cache; what reads beyond its share waits until all are known. Every block gets the same numbers whatever
/// the shares are.
template <int d, class Update>
bool evaluate(Solid<d>& solid, State<d>& state, double time, Update&& update, const Arm<d>& arm = {}) {
  const Index blocks = solid.blocks();
  if (const Index threads = omp_get_max_threads();
      blocks >= blocks_for_threads && solid.P.shares() != threads)
    solid.P = make_stress_window(solid);  // the number of threads was changed
  const Index shares = solid.P.shares();
  const auto force = [&](Index b) { find_force(solid, state, solid.block(b), time, update); };
  bool sound = true;
#pragma omp parallel num_threads(static_cast <int>(shares))
  {
#pragma omp for schedule(static, 1) reduction(&& : sound)
    for (Index s = 0; s < shares; ++s) sound = go_through_share(solid, state, time, s, force) && sound;
#pragma omp for schedule(static, 1)
    for (Index s = 0; s < shares; ++s) {
      if (!sound) continue;
      const auto [first, last] = solid.P.inner(s);
      for (Index b = solid.P.begin_of(s); b < first; ++b) force(b);
      for (Index b = last; b < solid.P.begin_of(s + 1); ++b) force(b);
    }
  }
  solid.work.particle_evaluations += solid.bonds.slots.particles;
  solid.work.pair_evaluations += solid.bonds.pairs;
  if (!sound) {
    solid.P.clear();
    solid.unsound = find_unsound(solid, state);
    return false;
  }
  if (solid.stored_force.components() > 0) finish_stored_forces(solid, state, time, arm, update);
  return true;
}

}  // namespace plumb
