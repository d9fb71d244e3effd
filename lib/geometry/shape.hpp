#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Lengths that make a shape, by name [m]: a radius has one value, a point one per dimension, a list of
/// points as many as they have together.
using ShapeLengths = std::map<std::string, std::vector<double>>;

/// One entry of ShapeLengths: what a scene must or may say.
struct ShapeLength {
  enum class Kind { length, point, direction, points };
  std::string name, meaning;
  Kind kind;
  bool required = true;  ///< points that are left out are the origin
};

/// A shape of the catalogue is a value made from its lengths. A new one is one file in shapes/, with
///   name, dimensions<d>   true for the dimensions it exists in
///   lengths()             what a scene says of it
///   box<d>()              a box that holds it [m]
///   distance<d>(X)        signed distance to its surface, negative inside [m]; the faces of the box may be
///                         left out: the body is what the distance leaves of the box
///   fills_its_box         (optional) there is nothing that the distance takes off the box: true for all
///                         bodies of the shape, or a function that says it of this one
template <class S, int d>
concept ShapeModel = std::constructible_from<S, const ShapeLengths&> &&
    requires(const S& s, const Vec<d>& X) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::lengths() } -> std::same_as<std::vector<ShapeLength>>;
  { s.template box<d>() } -> std::same_as<Box<d>>;
  { s.template distance<d>(X) } -> std::same_as<double>;
};

/// A body's shape, chosen at run time: the part of the box where `clip` is negative. The clip is a signed
/// distance [m] (or below it in size, as the larger of two distances is), so that a ball about X with that
/// radius meets no surface. The faces of the box count as surface only where clip leaves them.
template <int d>
struct Shape {
  Box<d> box;
  std::function<double(const Vec<d>&)> clip;

  /// Signed distance to the body's surface, faces of the box included; negative inside [m].
  double distance(const Vec<d>& X) const;
};

/// The shape of that name with its lengths. InputError for unknown names, lengths that are missing, have the
/// wrong number of values or make no body, and for shapes that do not exist in this dimension.
template <int d>
Shape<d> shape_named(std::string_view name, const ShapeLengths& lengths);

/// What a hole (or a half-space that cuts) leaves of a body.
template <int d>
Shape<d> without(Shape<d> body, const Shape<d>& hole);

/// What a scene may say of the shape of that name.
std::vector<ShapeLength> lengths_of_shape(std::string_view name);

/// Names of the catalogue.
std::vector<std::string> shape_catalogue_names();

}  // namespace plumb
