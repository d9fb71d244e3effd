#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <voro++/voro++.hh>

#include "lib/core/error.hpp"
#include "lib/geometry/facets.hpp"
#include "lib/geometry/voronoi_cells.hpp"

namespace plumb {
namespace {

std::vector<std::size_t> sorted_on_line(const std::vector<Vec<1>>& X) {
  std::vector<std::size_t> order(X.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return X[a][0] < X[b][0]; });
  return order;
}

std::vector<double> volumes_on_a_line(const std::vector<Vec<1>>& X, const Box<1>& box) {
  const auto order = sorted_on_line(X);
  std::vector<double> volumes(X.size());
  double left = box.origin[0];
  for (std::size_t n = 0; n < order.size(); ++n) {
    const double right =
        n + 1 < order.size() ? 0.5 * (X[order[n]][0] + X[order[n + 1]][0]) : box.origin[0] + box.size[0];
    volumes[order[n]] = right - left;
    left = right;
  }
  return volumes;
}

/// The slab, box or plane through which voro++ sees the points: lengths are scaled to a mean spacing of 1,
/// because voro++ compares with absolute tolerances, and 2D points lie in the middle of a slab of unit
/// thickness, where the cells are prisms.
template <int d>
struct Scaled {
  Vec<d> origin;
  double unit;  ///< [m]
  Vec<3> size = Vec<3>::Ones();

  Scaled(const Box<d>& box, std::size_t particles)
      : origin(box.origin), unit(std::pow(box.size.prod() / static_cast<double>(particles), 1.0 / d)) {
    size.template head<d>() = box.size / unit;
  }
  Vec<3> inside(const Vec<d>& X) const {
    Vec<3> p = 0.5 * size;
    // voro++ takes no points on an upper face: a shift of 1e-13 changes a volume as little
    p.template head<d>() = ((X - origin) / unit).cwiseMin((1 - 1e-13) * size.template head<d>());
    return p;
  }
};

/// Faces of a cell of voro++ at the particle X, in metres. In 2D the two faces of the slab are left out, and
/// of the others only the edge on the lower one is kept.
template <int d>
void append_faces(voro::voronoicell_neighbor& cell, const Vec<d>& X, double unit, VoronoiCell<d>& out) {
  std::vector<int> beyond, faces;
  std::vector<double> corners;
  cell.neighbors(beyond);
  cell.face_vertices(faces);
  cell.vertices(0, 0, 0, corners);
  std::size_t at = 0;
  for (const int n : beyond) {
    const int count = faces[at++];
    const int* face = &faces[at];
    at += static_cast<std::size_t>(count);
    if (n < -2 * d) continue;
    std::vector<Vec<d>> points;
    for (int k = 0; k < count; ++k) {
      const double* corner = &corners[3 * static_cast<std::size_t>(face[k])];
      if (d == 2 && corner[2] > 0) continue;
      Vec<d> point;
      for (int a = 0; a < d; ++a) point[a] = X[a] + unit * corner[a];
      points.push_back(point);
    }
    if (points.size() < static_cast<std::size_t>(d)) continue;
    out.faces.push_back(std::move(points));
    out.beyond.push_back(n);
  }
}

/// Area and centroid of one face.
template <int d>
std::pair<double, Vec<d>> area_and_centroid(const std::vector<Vec<d>>& face) {
  if constexpr (d == 2) {
    return {(face[1] - face[0]).norm(), 0.5 * (face[0] + face[1])};
  } else {
    double area = 0;
    Vec<d> moment = Vec<d>::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {  // a fan of triangles
      const Vec<d> a = face[k] - face[0], b = face[k + 1] - face[0];
      const double part =
          0.5 *
          Vec<d>(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]).norm();
      area += part;
      moment += part * (face[0] + face[k] + face[k + 1]) / 3;
    }
    return {area, area > 0 ? Vec<d>(moment / area) : face[0]};
  }
}

/// Appends the facets of one cell on the faces of the box.
template <int d>
void append_facets(const Vec<d>& X, const Box<d>& box, const VoronoiCell<d>& cell,
                   std::vector<Facet<d>>& facets) {
  for (std::size_t n = 0; n < cell.faces.size(); ++n) {
    if (cell.beyond[n] >= 0) continue;
    const auto [area, centroid] = area_and_centroid<d>(cell.faces[n]);
    if (!(area > 0)) continue;
    const auto k = static_cast<int>(-cell.beyond[n] - 1), axis = k / 2, side = k % 2 ? 1 : -1;
    Facet<d> facet{cell.owner, centroid, Vec<d>::Zero()};
    facet.area[axis] = side * area;
    facet.centroid[axis] = box.origin[axis] + (side > 0 ? box.size[axis] : 0.0);
    facet.depth = std::abs(facet.centroid[axis] - X[axis]);
    facets.push_back(facet);
  }
}

}  // namespace

