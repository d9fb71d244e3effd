#pragma once
#include "lib/geometry/flat_pieces.hpp"

namespace plumb {

/// Everything beyond the plane through `point`, on the side to which `normal` shows: to cut a body with.
struct HalfSpace {
  static constexpr std::string_view name = "half-space";
  template <int d>
  static constexpr bool dimensions = true;
  static std::vector<ShapeLength> lengths() {
    return {{"point", "a point of the plane", ShapeLength::Kind::point},
            {"normal", "direction out of the material", ShapeLength::Kind::direction}};
  }

  std::vector<double> point, normal;
  explicit HalfSpace(const ShapeLengths& l) : point(l.at("point")), normal(l.at("normal")) {
    double square = 0;
    for (const double n : normal) square += n * n;
    if (!(square > 0)) throw InputError("a half-space whose normal is zero", "it has no side", "");
    for (double& n : normal) n /= std::sqrt(square);
  }

  /// Without bounds: refused as a body, since no lattice fills it.
  template <int d>
  Box<d> box() const {
    return {Vec<d>(point.data()), Vec<d>::Constant(std::numeric_limits<double>::infinity())};
  }
  template <int d>
  double distance(const Vec<d>& X) const {
    return -Vec<d>(normal.data()).dot(X - Vec<d>(point.data()));
  }
  template <int d>
  void flats(const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) const {
    if (std::abs(distance<d>(X)) <= radius) planes.push_back({Vec<d>(point.data()), Vec<d>(normal.data())});
  }
};

}  // namespace plumb
