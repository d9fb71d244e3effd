#pragma once
#include <limits>

#include "lib/geometry/shape.hpp"

namespace plumb {

/// An axis-parallel box.
struct Cuboid {
  static constexpr std::string_view name = "box";
  static constexpr bool fills_its_box = true;  ///< its faces are those of its box: nothing is left to clip
  template <int d>
  static constexpr bool dimensions = true;
  static std::vector<ShapeLength> lengths() {
    return {{"origin", "lowest corner; zeros where it is left out", ShapeLength::Kind::point, false},
            {"size", "edge lengths", ShapeLength::Kind::point}};
  }

  std::vector<double> origin, size;
  explicit Cuboid(const ShapeLengths& l) : origin(l.at("origin")), size(l.at("size")) {
    for (const double length : size)
      if (!(length > 0)) throw InputError("a box with an edge that is not positive", "it is empty", "");
  }

  template <int d>
  Box<d> box() const {
    return {Vec<d>(origin.data()), Vec<d>(size.data())};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    const Vec<d> half = 0.5 * Vec<d>(size.data());
    const Vec<d> beyond = (X - Vec<d>(origin.data()) - half).cwiseAbs() - half;
    return beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff());
  }
};

}  // namespace plumb
