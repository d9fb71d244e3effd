#pragma once
#include <omp.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "plumbline/gradient/bond_table.hpp"
#include "plumbline/material/material.hpp"
#include "plumbline/solid/stress_window.hpp"

namespace plumb {

template <int d>
struct Solid;

/// One entry of a stiffness matrix [N/m]; rows and columns are d x particle + component.
struct StiffnessEntry {
  Index row, column;
  double value;
};

/// Displacement of the point at which the force on a slot acts in the change of sum m x (x-product) v over a
/// step [m], THEORY (5.5). Empty: where the slot is.
template <int d>
using Arm = std::function<Vec<d>(Index slot)>;

/// An optional part of the right-hand side (dissipation, body force, support, hourglass energy): made only if
/// a scene names it. Called per block, never per particle. An empty function is not called.
template <int d>
struct Term {
  std::string name;
  std::size_t bytes = 0;        ///< of its own arrays
  double bytes_per_update = 0;  ///< read and written at each evaluation, as in THEORY (10.8)
  /// Runs with the stress; may read displacement and velocity of slots that share a bond and write the term's
  /// own arrays.
  std::function<void(const Solid<d>&, const Block&, const State<d>&, double time)> first;
  /// Adds to the stress of the block's own slots, after the material has set it: what is carried by the same
  /// bonds as the stress costs no second gather.
  std::function<void(const Solid<d>&, const Block&, const State<d>&, StressWindow& P)> stress;
  /// Adds to the force per unit reference volume; may read the term's own arrays, and the state only if
  /// needs_state.
  std::function<void(const Solid<d>&, const Block&, const State<d>&, double time, BlockForce<d>&)> second;
  /// Changes the forces of all slots at once, when they are known up to this term; at most one term has it.
  /// Forces are stored, and terms behind it may not read the state of other slots.
  std::function<void(const Solid<d>&, const State<d>&, const Arm<d>&, Field& force)> whole;
  bool needs_state = false;  ///< `second` reads the state of other slots: forces are stored before the update
  bool needs_F = false;      ///< the deformation gradient is stored
  bool internal = false;     ///< its force belongs to the strain energy, with the internal force
  /// Potential energy of the term [J]; empty: it has none (dissipation, supports).
  std::function<double(const Solid<d>&, const State<d>&)> energy;
  /// Adds -dforce/du x volume at the reference state (linearise.hpp); empty: the term has no stiffness.
  std::function<void(const Solid<d>&, std::vector<StiffnessEntry>&)> stiffness;
};

/// dP_ab/dF_ce [Pa] at row a d + b, column c d + e.
template <int d>
using Tangent = Eigen::Matrix<double, d * d, d * d>;

/// The loops for one material and one kind of table, chosen once.
template <int d>
struct Sweeps {
  std::function<bool(const BondTable<d>&, const Field& u, const Block&, StressWindow& P, Field* F)> stress;
  std::function<double(const BondTable<d>&, const Field& u, const Block&, const double* volume)> energy;
  std::function<void(const BondTable<d>&, const StressWindow& P, const Block&, BlockForce<d>&)> force;
  std::function<Tangent<d>(const Mat<d>& F)> tangent;  ///< dP/dF at F, for linearisation
  std::size_t bytes = 0;                               ///< of tables of their own
};

/// Work done so far; does not depend on the machine.
struct Work {
  std::int64_t particle_evaluations = 0;
  std::int64_t pair_evaluations = 0;
};

/// Where the last evaluation found a deformation gradient without positive determinant.
struct UnsoundParticle {
  Index particle = -1;
  double determinant = 0;
};

/// A body of one material: its bonds, its loops and whatever optional terms the scene names.
template <int d>
struct Solid {
  Cloud<d> cloud;
  Elastic elastic;
  double smoothing_length = 0;  ///< h [m]
  BondTable<d> bonds;
  Sweeps<d> sweeps;
  std::vector<Term<d>> terms;
  StressWindow P;        ///< first Piola-Kirchhoff stress, as far as forces have still to read it
  Field F;               ///< deformation gradient; empty unless a term needs it
  Field stored_force;    ///< [N/m^d]; empty unless a term needs the state
  AlignedVector volume;  ///< per slot [m^d]; 0 for empty slots
  double step_limit = std::numeric_limits<double>::max();  ///< other than CFL [s] (JST)
  Work work;
  UnsoundParticle unsound;  ///< set when an evaluation fails

  Index blocks() const { return (bonds.slots.count() + block_slots - 1) / block_slots; }
  Block block(Index b) const {
    const Index per_block = block_slots / bonds.width;
    return {b * per_block, std::min((b + 1) * per_block, bonds.slots.packs()), bonds.width};
  }
  Field make_field(int components) const { return {components, bonds.slots.count(), bonds.margin}; }
};

/// The loops of the material of that name; InputError names the nearest valid one.
template <int d>
Sweeps<d> sweeps_named(std::string_view material, const Elastic& elastic, const BondTable<d>& bonds);

/// Puts a body together from its reference configuration; terms are added afterwards with add_term.
template <int d>
Solid<d> make_solid(Cloud<d> cloud, std::string_view material, const Elastic& elastic,
                    const BondOptions<d>& options);

template <int d>
void add_term(Solid<d>& solid, Term<d> term);

/// State at rest in the reference configuration.
template <int d>
State<d> make_state(const Solid<d>& solid);

/// The first particle, in order, whose J is not positive or not a number.
template <int d>
UnsoundParticle find_unsound(const Solid<d>& solid, const State<d>& state);

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

/// Room for the stresses of a body, with as many shares as threads will work on it.
template <int d>
StressWindow make_stress_window(const Solid<d>& solid) {
  const Index blocks = solid.blocks();
  const Index reach = (solid.bonds.margin + block_slots - 1) / block_slots;
  return {d * d, blocks, reach, blocks >= blocks_for_threads ? omp_get_max_threads() : 1};
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

/// Sum over blocks in a fixed order, whatever the number of threads.
template <int d, class F>
double sum_over_blocks(const Solid<d>& solid, F&& value) {
  std::vector<double> parts(solid.blocks());
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
  for (Index b = 0; b < solid.blocks(); ++b) parts[b] = value(solid.block(b));
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

}  // namespace plumb
