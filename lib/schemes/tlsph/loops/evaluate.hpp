#pragma once
#include <omp.h>

#include <algorithm>
#include <utility>

#include "lib/schemes/tlsph/loops/solid.hpp"

/// The right-hand side of the equations of motion, block by block. Apart from solid.hpp, so that only who
/// advances a body or asks for its forces reads it.
namespace plumb {

/// What terms must know of all blocks before any force; nothing runs if none asks for it.
template <int d>
void look_ahead(const Solid<d>& solid, const Instant<d>& now) {
  const Index blocks = solid.blocks();
  for (const auto& term : now.terms) {
    if (!term.before) continue;
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
    for (Index b = 0; b < blocks; ++b) term.before(solid, solid.block(b), now);
  }
}

/// Stress of one block and what terms do with it; false if some J is not positive or not a number.
template <int d>
bool find_stress(const Solid<d>& solid, Workspace<d>& workspace, const Instant<d>& now, const Block& block) {
  Field* F = workspace.F.components() ? &workspace.F : nullptr;
  const bool sound = solid.sweeps.stress(solid.bonds, now.state.u, block, workspace.P, F);
  for (const auto& term : now.terms) {
    if (term.first) term.first(solid, block, now);
    if (term.stress) term.stress(solid, block, now, workspace.P);
  }
  return sound;
}

/// Force of one block, up to a term that needs all of them; update(block, force) gets it, or stored_force.
template <int d, class Update>
void find_force(const Solid<d>& solid, Workspace<d>& workspace, const Instant<d>& now, const Block& block,
                Update&& update) {
  BlockForce<d> force(block);
  solid.sweeps.force(solid.bonds, workspace.P, block, force);
  for (const auto& term : now.terms) {
    if (term.whole) break;
    if (term.second) term.second(solid, block, now, force);
  }
  if (workspace.stored_force.components() == 0) return update(block, force);
  for (int k = 0; k < d; ++k)
    std::copy_n(force.at(k, block.begin()), block.end() - block.begin(),
                workspace.stored_force[k] + block.begin());
}

/// The second half of an evaluation, if forces are stored: a term that needs all of them, those behind it,
/// and the update.
template <int d, class Update>
void finish_stored_forces(const Solid<d>& solid, Workspace<d>& workspace, const Instant<d>& now,
                          const Arm<d>& arm, Update&& update) {
  auto rest = std::find_if(now.terms.begin(), now.terms.end(),
                           [](const Term<d>& term) { return static_cast<bool>(term.whole); });
  if (rest != now.terms.end()) (rest++)->whole(solid, now, arm, workspace.stored_force);
  const Index blocks = solid.blocks();
#pragma omp parallel for schedule(static) if (blocks >= blocks_for_threads)
  for (Index b = 0; b < blocks; ++b) {
    const Block block = solid.block(b);
    BlockForce<d> stored(block);
    for (int k = 0; k < d; ++k)
      std::copy_n(workspace.stored_force[k] + block.begin(), block.end() - block.begin(),
                  stored.at(k, block.begin()));
    for (auto term = rest; term != now.terms.end(); ++term)
      if (term->second) term->second(solid, block, now, stored);
    update(block, stored);
  }
}

/// Stresses of a share, and the forces that need no others, `reach` blocks behind. Calls force(b). Ends with
/// false at the first block that is not sound, before any force has read its stress.
template <int d, class Force>
bool go_through_share(const Solid<d>& solid, Workspace<d>& workspace, const Instant<d>& now, Index share,
                      Force&& force) {
  const StressWindow& P = workspace.P;
  const Index reach = P.reach(), last = P.begin_of(share + 1);
  Index next = P.inner(share).first;
  const Index end = P.inner(share).second;
  for (Index b = P.begin_of(share); b < last; ++b) {
    if (!find_stress(solid, workspace, now, solid.block(b))) return false;
    if (next < end && next + reach <= b) force(next++);
  }
  while (next < end) force(next++);
  return true;
}

/// The right-hand side at one instant: stress from displacements, force from stress, terms; then
/// update(block, force) for every block, which may change u and v of its own slots. The outcome names a particle whose
/// J <= 0 or is not a number; some blocks, far from there, have then been updated, and the integrator goes
/// back. `arm`: of an integrator that keeps angular momentum about other points than the positions of the
/// evaluation.
///
/// A block's force follows as soon as the stresses that it reads are known, while they are still in the
/// cache; what reads beyond its share waits until all are known. Every block gets the same numbers whatever
/// the shares are.
template <int d, class Update>
Outcome evaluate(const Solid<d>& solid, const std::vector<Term<d>>& terms, Workspace<d>& workspace,
                 State<d>& state, double time, Update&& update, const Arm<d>& arm = {}) {
  prepare(workspace, solid, terms);
  const Instant<d> now{state, time, workspace, terms};
  look_ahead(solid, now);
  const Index shares = workspace.P.shares();
  const auto force = [&](Index b) { find_force(solid, workspace, now, solid.block(b), update); };
  bool sound = true;
  const int threads = static_cast<int>(shares);
#pragma omp parallel num_threads(threads)
  {
#pragma omp for schedule(static, 1) reduction(&& : sound)
    for (Index s = 0; s < shares; ++s) sound = go_through_share(solid, workspace, now, s, force) && sound;
#pragma omp for schedule(static, 1)
    for (Index s = 0; s < shares; ++s) {
      if (!sound) continue;
      const auto [first, last] = workspace.P.inner(s);
      for (Index b = workspace.P.begin_of(s); b < first; ++b) force(b);
      for (Index b = last; b < workspace.P.begin_of(s + 1); ++b) force(b);
    }
  }
  workspace.work.particle_evaluations += solid.bonds.slots.particles;
  workspace.work.pair_evaluations += solid.bonds.pairs;
  if (!sound) {
    workspace.P.clear();
    return {find_trouble(solid, state)};
  }
  if (workspace.stored_force.components() > 0) finish_stored_forces(solid, workspace, now, arm, update);
  return {};
}

/// Evaluates the forces with the terms of the body, as the evaluate() above does with those that it is given.
template <int d, class Update>
Outcome evaluate(const Solid<d>& solid, Workspace<d>& workspace, State<d>& state, double time,
                 Update&& update, const Arm<d>& arm = {}) {
  return evaluate(solid, solid.terms, workspace, state, time, std::forward<Update>(update), arm);
}

}  // namespace plumb
