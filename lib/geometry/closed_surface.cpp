#include "lib/geometry/closed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "lib/geometry/box_tree.hpp"
#include "lib/geometry/triangle.hpp"

namespace plumb {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

Edge sorted(std::size_t a, std::size_t b) {
  return std::minmax(a, b);
}

/// Unit normals of faces, and pseudonormals of edges and corners of each triangle: the edge k begins at
/// corner k.
struct Normals {
  std::vector<Vec<3>> face;
  std::vector<std::array<Vec<3>, 3>> edge, corner;
};

Normals normals_of(const TriangleMesh& mesh) {
  Normals normals;
  std::vector<Vec<3>> of_point(mesh.points.size(), Vec<3>::Zero());
  std::map<Edge, Vec<3>> of_edge;
  for (std::size_t t = 0; t < mesh.corner.size(); ++t) {
    const auto x = corners_of(mesh, t);
    const Vec<3> n = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    normals.face.push_back(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec<3> to = x[(k + 1) % 3] - x[k], from = x[(k + 2) % 3] - x[k];
      of_point[mesh.corner[t][k]] += std::atan2(to.cross(from).norm(), to.dot(from)) * n;
      of_edge.try_emplace(sorted(mesh.corner[t][k], mesh.corner[t][(k + 1) % 3]), Vec<3>::Zero())
          .first->second += n;
    }
  }
  for (const auto& c : mesh.corner) {
    normals.corner.push_back({of_point[c[0]], of_point[c[1]], of_point[c[2]]});
    normals.edge.push_back(
        {of_edge.at(sorted(c[0], c[1])), of_edge.at(sorted(c[1], c[2])), of_edge.at(sorted(c[2], c[0]))});
  }
  return normals;
}

/// Whether all corners of the triangle lie on one face of the box.
bool on_face(const std::array<Vec<3>, 3>& x, const Box<3>& box) {
  const Vec<3> lower = box.origin, upper = box.origin + box.size;
  const double rounding = 1e-12 * box.size.maxCoeff();  // of origin + size
  for (int axis = 0; axis < 3; ++axis)
    for (const double face : {lower[axis], upper[axis]})
      if (std::all_of(x.begin(), x.end(),
                      [&](const Vec<3>& corner) { return std::abs(corner[axis] - face) <= rounding; }))
        return true;
  return false;
}

/// The box around the points; those that miss a face of it by rounding are put on it.
Box<3> met_box(TriangleMesh& mesh) {
  Vec<3> lower = mesh.points.front(), upper = lower;
  for (const Vec<3>& X : mesh.points) {
    lower = lower.cwiseMin(X);
    upper = upper.cwiseMax(X);
  }
  for (Vec<3>& X : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      for (const double face : {lower[axis], upper[axis]})
        if (std::abs(X[axis] - face) <= 1e-9 * (upper[axis] - lower[axis])) X[axis] = face;
  return {lower, upper - lower};
}

}  // namespace

/// Triangles with their pseudonormals.
struct ClosedSurface::Tree {
  std::vector<std::array<Vec<3>, 3>> triangles;
  std::vector<Vec<3>> face;
  std::vector<std::array<Vec<3>, 3>> edge, corner;
  std::optional<BoxTree> boxes;

  /// Signed distance to the nearest of them, by its pseudonormal, and the direction away from it.
  BesideSurface<3> beside(const Vec<3>& X) const {
    using Feature = NearestOfTriangle::Feature;
    double square = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    NearestOfTriangle found;
    boxes->nearest(X, square, [&](std::size_t t) {
      const NearestOfTriangle here = nearest_of_triangle(triangles[t], X);
      const double r = (X - here.at).squaredNorm();
      if (r >= square) return;
      square = r;
      nearest = t;
      found = here;
    });
    const Vec<3>& normal = found.feature == Feature::face     ? face[nearest]
                           : found.feature == Feature::corner ? corner[nearest][found.number]
                                                              : edge[nearest][found.number];
    const Vec<3> apart = X - found.at;
    const double distance = apart.dot(normal) < 0 ? -std::sqrt(square) : std::sqrt(square);
    // from a face the direction is exact; beside it that of what may be rounding
    const bool slanted = found.feature != Feature::face && square > 0;
    return {distance, slanted ? Vec<3>(apart / distance) : normal.normalized()};
  }
};

TriangleMesh mesh_of_corners(const std::vector<double>& coordinates) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::size_t> known;
  for (std::size_t k = 0; k + 8 < coordinates.size(); k += 9) {
    std::array<std::size_t, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) {
      const double* x = coordinates.data() + k + 3 * c;
      const auto [at, added] = known.try_emplace({x[0] + 0.0, x[1] + 0.0, x[2] + 0.0}, mesh.points.size());
      if (added) mesh.points.emplace_back(x[0], x[1], x[2]);
      corner[c] = at->second;
    }
    mesh.corner.push_back(corner);
  }
  return mesh;
}

ClosedSurface::ClosedSurface(TriangleMesh mesh)
    : all_(std::make_unique<Tree>()), inner_(std::make_unique<Tree>()) {
  box_ = met_box(mesh);
  const Normals normals = normals_of(mesh);
  for (std::size_t t = 0; t < mesh.corner.size(); ++t) {
    const auto x = corners_of(mesh, t);
    for (Tree* tree : {all_.get(), inner_.get()}) {
      if (tree == inner_.get() && on_face(x, box_)) continue;
      tree->triangles.push_back(x);
      tree->face.push_back(normals.face[t]);
      tree->edge.push_back(normals.edge[t]);
      tree->corner.push_back(normals.corner[t]);
    }
  }
  all_->boxes.emplace(all_->triangles);
  if (!fills_its_box()) inner_->boxes.emplace(inner_->triangles);
}

ClosedSurface::~ClosedSurface() = default;

bool ClosedSurface::fills_its_box() const {
  return inner_->triangles.empty();
}

BesideSurface<3> ClosedSurface::beside(const Vec<3>& X) const {
  return all_->beside(X);
}

double ClosedSurface::distance(const Vec<3>& X) const {
  // on a face of the box, and beyond it, the side is that of the material next to it
  const Vec<3> margin = 1e-12 * box_.size;
  const Vec<3> at = X.cwiseMax(box_.origin + margin).cwiseMin(box_.origin + box_.size - margin);
  const double size =
      fills_its_box() ? std::numeric_limits<double>::infinity() : std::abs(inner_->beside(X).distance);
  return all_->beside(at).distance < 0 ? -size : size;
}

}  // namespace plumb
