#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "lib/schemes/eulerian/eulerian_options.hpp"
#include "lib/schemes/eulerian/eulerian_state.hpp"
#include "lib/schemes/eulerian/reference_pairs.hpp"
#include "lib/schemes/outside.hpp"
#include "lib/schemes/pair_row.hpp"
#include "lib/schemes/rate_law.hpp"
#include "lib/schemes/scheme.hpp"
#include "lib/schemes/touching_bodies.hpp"

namespace plumb {

/// The Eulerian-kernel scheme of paper 001: density and stress by rates, kernels at the positions of now, and
/// hourglass control by a deformation gradient that is carried over changes of neighbours. THEORY, chapter 18.
template <int d>
class Eulerian {
 public:
  static constexpr std::string_view name = "eulerian";
  using Options = EulerianOptions;
  using State = EulerianState<d>;

  /// `damping`: rate [1/s], THEORY (6.7); `walls`: what the body may touch; `touch`: how the bodies of the cloud press on each
  /// other. InputError where the neighbours of a particle do not span the space,
  /// two particles are at one place, or the law has no rates.
  Eulerian(Specimen<d> specimen, EulerianOptions options, const Actions<d>& actions, double damping = 0,
           std::vector<RigidWall<d>> walls = {}, const TouchOptions& touch = {});

  /// At rest in the reference where the motion has no entries. A displacement gives stress and density of the
  /// deformation that it is.
  State start(const InitialMotion<d>& motion);
  double step_limit(const State& state) const;
  std::optional<Trouble> advance(State& state, double dt);
  Snapshot<d> snapshot(const State& state);
  Energy energy(const State& state);
  std::vector<Statement> account() const;

  static constexpr int evaluations_per_step = 1;
  /// Pairs nearer than the kernel's reach, at the last geometry.
  NeighbourCounts neighbours() const { return counts_; }
  std::vector<std::string> warnings() const;

  const EulerianOptions& options() const { return options_; }
  const OutsideForces<d>& outside() const { return outside_; }
  OutsideForces<d>& outside() { return outside_; }
  /// Accelerations in this state without supports: those that it came to, or, if it is `still`, those of its
  /// stress, places and loads at velocity zero. nullopt if something is not finite.
  std::optional<OpenAcceleration> open(const State& state, bool still);
  const RateLaw<d>& law() const { return law_; }
  double smoothing_length() const { return h_; }                        ///< h [m]
  double wave_speed() const;                                            ///< c_p [m/s]
  double young() const;                                                 ///< E of (32) [Pa]
  const std::vector<double>& mass() const { return mass_; }             ///< [kg]
  const std::vector<double>& shepard() const { return shepard_; }       ///< S of (10), of the printed force
  const std::vector<Mat<d>>& moments() const { return M_; }             ///< M, the inverse of L in (9)
  const std::vector<Mat<d>>& velocity_gradients() const { return A_; }  ///< (16), of the last rates [1/s]
  const std::vector<double>& volumes() const { return V_; }  ///< that made M, L and the forces [m^d]
  /// How many corrections were not defined so far: such a particle has no stress force and no rates.
  long singular() const { return singular_; }
  long searches() const { return searches_; }

 private:
  using Point = typename RateLaw<d>::Point;

  Index count() const { return static_cast<Index>(mass_.size()); }
  Field make_field(int components) const { return {components, count(), 0}; }
  State make_state() const;
  MovingPairs<d, SplinePairs<d>> pairs() const { return {*neighbours_.list(), kernel_, x_, v_, V_}; }
  bool keeps_F() const { return options_.controls_hourglass() || outside_.needs_F(); }
  Point point_of(const State& state, Index i) const;
  void store(const Point& point, State& state, Index i) const;
  double damage_of(const State& state, Index i) const;
  double pressure_of(const State& state, Index i) const;  ///< [Pa]; a failed particle bears no tension
  std::optional<Trouble> find_trouble(const State& state) const;

  /// Makes the tables of the reference that a state carries, unless they are made.
  void follow_reference(const State& state);
  void rebuild_reference(const State& state);
  /// Finds the neighbours at x_. Where the list is new, or the reference old enough, x_ is the next reference.
  void find_neighbours(const State& state);

  /// M, S and A = grad v at x_ with the volumes V_ and the velocities v_.
  void sum_up();
  /// Density, stress, F and what is added to the stress of the force, from A_.
  void follow_rates(const State& state, double dt);
  /// Sum of (21) of every particle [kg/(m^3 s)] to rate_.
  void diffuse(const State& state);
  /// The body's own forces at x_ with the velocities v_, and the acceleration that follows.
  void find_forces(State& state);
  /// Forces between bodies at x_, which have moved with v_ and A_ for the time `apart` [s] since the last call.
  void press_bodies(State& state, double apart);
  /// Takes the accelerations of a state with its loads and walls to kick_; the loads alone are outside_.loads().
  void add_outside(const State& state, Field& anchors);
  /// Moves next_.v on by half a step with the forces, loads and supports of a state.
  void kick(const State& state, double half);
  void stress_forces(State& state);
  double stiffness_of(const State& state, Index i) const;
  void hourglass_forces(State& state);
  void viscous_forces(State& state);
  /// Adds the work of the forces of both ends of a step to that of next_, whose velocities were `from` [m/s].
  void count_work(const State& state, const Field& from, double half);

  Specimen<d> specimen_;
  EulerianOptions options_;
  RateLaw<d> law_;
  OutsideForces<d> outside_;
  std::optional<TouchingBodies<d>> touching_;
  double h_;
  SplinePairs<d> kernel_;
  MovingNeighbours<d> neighbours_;
  std::optional<ReferencePairs<d>> reference_;
  std::vector<double> mass_;
  NeighbourCounts counts_;
  long singular_ = 0, searches_ = 0;

  // room for one step, by particle
  std::vector<Vec<d>> x_, v_, half_, sum_;
  std::vector<double> V_, shepard_, rate_, power_, damped_, stiff_;
  std::vector<Mat<d>> M_, A_, L_, S_, extra_, repulsion_;
  std::vector<std::int32_t> near_;
  Field kick_, unused_;
  State next_;
};

}  // namespace plumb
