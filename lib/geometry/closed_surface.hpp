#pragma once
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "lib/geometry/beside_surface.hpp"
#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Corners of triangles as numbers of points.
struct TriangleMesh {
  std::vector<Vec<3>> points;                      ///< [m]
  std::vector<std::array<std::size_t, 3>> corner;  ///< per triangle, counterclockwise seen from outside
};

/// Holds the corners of a triangle [m].
using Corners = std::array<Vec<3>, 3>;

/// The corners of one triangle [m].
inline Corners corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& c = mesh.corner[triangle];
  return {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]};
}

/// The mesh of these triangles, nine numbers each: corners with equal coordinates are one point.
TriangleMesh mesh_of_corners(const std::vector<double>& coordinates);

/// Requires that the triangles close one or several surfaces that do not meet each other or themselves, and
/// turns them so that outside is outside: hollows within a body too. Throws InputError with the place for a
/// surface that is open, that branches, whose triangles are empty, do not agree on the outside, fold onto
/// each other or cross.
void require_closed(TriangleMesh& mesh);

/// Signed distances to a closed surface: nearest triangles by a tree of boxes, the sign by the pseudonormal
/// of the nearest face, edge or corner (Baerentzen and Aanaes 2005, IEEE Trans. Vis. Comput. Graph. 11, 243).
class ClosedSurface {
 public:
  /// Makes the surface of a mesh that require_closed() has passed.
  explicit ClosedSurface(TriangleMesh mesh);
  ~ClosedSurface();

  Box<3> box() const { return box_; }
  /// Whether all triangles lie on the faces of the box.
  bool fills_its_box() const;
  /// To the triangles that do not lie on faces of the box; the sign is that of the body within its box
  /// [m]. Infinite in size if there is none.
  double distance(const Vec<3>& X) const;
  /// Signed distance to all triangles and the direction away from them.
  BesideSurface<3> beside(const Vec<3>& X) const;

 private:
  struct Tree;
  Box<3> box_;
  std::unique_ptr<Tree> all_, inner_;  ///< inner: without triangles on faces of the box
};

}  // namespace plumb
