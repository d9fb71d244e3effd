#pragma once
#include <fmt/format.h>

#include "lib/geometry/crossing.hpp"
#include "lib/geometry/flat_pieces.hpp"

namespace plumb {

/// A polygon of any form, given by its corners in order, in either direction. The first one may be repeated
/// at the end. 2D. InputError if it is empty or its edges meet elsewhere than at common corners.
struct Polygon {
  static constexpr std::string_view name = "polygon";
  template <int d>
  static constexpr bool dimensions = d == 2;
  static std::vector<ShapeLength> lengths() {
    return {{"corners", "the corners in order", ShapeLength::Kind::points}};
  }

  std::vector<Vec<2>> corners;
  Vec<2> lower, upper;  ///< of the box around
  explicit Polygon(const ShapeLengths& l) {
    const auto& values = l.at("corners");
    for (std::size_t k = 0; k + 1 < values.size(); k += 2) corners.emplace_back(values[k], values[k + 1]);
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) throw InputError("a polygon of fewer than three corners", "it is empty", "");
    meet_the_box();
    require_simple();
  }

  template <int d>
  Box<d> box() const {
    return {lower, upper - lower};
  }

  /// Whether all edges lie on the faces of the box: a rectangle.
  bool fills_its_box() const {
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (!on_face(k)) return false;
    return true;
  }

  /// From the edges that do not lie on faces of the box.
  template <int d>
  double distance(const Vec<d>& X) const {
    // on a face of the box, and beyond it, the side is that of the material next to it
    const Vec<2> margin = 1e-12 * (upper - lower);
    const Vec<2> at = X.cwiseMax(lower + margin).cwiseMin(upper - margin);
    double square = std::numeric_limits<double>::infinity();
    bool inside = false;  // an odd number of edges crosses the ray along x
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec<2>&a = corners[k], &b = next(k);
      const Vec<2> edge = b - a;
      if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / edge[1] * edge[0])
        inside = !inside;
      if (!on_face(k)) square = std::min(square, square_to_edge(k, X));
    }
    return inside ? -std::sqrt(square) : std::sqrt(square);
  }
  template <int d>
  void flats(const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) const {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (on_face(k) || square_to_edge(k, X) > radius * radius) continue;
      const Vec<2> edge = (next(k) - corners[k]).normalized();
      planes.push_back({corners[k], Vec<2>(edge[1], -edge[0])});
    }
  }

 private:
  double square_to_edge(std::size_t k, const Vec<2>& X) const {
    const Vec<2>& a = corners[k];
    const Vec<2> edge = next(k) - a;
    const double t = std::clamp((X - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return (X - a - t * edge).squaredNorm();
  }
  const Vec<2>& next(std::size_t k) const { return corners[(k + 1) % corners.size()]; }

  bool on_face(std::size_t k) const {
    for (int axis = 0; axis < 2; ++axis)
      for (const double face : {lower[axis], upper[axis]})
        if (corners[k][axis] == face && next(k)[axis] == face) return true;
    return false;
  }

  /// Corners that miss a face of the box by rounding are put on it.
  void meet_the_box() {
    lower = upper = corners[0];
    for (const auto& corner : corners) {
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
    for (auto& corner : corners)
      for (int axis = 0; axis < 2; ++axis)
        for (const double face : {lower[axis], upper[axis]})
          if (std::abs(corner[axis] - face) <= 1e-9 * (upper[axis] - lower[axis])) corner[axis] = face;
  }

  void require_simple() const {
    const auto place = [this](std::size_t k) {
      return fmt::format("({:.9g}, {:.9g})", corners[k][0], corners[k][1]);
    };
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k)
      if (corners[k] == next(k))
        throw InputError("a polygon with the corner " + place(k) + " twice in a row",
                         "there is no edge between them", "leave one of them out");
    double twice_area = 0;
    for (std::size_t k = 0; k < n; ++k) {
      twice_area += corners[k][0] * next(k)[1] - corners[k][1] * next(k)[0];
      if (folds_back(corners[k], next(k), next((k + 1) % n)))
        throw InputError("a polygon whose edges lie on each other at " + place((k + 1) % n),
                         "it has no inside there", "give the corners in the order of the outline");
      for (std::size_t m = k + 2; m < n; ++m)
        if ((m + 1) % n != k && segments_meet(corners[k], next(k), corners[m], next(m)))
          throw InputError(fmt::format("a polygon whose edges from {} and from {} cross", place(k), place(m)),
                           "its inside is not defined", "give the corners in the order of the outline");
    }
    if (!(std::abs(twice_area) > 0)) throw InputError("a polygon without area", "it is empty", "");
  }
};

}  // namespace plumb
