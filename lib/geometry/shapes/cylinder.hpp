#pragma once
#include "lib/geometry/shape.hpp"

namespace plumb {

/// A cylinder along z; its two ends are faces of its box. 3D.
struct Cylinder {
  static constexpr std::string_view name = "cylinder";
  template <int d>
  static constexpr bool dimensions = d == 3;
  static std::vector<ShapeLength> lengths() {
    return {{"centre", "zeros where it is left out", ShapeLength::Kind::point, false},
            {"radius", "of the ball or the cylinder", ShapeLength::Kind::length},
            {"length", "of the cylinder", ShapeLength::Kind::length}};
  }

  std::vector<double> centre;
  double radius, length;
  explicit Cylinder(const ShapeLengths& l)
      : centre(l.at("centre")), radius(l.at("radius")[0]), length(l.at("length")[0]) {
    if (!(radius > 0) || !(length > 0))
      throw InputError("a cylinder whose radius or length is not positive", "it is empty", "");
  }

  template <int d>
  Box<d> box() const {
    const Vec<d> half(radius, radius, length / 2);
    return {Vec<d>(centre.data()) - half, 2 * half};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    return std::hypot(X[0] - centre[0], X[1] - centre[1]) - radius;
  }
};

}  // namespace plumb
