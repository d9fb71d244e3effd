#include "lib/schemes/tlsph/compatible/mesh_surface.hpp"

namespace plumb {
namespace {

Vec<2> area_of(const Cloud<2>& cloud, const std::array<Index, 2>& edge) {
  const Vec<2> along = cloud.X[edge[1]] - cloud.X[edge[0]];
  return {along[1], -along[0]};
}

Vec<3> area_of(const Cloud<3>& cloud, const std::array<Index, 3>& t) {
  const Vec<3> a = cloud.X[t[1]] - cloud.X[t[0]], b = cloud.X[t[2]] - cloud.X[t[0]];
  return 0.5 * Vec<3>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

}  // namespace

/// The polyhedron is a sum of signed simplices with one corner at a reference point.
template <int d>
Surface<d> mesh_surface(const Cloud<d>& cloud, const SurfaceMesh<d>& mesh) {
  Surface<d> surface{{}, 0, Vec<d>::Zero()};
  const Vec<d> point = cloud.X[mesh.front()[0]];
  Vec<d> moment = Vec<d>::Zero();
  for (const auto& piece : mesh) {
    const Vec<d> area = area_of(cloud, piece);
    Vec<d> corners = Vec<d>::Zero();
    for (const Index i : piece) {
      corners += cloud.X[i] - point;
      surface.facets.push_back({i, cloud.X[i], area / d});
    }
    const double volume = area.dot(cloud.X[piece[0]] - point) / d;
    surface.volume += volume;
    moment += volume * corners / (d + 1);
  }
  surface.centroid = point + moment / surface.volume;
  return surface;
}

template Surface<2> mesh_surface<2>(const Cloud<2>&, const SurfaceMesh<2>&);
template Surface<3> mesh_surface<3>(const Cloud<3>&, const SurfaceMesh<3>&);

}  // namespace plumb
