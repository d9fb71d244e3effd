#pragma once
#include <vector>

#include "lib/actions/boundary_force.hpp"
#include "lib/measures/energy.hpp"
#include "lib/schemes/apply.hpp"
#include "lib/schemes/contact.hpp"

namespace plumb {

/// What loads, damping and supports have done to a body so far, as a part of its state.
struct OutsideWork {
  double loads = 0, damping = 0, supports = 0, contact = 0;  ///< work since the start [J]
  double rest_rate = 0;  ///< [1/s]: damping of a relaxation; 0 without one

  /// Numbers of the whole body: visit(name, value).
  template <class Visit>
  void whole_fields(Visit&& visit) {
    visit("work of loads", loads);
    visit("work of damping", damping);
    visit("work of supports", supports);
    visit("work of contact", contact);
    visit("rate of relaxation", rest_rate);
  }
};

/// Accelerations of all slots without what supports add [m/s^2].
struct OpenAcceleration {
  Field all;    ///< by the body's own forces, walls and the loads
  Field loads;  ///< by the loads alone; no components without loads
};

/// What one step did to the velocities, cause by cause [m/s]. Fields of causes that a body has not are empty.
struct StepChanges {
  Field from, to;        ///< the velocity between the halves of the damping; `to` for a budget only
  Field own;             ///< by the body's own forces; for a budget only
  Field loads, contact;  ///< by the loads, by the walls
};

/// What acts on a body from outside (loads, walls, damping, supports) in a scheme that steps velocities, with its
/// work. A step is begin_step(), some evaluations, end_step(); an evaluation is add_loads(), add_contact() where there are
/// walls, and hold(). Loads, walls and supports do the work of THEORY (8.6); the damping is THEORY (6.7).
template <int d>
class OutsideForces {
 public:
  OutsideForces() = default;
  /// What the body and its surroundings are made of.
  struct Medium {
    double density;      ///< [kg/m^d]
    double damping = 0;  ///< rate [1/s]
  };
  OutsideForces(const Actions<d>& actions, const Cloud<d>& cloud, const Slots& slots, const Medium& medium);

  /// Lets the body meet walls.
  void touch(Contact<d> contact);  // and other bodies
  const Contact<d>& contact() const { return contact_; }

  /// Keeps also what a budget needs of each step; what changes() has then is that of the last one.
  void follow_changes();
  const StepChanges& changes() const { return changes_; }

  bool needs_F() const { return applied_.needs_F(); }  ///< some load is a pressure
  bool damps() const { return medium_.damping > 0; }
  bool loads_body() const { return loaded_; }
  /// Puts held components where they are prescribed to be at the start.
  void start(Field& u, Field& v) const { applied_.impose(0, u, v, true); }

  /// Puts held components where they are prescribed to be within a step.
  void impose(double time, Field& u, Field& v) const { applied_.impose(time, u, v, false); }

  /// Half of the damping of a step of dt [s].
  void begin_step(double dt, Field& v, OutsideWork& work);
  /// Adds the accelerations by the loads at that time [s]. F: by slot, d x d; null where needs_F() is false.
  void add_loads(double time, const Field* F, Field& v_rate);
  /// Adds the accelerations by the walls at the positions x [m], and drags the anchors of friction along.
  void add_contact(double time, const std::vector<Vec<d>>& x, Field& anchors, Field& v_rate) {
    if (!contact_.empty()) contact_.add(time, x, anchors, v_rate);
  }
  /// Adds the accelerations by forces between bodies; after add_contact().
  void add_between(const Field& acceleration, Field& v_rate) { contact_.add_between(acceleration, v_rate); }
  /// Gives the rates of held components their prescribed values. `weight` [s] is the share that the velocity
  /// at the end of the step has of these rates; 0: they do not count.
  void hold(double time, double weight, const Field& v, Field& v_rate, Field& u_rate);
  /// Puts held components where they are prescribed to be at the end of the step; the other half of the
  /// damping, and that of a relaxation.
  void end_step(double time, double dt, Field& u, Field& v, OutsideWork& work);

  const Field& loads() const { return loads_; }  ///< as add_loads() found them; no components without loads
  /// Work of "loads", "damping", "supports" and "contact" of those that there are. [J]
  std::vector<NamedEnergy> named(const OutsideWork& work) const;
  /// The force of the supports of each boundary on the body [N], THEORY (5.9); of a component that two
  /// boundaries hold it belongs to the later one. After them that of each wall, as add_contact() found it last.
  std::vector<BoundaryForce<d>> reactions(double time, const OpenAcceleration& open, const Field& v) const;

  std::vector<BoundaryForce<d>> no_reactions() const;  ///< of every boundary and every wall 0

  /// One held component.
  struct Place {
    Index slot;
    int component;
    std::size_t boundary;  ///< in Actions::held
    Vec<d> at;
    bool moves;  ///< at some time
  };
  const std::vector<Place>& held() const { return held_; }   ///< each once, in the order of slots
  const std::vector<double>& mass() const { return mass_; }  ///< by slot [kg]; 0 where no particle is

 private:
  Index count() const { return static_cast<Index>(mass_.size()); }
  /// Multiplies the velocity of what is free by 1 + change, and returns the work of that [J].
  double damp(double change, Field& v) const;
  /// Returns the work of accelerations that have changed the velocities of this step by so much, up to v [J].
  double work_of(const Field& change, const Field& v) const;
  void subtract_others(double weight);
  void damp_half(double dt, Field& v, OutsideWork& work) const;

  AppliedActions<d> applied_;
  std::vector<Held<d>> boundaries_;  ///< without their places
  std::vector<Place> held_;
  std::vector<double> mass_;
  Medium medium_{1};
  Contact<d> contact_;
  bool loaded_ = false, moved_ = false;
  bool followed_ = false;  ///< by a budget
  Field loads_;
  StepChanges changes_;            ///< of the present step
  std::vector<double> by_others_;  ///< change by all but the supports, per held component [m/s]
};

}  // namespace plumb
