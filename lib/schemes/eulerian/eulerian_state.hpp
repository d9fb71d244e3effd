#pragma once
#include "lib/core/field.hpp"
#include "lib/particles/role.hpp"
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Work of a body's own forces since the start, by what has done it [J].
struct WorkByCause {
  double force = 0;      ///< of the stress force
  double hourglass = 0;  ///< of hourglass control
  double viscosity = 0;  ///< of (17)
  double stress = 0;     ///< what the stress has received: not a force
  double damping = 0;    ///< what the damping has received: likewise

  double of_forces() const { return force + hourglass + viscosity; }
};

/// Unknowns of the Eulerian-kernel scheme at one instant, by particle; those that a choice of options does not
/// need have no components.
template <int d>
struct EulerianState {
  Field v;             ///< velocity [m/s]
  Field u;             ///< displacement x - X [m]
  Field density;       ///< [kg/m^3]
  Field stress;        ///< its deviator, d x d [Pa]; s_zz of plane strain is minus their trace
  Field plastic;       ///< plastic strain and plastic work per volume [Pa]; laws that yield
  Field acceleration;  ///< by the body's own forces [m/s^2]
  Field force;         ///< of the stress [N]
  Field hourglass;     ///< force of hourglass control [N]
  Field viscous;       ///< force of viscosity [N]
  Field F;             ///< deformation gradient (30), d x d; hourglass control and pressures
  Field place;         ///< displacement of the reference of (30) [m]
  Field before;        ///< F of that reference, d x d: F_init of (30)
  Field volume;        ///< of that reference [m^d]
  Field anchors;       ///< of friction at walls, in the frame of each [m]
  Field slip;          ///< that springs between rough bodies bear [m]
  Field between;       ///< acceleration by forces between bodies [m/s^2]
  WorkByCause work;
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
    some({"plastic strain and work", "", Role::history}, plastic);
    some({"acceleration", "m/s^2", Role::history}, acceleration);
    some({"stress force", "N", Role::history}, force);
    some({"hourglass force", "N", Role::history}, hourglass);
    some({"viscous force", "N", Role::history}, viscous);
    some({"deformation gradient", "", Role::history}, F);
    some({"displacement of the reference", "m", Role::history}, place);
    some({"deformation gradient of the reference", "", Role::history}, before);
    some({"volume of the reference", "m^d", Role::history}, volume);
    some({"anchors of friction", "m", Role::history}, anchors);
    some({"slip between bodies", "m", Role::history}, slip);
    some({"acceleration between bodies", "m/s^2", Role::history}, between);
  }

  /// Numbers of the whole body: visit(name, value).
  template <class Visit>
  void whole_fields(Visit&& visit) {
    visit("work of the stress force", work.force);
    visit("work of hourglass control", work.hourglass);
    visit("work of viscosity", work.viscosity);
    visit("work into stress", work.stress);
    visit("work into damping", work.damping);
    outside.whole_fields(visit);
  }
};

}  // namespace plumb
