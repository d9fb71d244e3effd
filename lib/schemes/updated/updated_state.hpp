#pragma once
#include "lib/core/field.hpp"
#include "lib/geometry/moving_neighbours.hpp"
#include "lib/particles/role.hpp"
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Unknowns of the updated Lagrangian scheme, by particle; those that a choice of options does not need have
/// no components. In the conservative balance density, stress, F, plastic strain and the history of pairs
/// belong to the middle of the last step, and follow when the length of the next one is known.
template <int d>
struct UpdatedState {
  Field v;         ///< velocity [m/s]
  Field u;         ///< displacement x - X [m]
  Field density;   ///< [kg/m^3]
  Field stress;    ///< its deviator, d x d [Pa]; s_zz of plane strain is minus their trace
  Field F;         ///< deformation gradient, d x d, by the velocity gradients; its determinant is rho_0/rho
  Field gradient;  ///< of the velocity at the end of the step, d x d [1/s]
  Field plastic;   ///< plastic strain and plastic work per volume [Pa]; laws that yield
  Field heat;      ///< what the dissipation has taken [J]
  Field density_rate;    ///< [kg/(m^3 s)]; printed
  Field pull;            ///< force between pairs that is summed up in time [N]; printed
  Field frozen;          ///< positions and volume of the last advection step; printed, geometry = advection
  PairHistory bonds;     ///< stretch of each pair that is not in the velocity gradient [m]; conservative
  Field anchors;         ///< of friction at walls, in the frame of each [m]
  Field slip;            ///< that springs between rough bodies bear [m]
  double last_step = 0;  ///< [s]; 0: there was none
  double age = 0, life = 0;  ///< of the frozen geometry, so far and in all [s]
  OutsideWork outside = {};
  double time = 0;  ///< [s]
  long step = 0;

  template <class Visit>
  void fields(Visit&& visit) {
    const auto some = [&](const FieldInfo& info, Field& field) {
      if (field.components() > 0) visit(info, field);
    };
    some({"velocity", "m/s"}, v);
    some({"displacement", "m"}, u);
    some({"density", "kg/m^3", Role::history}, density);
    some({"deviatoric stress", "Pa", Role::history}, stress);
    some({"deformation gradient", "", Role::history}, F);
    some({"velocity gradient", "1/s", Role::history}, gradient);
    some({"plastic strain and work", "", Role::history}, plastic);
    some({"heat", "J", Role::history}, heat);
    some({"density rate", "kg/(m^3 s)", Role::history}, density_rate);
    some({"force of pairs", "N", Role::history}, pull);
    some({"frozen geometry", "m", Role::history}, frozen);
    some({"anchors of friction", "m", Role::history}, anchors);
    some({"slip between bodies", "m", Role::history}, slip);
  }

  /// What is kept of pairs: visit(name, history).
  template <class Visit>
  void pair_fields(Visit&& visit) {
    visit("stretch of pairs", bonds);
  }
  /// Numbers of the whole body: visit(name, value).
  template <class Visit>
  void whole_fields(Visit&& visit) {
    visit("last step", last_step);
    visit("age of the geometry", age);
    visit("life of the geometry", life);
    outside.whole_fields(visit);
  }
};

}  // namespace plumb
