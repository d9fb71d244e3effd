#pragma once
#include <omp.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/material/material.hpp"
#include "lib/particles/trouble.hpp"
#include "lib/particles/work.hpp"
#include "lib/schemes/tlsph/bonds/bond_table.hpp"
#include "lib/schemes/tlsph/loops/stress_window.hpp"

namespace plumb {

template <int d>
struct Solid;
template <int d>
struct Workspace;
template <int d>
struct Term;

/// What terms read at one instant of an evaluation.
template <int d>
struct Instant {
  const State<d>& state;
  double time;                        ///< [s]
  const Workspace<d>& workspace;      ///< stresses and, if a term needs them, deformation gradients
  const std::vector<Term<d>>& terms;  ///< those that act
};

/// Takes a part of the stiffness between two particles [N/m], which is the same for every component.
using AddStiffness = std::function<void(Index particle, Index other, double value)>;

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
  /// Runs for all blocks before any stress; may read displacement and velocity of slots that share a bond, and write the term's own
  /// arrays, which `first` may then read of slots that share a bond.
  std::function<void(const Solid<d>&, const Block&, const Instant<d>&)> before = {};
  /// Runs with the stress; may read displacement and velocity of slots that share a bond and write the term's
  /// own arrays.
  std::function<void(const Solid<d>&, const Block&, const Instant<d>&)> first;
  /// Adds to the stress of the block's own slots, after the material has set it: what is carried by the same
  /// bonds as the stress costs no second gather.
  std::function<void(const Solid<d>&, const Block&, const Instant<d>&, StressWindow& P)> stress;
  /// Adds to the force per unit reference volume; may read the term's own arrays, and of the state the
  /// block's own slots.
  std::function<void(const Solid<d>&, const Block&, const Instant<d>&, BlockForce<d>&)> second;
  /// Changes the forces of all slots at once, when they are known up to this term; at most one term has it.
  /// Forces are stored, and terms behind it may not read the state of other slots.
  std::function<void(const Solid<d>&, const Instant<d>&, const Arm<d>&, Field& force)> whole;
  /// Slots and components whose motion it prescribes, each once, sorted: what their velocity changes by in a step is its
  /// doing, THEORY (8.6).
  std::vector<std::pair<Index, int>> held = {};
  bool needs_F = false;   ///< the deformation gradient is stored
  bool internal = false;  ///< its force belongs to the strain energy, with the internal force
  /// Potential energy of the term [J]; empty: it has none (dissipation, supports).
  std::function<double(const Solid<d>&, const State<d>&)> energy;
  /// Adds -dforce/du x volume at the reference state (linearise.hpp); empty: the term has no stiffness.
  std::function<void(const Solid<d>&, const AddStiffness&)> stiffness;
};

/// dP_ab/dF_ce [Pa] at row a d + b, column c d + e.
template <int d>
using Tangent = Eigen::Matrix<double, d * d, d * d>;

template <int d>
struct BodyHistory;

/// The loops for one material and one kind of table, chosen once.
template <int d>
struct Sweeps {
  std::function<bool(const BondTable<d>&, const Field& u, const Block&, StressWindow& P, Field* F)> stress;
  std::function<double(const BondTable<d>&, const Field& u, const Block&, const double* volume)> energy;
  std::function<void(const BondTable<d>&, const StressWindow& P, const Block&, BlockForce<d>&)> force;
  std::function<Tangent<d>(const Mat<d>& F)> tangent;  ///< dP/dF at F, for linearisation
  std::size_t bytes = 0;                               ///< of tables of their own
  std::shared_ptr<BodyHistory<d>> history = {};  ///< of a law with history (body_history.hpp); null: none
};

/// How an evaluation or a step ended: well, or at the first particle, in order, that is not sound.
struct Outcome {
  std::optional<Trouble> trouble = std::nullopt;  ///< with J, which may be not a number
  explicit operator bool() const { return !trouble; }
};

/// A body of one material: its bonds, its loops and whatever optional terms the scene names. Steps do not change it: what an
/// evaluation writes is in a Workspace. Whoever watches a run (Budget, ExternalWork) adds terms that only read, before the
/// first step.
template <int d>
struct Solid {
  Cloud<d> cloud;
  Elastic elastic;
  double smoothing_length = 0;  ///< h [m]
  BondTable<d> bonds;
  Sweeps<d> sweeps;
  std::vector<Term<d>> terms;
  AlignedVector volume;                                    ///< per slot [m^d]; 0 for empty slots
  double step_limit = std::numeric_limits<double>::max();  ///< other than CFL [s] (JST)

  Index blocks() const { return (bonds.slots.count() + block_slots - 1) / block_slots; }
  Block block(Index b) const {
    const Index per_block = block_slots / bonds.width;
    return {b * per_block, std::min((b + 1) * per_block, bonds.slots.packs()), bonds.width};
  }
  Field make_field(int components) const { return {components, bonds.slots.count(), bonds.margin}; }
};

/// The memory that evaluations of a body write, and what they have done so far. evaluate() makes what it needs.
template <int d>
struct Workspace {
  StressWindow P;      ///< first Piola-Kirchhoff stress [Pa], as far as forces have still to read it
  Field F;             ///< deformation gradient; empty unless a term needs it
  Field stored_force;  ///< [N/m^d]; empty unless a term changes the forces as a whole
  Work work;
};

/// Whether a term needs deformation gradients after the stress, or changes the forces as a whole: then they are stored.
template <int d>
bool stores_F(const std::vector<Term<d>>& terms) {
  return std::any_of(terms.begin(), terms.end(), [](const Term<d>& term) { return term.needs_F; });
}
template <int d>
bool stores_force(const std::vector<Term<d>>& terms) {
  return std::any_of(terms.begin(), terms.end(), [](const Term<d>& term) { return bool(term.whole); });
}

/// Makes what evaluations of this body with these terms need and the workspace does not have yet; a new window of stresses if the number
/// of threads was changed.
template <int d>
void prepare(Workspace<d>& workspace, const Solid<d>& solid, const std::vector<Term<d>>& terms);

/// The loops of the material of that name; InputError names the nearest valid one.
template <int d>
Sweeps<d> sweeps_named(std::string_view material, const Elastic& elastic, const BondTable<d>& bonds);

/// Puts a body together from its reference configuration; terms are added afterwards with add_term.
template <int d>
Solid<d> make_solid(Cloud<d> cloud, std::string_view material, const Elastic& elastic,
                    const BondOptions<d>& options);

/// Adds a term to the force of the body, behind those that it has.
template <int d>
void add_term(Solid<d>& solid, Term<d> term);

/// State at rest in the reference configuration.
template <int d>
State<d> make_state(const Solid<d>& solid);

/// The first particle, in order, whose J is not positive or not a number; std::logic_error if there is none.
template <int d>
Trouble find_trouble(const Solid<d>& solid, const State<d>& state);

/// Room for the stresses of a body, with as many shares as threads will work on it.
template <int d>
StressWindow make_stress_window(const Solid<d>& solid) {
  const Index blocks = solid.blocks();
  const Index reach = (solid.bonds.margin + block_slots - 1) / block_slots;
  return {d * d, blocks, reach, blocks >= blocks_for_threads ? omp_get_max_threads() : 1};
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
