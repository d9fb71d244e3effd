#pragma once
#include "lib/geometry/shape.hpp"

namespace plumb {

/// The ring between two circles about one centre; in 3D the shell between two spheres.
struct Annulus {
  static constexpr std::string_view name = "annulus";
  template <int d>
  static constexpr bool dimensions = true;
  static std::vector<ShapeLength> lengths() {
    return {{"centre", "zeros where it is left out", ShapeLength::Kind::point, false},
            {"inner", "inner radius", ShapeLength::Kind::length},
            {"outer", "outer radius", ShapeLength::Kind::length}};
  }

  std::vector<double> centre;
  double inner, outer;
  explicit Annulus(const ShapeLengths& l)
      : centre(l.at("centre")), inner(l.at("inner")[0]), outer(l.at("outer")[0]) {
    if (!(inner > 0) || !(outer > inner))
      throw InputError("an annulus whose radii are not 0 < inner < outer", "it is empty", "");
  }

  template <int d>
  Box<d> box() const {
    return {Vec<d>(centre.data()) - Vec<d>::Constant(outer), Vec<d>::Constant(2 * outer)};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    const double r = (X - Vec<d>(centre.data())).norm();
    return std::max(inner - r, r - outer);
  }
};

}  // namespace plumb