template <int d>
void for_each_voronoi_cell(const std::vector<Vec<d>>& X, const Box<d>& box, bool with_faces,
                           const std::function<void(const VoronoiCell<d>&)>& use) {
  const Scaled<d> scaled(box, X.size());
  const double per_block = 5;  // particles per block that voro++'s author found fastest
  std::array<int, 3> blocks;
  const double edge = std::pow(per_block, 1.0 / d);
  for (int k = 0; k < 3; ++k) blocks[k] = k < d ? std::max(1, static_cast<int>(scaled.size[k] / edge)) : 1;
  voro::container container(0, scaled.size[0], 0, scaled.size[1], 0, scaled.size[2], blocks[0], blocks[1],
                            blocks[2], false, false, false, 8);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vec<3> p = scaled.inside(X[i]);
    container.put(static_cast<int>(i), p[0], p[1], p[2]);
  }
  std::vector<bool> found(X.size(), false);
  voro::c_loop_all loop(container);
  voro::voronoicell_neighbor cell;
  if (loop.start()) do {
      if (!container.compute_cell(cell, loop)) continue;
      const auto i = static_cast<std::size_t>(loop.pid());
      found[i] = true;
      VoronoiCell<d> out{static_cast<Index>(i), cell.volume() * std::pow(scaled.unit, d), {}, {}};
      if (with_faces) append_faces<d>(cell, X[i], scaled.unit, out);
      use(out);
    } while (loop.inc());
  const auto missing = std::find(found.begin(), found.end(), false);
  if (missing != found.end())
    throw InputError(fmt::format("particle {} has no Voronoi cell", missing - found.begin()),
                     "it lies outside of the body's box, or where another one is",
                     "move it inside or enlarge the box");
}

template <int d>
std::vector<double> voronoi_volumes(const std::vector<Vec<d>>& X, const Box<d>& box) {
  if constexpr (d == 1) {
    return volumes_on_a_line(X, box);
  } else {
    std::vector<double> volumes(X.size(), 0.0);
    for_each_voronoi_cell<d>(X, box, false,
                             [&](const VoronoiCell<d>& cell) { volumes[cell.owner] = cell.volume; });
    return volumes;
  }
}

template <int d>
std::vector<Facet<d>> voronoi_facets(const std::vector<Vec<d>>& X, const Box<d>& box) {
  std::vector<Facet<d>> facets;
  if constexpr (d == 1) {
    const auto order = sorted_on_line(X);
    facets = {
        {static_cast<Index>(order.front()), box.origin, Vec<1>(-1.0), X[order.front()][0] - box.origin[0]},
        {static_cast<Index>(order.back()), box.origin + box.size, Vec<1>(1.0),
         box.origin[0] + box.size[0] - X[order.back()][0]}};
  } else {
    for_each_voronoi_cell<d>(X, box, true, [&](const VoronoiCell<d>& cell) {
      append_facets<d>(X[cell.owner], box, cell, facets);
    });
    std::stable_sort(facets.begin(), facets.end(),
                     [](const Facet<d>& a, const Facet<d>& b) { return a.owner < b.owner; });
  }
  return facets;
}

template void for_each_voronoi_cell<2>(const std::vector<Vec<2>>&, const Box<2>&, bool,
                                       const std::function<void(const VoronoiCell<2>&)>&);
template void for_each_voronoi_cell<3>(const std::vector<Vec<3>>&, const Box<3>&, bool,
                                       const std::function<void(const VoronoiCell<3>&)>&);
template std::vector<double> voronoi_volumes<1>(const std::vector<Vec<1>>&, const Box<1>&);
template std::vector<double> voronoi_volumes<2>(const std::vector<Vec<2>>&, const Box<2>&);
template std::vector<double> voronoi_volumes<3>(const std::vector<Vec<3>>&, const Box<3>&);
template std::vector<Facet<1>> voronoi_facets<1>(const std::vector<Vec<1>>&, const Box<1>&);
template std::vector<Facet<2>> voronoi_facets<2>(const std::vector<Vec<2>>&, const Box<2>&);
template std::vector<Facet<3>> voronoi_facets<3>(const std::vector<Vec<3>>&, const Box<3>&);

}  // namespace plumb
