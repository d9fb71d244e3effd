#pragma once
#include <vector>

#include "lib/actions/actions.hpp"
#include "lib/core/field.hpp"
#include "lib/geometry/cloud.hpp"

namespace plumb {

/// What acts on a body from outside, laid out for a scheme that keeps its unknowns in fields by slot. Loads
/// and held components are evaluated at the time that they are asked for, so stages of a step see their own.
template <int d>
class AppliedActions {
 public:
  AppliedActions() = default;
  AppliedActions(const Actions<d>& actions, const Cloud<d>& cloud, const Slots& slots);

  bool has_loads() const { return !surface_.empty() || !actions_.body_forces.empty(); }
  bool needs_F() const { return follows_; }  ///< some load is a pressure

  /// Adds `factor` times the force per unit reference volume [N/m^d] at that time [s] to a field of d
  /// components. F: deformation gradient by slot, d x d; read only by pressures, may else be null.
  void add_loads(double time, const Field* F, double factor, Field& to) const;
  /// Gives the rate of the velocity of held components their prescribed acceleration [m/s^2], and the rate of
  /// their displacement their velocity [m/s], which is read from v.
  void hold(double time, const Field& v, Field& v_rate, Field& u_rate) const;
  /// Puts held components where they are prescribed to be. `all`: those of constant velocity, too.
  void impose(double time, Field& u, Field& v, bool all) const;

 private:
  struct SurfacePlace {
    Index slot;
    std::size_t load;  ///< in actions_.surface
    Vec<d> at, normal;
    double per_volume;  ///< A/V [1/m]
  };
  struct HeldSlot {
    Index slot;
    int component;
    std::size_t held;  ///< in actions_.held
    Vec<d> at;
  };
  Actions<d> actions_;
  std::vector<SurfacePlace> surface_;
  std::vector<HeldSlot> held_;
  std::vector<Vec<d>> X_;    ///< of every particle, where body forces act
  std::vector<Index> slot_;  ///< of every particle, likewise
  Field steady_;             ///< sum of the steady body forces [N/m^d]; empty without one
  Index count_ = 0;          ///< slots
  bool follows_ = false;
};

}  // namespace plumb
