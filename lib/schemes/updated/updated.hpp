#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "lib/schemes/outside.hpp"
#include "lib/schemes/pair_row.hpp"
#include "lib/schemes/rate_law.hpp"
#include "lib/schemes/scheme.hpp"
#include "lib/schemes/touching_bodies.hpp"
#include "lib/schemes/updated/pair_sums.hpp"
#include "lib/schemes/updated/updated_options.hpp"
#include "lib/schemes/updated/updated_state.hpp"

namespace plumb {

/// The updated Lagrangian scheme of paper 002: stress by rates, kernels at the positions of now, neighbours
/// that change, and a force between pairs against hourglass modes. THEORY, chapter 17.
template <int d>
class Updated {
 public:
  static constexpr std::string_view name = "updated";
  using Options = UpdatedOptions;
  using State = UpdatedState<d>;

  /// `damping`: rate [1/s], THEORY (6.7); `walls`: what the body may touch; `touch`: how the bodies of the cloud press on each
  /// other; both of the conservative balance only. InputError where the neighbours of a particle do not span the space, two particles are at one place, or
  /// the law does not go with the options.
  Updated(Specimen<d> specimen, UpdatedOptions options, const Actions<d>& actions, double damping = 0,
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
  std::vector<std::string> warnings() const { return options_.warnings(); }

  const UpdatedOptions& options() const { return options_; }
  const RateLaw<d>& law() const { return law_; }
  double smoothing_length() const { return h_; }  ///< h [m]
  double wave_speed() const;                      ///< of the fastest wave of the discrete body [m/s]
  const std::vector<double>& mass() const { return mass_; }  ///< [kg]
  long searches() const { return neighbours_.searches(); }
  /// How many corrections were blended with I so far.
  long guarded() const { return guarded_; }
  const OutsideForces<d>& outside() const { return outside_; }
  OutsideForces<d>& outside() { return outside_; }
  /// Accelerations in this state, without dissipation if it is `still`; of the conservative balance only.
  std::optional<OpenAcceleration> open(const State& state, bool still);
  bool opens() const { return options_.conservative(); }
  /// The forces of the last step [N], without loads; empty steps have none.
  const std::vector<Vec<d>>& forces() const { return force_; }

 private:
  using Point = typename RateLaw<d>::Point;

  Index count() const { return static_cast<Index>(mass_.size()); }
  Field make_field(int components) const { return {components, count(), 0}; }
  State make_state() const;
  MovingPairs<d, KernelSlope> pairs() const { return {*neighbours_.list(), slope_, x_, v_, V_}; }
  double bond_modulus() const { return options_.has_bonds() ? options_.strength(d) * law_.shear : 0; }
  Point point_of(const State& state, Index i) const;
  void store(const Point& point, State& state, Index i) const;
  void deform(State& state, const InitialMotion<d>& motion);
  /// Positions and velocities of the state in rows; the first particle that is not finite.
  std::optional<Trouble> load(const State& state);
  std::optional<Trouble> find_trouble(const State& state) const;
  /// M, B and velocity gradients at x_; the gradients go to the state.
  void differentiate(State& state);
  void correct();

  std::optional<Trouble> advance_conservative(State& state, double dt);
  /// Density, stress and F of particle i after the time tau with the gradient of its state.
  struct Moved {
    Point point;
    double density;
    Mat<d> F;
  };
  Moved moved(const State& state, Index i, double tau) const;
  /// What the snapshot and the energies show: of the end of the step.
  Moved at_end_of_step(const State& state, Index i) const;
  /// Stretches `before`, which belongs to the list of now, into the room of the next state.
  void stretch_bonds(const State& state, const PairHistory& before, double tau);
  Mat<d> reaction(const PairHistory& bonds, const PairRow<d>& row) const;
  void conservative_forces(const PairHistory& bonds, bool dissipates);
  /// Accelerations at x_ by stress, density and pairs of the next state, and by loads and walls of that time; without
  /// dissipation if it is `still`.
  /// `apart` [s]: how long velocities and gradients v_, L have slid bodies along each other since the last call.
  void balance(double time, bool still, const State& state, double apart);
  void press_bodies(const State& state, double apart);
  double bond_energy(const State& state);

  std::optional<Trouble> advance_printed(State& state, double dt);
  void follow_geometry(State& state, double dt);
  void printed_forces(const State& state);
  void printed_rates(State& next, double dt);
  void sum_up(const State& state, State& next, double dt);

  Specimen<d> specimen_;
  UpdatedOptions options_;
  RateLaw<d> law_;
  OutsideForces<d> outside_;
  std::optional<TouchingBodies<d>> touching_;
  double h_;
  KernelSlope slope_;
  MovingNeighbours<d> neighbours_;
  std::vector<double> mass_, least_det_;
  NeighbourCounts counts_;
  long guarded_ = 0;

  // room for one step, by particle
  std::vector<Vec<d>> x_, v_, force_;
  std::vector<double> V_, impedance_, pressure_, yield_ratio_, heat_;
  std::vector<Mat<d>> M_, B_, S_;
  std::vector<std::int32_t> near_;
  Field acceleration_, between_, unused_;
  State next_;
};

}  // namespace plumb
