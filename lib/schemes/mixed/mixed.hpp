#pragma once
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "lib/particles/block.hpp"
#include "lib/schemes/mixed/block_law.hpp"
#include "lib/schemes/mixed/mixed_bonds.hpp"
#include "lib/schemes/mixed/mixed_options.hpp"
#include "lib/schemes/outside.hpp"
#include "lib/schemes/scheme.hpp"

namespace plumb {

/// The scheme of paper 003 for the unknowns p, F, H and J: the adjoint force of corrected kernel sums,
/// dissipation between pairs, three Runge-Kutta stages, and a reference that may be updated. THEORY, chapter
/// 15. Its options make the variants of the paper and those that are better.
template <int d>
class Mixed {
 public:
  static constexpr std::string_view name = "mixed";
  using Options = MixedOptions;
  using State = MixedState<d>;

  /// `damping`: rate [1/s], THEORY (6.7); `walls`: without friction, what the body may touch and leave again; `surface`: of the
  /// body, for compatible bonds. InputError where the neighbours of a particle do not span the space, or the law does not go with
  /// the options.
  Mixed(Specimen<d> specimen, MixedOptions options, const Actions<d>& actions, double damping = 0,
        std::vector<RigidWall<d>> walls = {}, const std::optional<Surface<d>>& surface = {});

  /// At rest in the reference where the motion has no entries.
  State start(const InitialMotion<d>& motion);
  /// alpha min |x_ab|/c_p,ab (62), (63) [s].
  double step_limit(const State& state);
  std::optional<Trouble> advance(State& state, double dt);
  Snapshot<d> snapshot(const State& state);
  Energy energy(const State& state);
  std::vector<Statement> account() const;

  /// Fills the evolving fields of `rate` with the time derivatives of those of the state.
  std::optional<Trouble> rates(const State& state, double time, State& rate);
  const OutsideForces<d>& outside() const { return outside_; }
  OutsideForces<d>& outside() { return outside_; }
  /// Accelerations in this state, at velocity zero if it is `still`; nullopt if the body is not sound.
  std::optional<OpenAcceleration> open(const State& state, bool still);

  static constexpr int evaluations_per_step = 3;
  const Slots& layout() const { return bonds_.table.slots; }
  NeighbourCounts neighbours() const { return {bonds_.table.pairs, bonds_.table.most_neighbours}; }
  std::vector<std::string> warnings() const;

  const Cloud<d>& cloud() const { return specimen_.cloud; }
  const MixedBonds<d>& bonds() const { return bonds_; }

 private:
  using Arm = std::function<Vec<d>(Index slot)>;
  Index slots() const { return bonds_.table.slots.count(); }
  Field make_field(int components) const { return {components, slots(), bonds_.table.margin}; }
  State make_state() const;
  /// F of every slot: that of the state, or found from its positions.
  const Field& gradients(const State& state);
  /// The first particle, in order, whose determinants are not positive or not numbers.
  std::optional<Trouble> find_trouble(const State& state, const Field& F) const;
  /// Makes the bonds those of the state's reference.
  void follow_reference(const State& state);
  /// Rates without supports. `arm`: of the projection, where the state is where it is empty.
  std::optional<Trouble> evaluate(const State& state, double time, State& rate, const Arm& arm = {});
  /// Where the forces of a stage act in the change of angular momentum over a step, THEORY (5.5). [m]
  Arm arm_of(int stage, double dt, const State& now) const;
  void meet(std::vector<RigidWall<d>> walls);
  std::optional<Trouble> end_of_step(State& state);
  /// F, velocity gradients and stretches of one block, and the rates of F, H and J; false if a determinant is
  /// not positive.
  template <int W>
  bool kinematics_of_block(const State& state, const Block& block, State& rate);
  template <int W>
  void upwind_block(const State& state, const Field& F, const Block& block, State& rate);
  /// dJ += sum D^j of (59), (60), constant states.
  template <int W>
  void diffuse_block(const State& state, const Block& block, State& rate) const;
  template <int W>
  void force_of_block(const State& state, const Block& block, State& rate) const;

  Specimen<d> specimen_;
  MixedOptions options_;
  MixedBonds<d> bonds_;
  OutsideForces<d> outside_;
  BlockLaw<d> law_;
  AlignedVector volume_;  ///< by slot [m^d]; 0 for empty slots
  double pressure_speed_, shear_speed_;

  // room for one evaluation, by slot
  Field F_, G_, P_, stretch_;
  State before_, rate_;
  Field seen_chi_, seen_F_;     ///< the reference that the bonds are made for
  std::vector<Vec<3>> turned_;  ///< room of the projection
  std::vector<Vec<d>> x_;       ///< by slot: positions, where there are walls [m]
  Field sigma_;                 ///< Sigma_J by slot, where it diffuses J [Pa]
  bool loaded_ = false;         ///< loads or walls act on the body
  Field no_anchors_;            ///< walls have no friction
};

}  // namespace plumb
