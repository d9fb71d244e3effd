#pragma once
#include <algorithm>
#include <array>

#include "lib/geometry/cloud.hpp"

namespace plumb::mms {

/// What is known on the boundary, for one component of the motion.
enum class Known { displacement, traction };

/// Condition of one face, apart for the direction of its normal and for the directions along it.
struct FaceCondition {
  Known normal = Known::displacement;
  Known tangential = Known::displacement;
};

inline constexpr FaceCondition held{Known::displacement, Known::displacement};  ///< all components prescribed
inline constexpr FaceCondition roller{Known::displacement, Known::traction};  ///< normal component prescribed
inline constexpr FaceCondition loaded{Known::traction, Known::traction};  ///< P N prescribed, or zero: free

/// Where a manufactured solution lives, in the reference configuration [m].
template <int d>
struct Domain {
  enum class Shape { box, annulus };
  Shape shape = Shape::box;
  Box<d> box;                   ///< the box, or the square around the annulus
  double inner = 0, outer = 0;  ///< radii of the annulus about the origin; 2D only
  /// Box: x-, x+, y-, y+, (z-, z+). Annulus: inner and outer circle in the first two.
  std::array<FaceCondition, 2 * d> faces{};

  /// The least extent: scale of the details.
  double length() const { return shape == Shape::annulus ? outer - inner : box.size.minCoeff(); }
  /// Distance of a point inside from the boundary [m].
  double depth(const Vec<d>& X) const {
    if (shape == Shape::annulus) return std::min(X.norm() - inner, outer - X.norm());
    return std::min((X - box.origin).minCoeff(), (box.origin + box.size - X).minCoeff());
  }
  bool contains(const Vec<d>& X) const {
    if (shape == Shape::annulus) return X.norm() >= inner && X.norm() <= outer;
    return ((X - box.origin).array() >= 0).all() && ((X - box.origin - box.size).array() <= 0).all();
  }
};

/// A box with the same condition on all faces.
template <int d>
Domain<d> box_domain(const Vec<d>& origin, const Vec<d>& size, FaceCondition condition) {
  Domain<d> domain;
  domain.box = {origin, size};
  domain.faces.fill(condition);
  return domain;
}

/// An annulus about the origin with the same condition on both circles.
inline Domain<2> annulus_domain(double inner, double outer, FaceCondition condition) {
  Domain<2> domain;
  domain.shape = Domain<2>::Shape::annulus;
  domain.box = {Vec<2>::Constant(-outer), Vec<2>::Constant(2 * outer)};
  domain.inner = inner;
  domain.outer = outer;
  domain.faces.fill(condition);
  return domain;
}

}  // namespace plumb::mms
