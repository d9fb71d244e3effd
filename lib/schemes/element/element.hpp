#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "lib/schemes/element/element_body.hpp"
#include "lib/schemes/implicit/stored_energy.hpp"
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Displacements and velocities of nodes.
struct ElementState {
  Field u;  ///< [m]
  Field v;  ///< [m/s]
  OutsideWork outside = {};
  double time = 0;  ///< [s]
  long step = 0;

  template <class Visit>
  void fields(Visit&& visit) {
    visit(FieldInfo{"displacement", "m"}, u);
    visit(FieldInfo{"velocity", "m/s"}, v);
  }
  template <class Visit>
  void whole_fields(Visit&& visit) {
    outside.whole_fields(visit);
  }
};

/// Finite elements on the nodes of a box, with lumped masses: what others use on such a body, for comparison.
/// They move by velocity Verlet (kick, drift, kick); stored_energy() lets others seek their equilibria. All
/// laws but those that follow rates. THEORY (15.7), (15.8), (15.9), (15.10).
template <int d>
class Element {
 public:
  static constexpr std::string_view name = "element";
  using Options = ElementOptions;
  using State = ElementState;

  /// `damping`: rate [1/s], THEORY (6.7). InputError where the cloud is no node lattice, or the law has no energy.
  Element(Specimen<d> specimen, ElementOptions options, Actions<d> actions, double damping = 0);

  /// At rest in the reference where the motion has no entries.
  State start(const InitialMotion<d>& motion) const;
  /// cfl 2/omega of the stiffest cell [s], less as the body is compressed. THEORY (15.10).
  double step_limit(const State& state);
  std::optional<Trouble> advance(State& state, double dt);
  Snapshot<d> snapshot(const State& state) const;
  Energy energy(const State& state) const;
  std::vector<Statement> account() const;

  /// The energy whose equilibria can be sought; it lives on its own.
  StoredEnergy<d> stored_energy() const;
  const Actions<d>& actions() const { return actions_; }  ///< with areas that fit the elements
  Slots layout() const { return {body_.cloud.size(), 0, 0, 1}; }

  /// Visits what points remember, with their number: for checkpoints.
  template <class Visit>
  void fields_at_points(Visit&& visit) {
    if (body_.memory)
      visit(FieldInfo{"law's history at points", "", Role::history}, body_.memory->history, body_.points());
  }

  static constexpr int evaluations_per_step = 1;
  NeighbourCounts neighbours() const { return neighbours_; }
  const ElementBody<d>& body() const { return body_; }
  const OutsideForces<d>& outside() const { return outside_; }
  OutsideForces<d>& outside() { return outside_; }
  /// Accelerations in this state, which do not depend on the velocity; nullopt if a cell is inverted.
  std::optional<OpenAcceleration> open(const State& state, bool still);

 private:
  Field nodal(int components) const { return {components, body_.cloud.size(), 0}; }
  /// Makes F_ and rate_ those of the displacements at that time, unless they are. Supports are not in them.
  std::optional<Trouble> evaluate(const Field& u, double time);

  ElementOptions options_;
  ElementBody<d> body_;
  Actions<d> actions_;
  OutsideForces<d> outside_;
  NeighbourCounts neighbours_;
  double omega_;  ///< of the stiffest cell [1/s]
  Field F_;       ///< by point
  Field rate_;    ///< acceleration by the body's own forces and the loads [m/s^2]
  Field seen_u_;  ///< what F_ and rate_ are of
  std::optional<double> seen_time_;
};

}  // namespace plumb
