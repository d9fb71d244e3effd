#pragma once
#include "lib/core/field.hpp"
#include "lib/particles/role.hpp"
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Unknowns of the scheme of paper 003, by slot. Those that a choice of options does not need have no
/// components. F, H and J are total, from the material configuration: f F_chi, h H_chi and j J_chi of the
/// paper.
template <int d>
struct MixedState {
  Field v;        ///< velocity [m/s]; the paper's momentum is rho v
  Field u;        ///< displacement x - X [m]
  Field F;        ///< deformation gradient, d x d; where it cannot be found from the positions
  Field H;        ///< 3 x 3, its cofactors; evolved kinematics
  Field J;        ///< its determinant; evolved kinematics
  Field heat;     ///< what the upwinding has dissipated, per reference volume [J/m^d]
  Field chi;      ///< displacement of the reference [m]; options 1 to 4
  Field F_chi;    ///< deformation gradient of the reference; likewise
  Field history;  ///< values of the law's history
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
    some({"deformation gradient", ""}, F);
    some({"cofactor", ""}, H);
    some({"determinant", ""}, J);
    some({"heat", "J/m^3"}, heat);
    some({"reference displacement", "m", Role::history}, chi);
    some({"reference deformation gradient", "", Role::history}, F_chi);
    some({"law's history", "", Role::history}, history);
  }
  template <class Visit>
  void whole_fields(Visit&& visit) {
    outside.whole_fields(visit);
  }
};

}  // namespace plumb
