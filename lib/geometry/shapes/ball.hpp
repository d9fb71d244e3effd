#pragma once
#include "lib/geometry/shape.hpp"

namespace plumb {

/// A ball; in 2D a disc.
struct Ball {
  static constexpr std::string_view name = "ball";
  template <int d>
  static constexpr bool dimensions = true;
  static std::vector<ShapeLength> lengths() {
    return {{"centre", "zeros where it is left out", ShapeLength::Kind::point, false},
            {"radius", "of the ball or the cylinder", ShapeLength::Kind::length}};
  }

  std::vector<double> centre;
  double radius;
  explicit Ball(const ShapeLengths& l) : centre(l.at("centre")), radius(l.at("radius")[0]) {
    if (!(radius > 0)) throw InputError("a ball whose radius is not positive", "it is empty", "");
  }

  template <int d>
  Box<d> box() const {
    return {Vec<d>(centre.data()) - Vec<d>::Constant(radius), Vec<d>::Constant(2 * radius)};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    return (X - Vec<d>(centre.data())).norm() - radius;
  }
};

}  // namespace plumb
