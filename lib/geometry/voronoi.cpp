#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <voro++/voro++.hh>

#include "plumbline/core/error.hpp"
#include "plumbline/geometry/facets.hpp"

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

/// Calls use(i, cell, unit) for every particle: its Voronoi cell, clipped by the box, in units of `unit` [m]
/// and relative to the particle. In 2D the points lie in the middle of a slab of unit thickness, where the
/// cells are prisms. Lengths are scaled to a mean spacing of 1, because voro++ compares with absolute
/// tolerances.
template <int d, class Use>
void for_each_voronoi_cell(const std::vector<Vec<d>>& X, const Box<d>& box, Use&& use) {
  const double unit = std::pow(box.size.prod() / static_cast<double>(X.size()), 1.0 / d);
  Vec<3> size = Vec<3>::Ones();
  size.template head<d>() = box.size / unit;
  const double per_block = 5;  // particles per block that voro++'s author found fastest
  std::array<int, 3> blocks;
  const double edge = std::pow(per_block, 1.0 / d);
  for (int k = 0; k < 3; ++k) blocks[k] = k < d ? std::max(1, static_cast<int>(size[k] / edge)) : 1;
  voro::container container(0, size[0], 0, size[1], 0, size[2], blocks[0], blocks[1], blocks[2], false, false,
                            false, 8);
  for (std::size_t i = 0; i < X.size(); ++i) {
    Vec<3> p = 0.5 * size;
    // voro++ takes no points on an upper face: a shift of 1e-13 changes a volume as little
    p.template head<d>() = ((X[i] - box.origin) / unit).cwiseMin((1 - 1e-13) * size.template head<d>());
    container.put(static_cast<int>(i), p[0], p[1], p[2]);
  }
  std::vector<bool> found(X.size(), false);
  voro::c_loop_all loop(container);
  voro::voronoicell_neighbor cell;
  if (loop.start()) do {
      if (!container.compute_cell(cell, loop)) continue;
      found[loop.pid()] = true;
      use(static_cast<Index>(loop.pid()), cell, unit);
    } while (loop.inc());
  const auto missing = std::find(found.begin(), found.end(), false);
  if (missing != found.end())
    throw InputError(fmt::format("particle {} has no Voronoi cell", missing - found.begin()),
                     "it lies outside of the body's box, or where another one is",
                     "move it inside or enlarge the box");
}

/// Area and centroid (relative to the particle) of one face of a cell, from a fan of triangles.
std::pair<double, Vec<3>> area_and_centroid(const std::vector<double>& corners, const int* face, int n) {
  const auto corner = [&](int k) {
    return Vec<3>(corners[3 * face[k]], corners[3 * face[k] + 1], corners[3 * face[k] + 2]);
  };
  double area = 0;
  Vec<3> moment = Vec<3>::Zero();
  for (int k = 1; k + 1 < n; ++k) {
    const Vec<3> a = corner(k) - corner(0), b = corner(k + 1) - corner(0);
    const Vec<3> cross(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    const double part = 0.5 * cross.norm();
    area += part;
    moment += part * (corner(0) + corner(k) + corner(k + 1)) / 3;
  }
  return {area, area > 0 ? Vec<3>(moment / area) : Vec<3>::Zero()};
}

/// Appends the facets of one cell on the walls of the box: voro++ numbers them -1 (x-), -2 (x+), -3 (y-), ..
template <int d>
void append_facets(const std::vector<Vec<d>>& X, const Box<d>& box, Index i, voro::voronoicell_neighbor& cell,
                   double unit, std::vector<Facet<d>>& facets) {
  std::vector<int> beyond, faces;
  std::vector<double> corners;
  cell.neighbors(beyond);
  if (std::all_of(beyond.begin(), beyond.end(), [](int n) { return n >= 0 || n < -2 * d; })) return;
  cell.face_vertices(faces);
  cell.vertices(0, 0, 0, corners);
  std::size_t at = 0;
  for (const int n : beyond) {
    const int corners_of_face = faces[at];
    const int* face = &faces[at + 1];
    at += static_cast<std::size_t>(corners_of_face) + 1;
    if (n >= 0 || n < -2 * d) continue;
    const auto [area, centroid] = area_and_centroid(corners, face, corners_of_face);
    const int axis = (-n - 1) / 2, side = (-n - 1) % 2 ? 1 : -1;
    Facet<d> facet{i, X[i] + unit * centroid.template head<d>(), Vec<d>::Zero()};
    facet.area[axis] = side * area * std::pow(unit, d - 1);
    facet.centroid[axis] = box.origin[axis] + (side > 0 ? box.size[axis] : 0.0);
    if (area > 0) facets.push_back(facet);
  }
}

}  // namespace

template <int d>
std::vector<double> voronoi_volumes(const std::vector<Vec<d>>& X, const Box<d>& box) {
  if constexpr (d == 1) {
    return volumes_on_a_line(X, box);
  } else {
    std::vector<double> volumes(X.size(), 0.0);
    for_each_voronoi_cell<d>(X, box, [&](Index i, voro::voronoicell_neighbor& cell, double unit) {
      volumes[i] = cell.volume() * std::pow(unit, d);
    });
    return volumes;
  }
}

template <int d>
std::vector<Facet<d>> voronoi_facets(const std::vector<Vec<d>>& X, const Box<d>& box) {
  std::vector<Facet<d>> facets;
  if constexpr (d == 1) {
    const auto order = sorted_on_line(X);
    facets = {{static_cast<Index>(order.front()), box.origin, Vec<1>(-1.0)},
              {static_cast<Index>(order.back()), box.origin + box.size, Vec<1>(1.0)}};
  } else {
    for_each_voronoi_cell<d>(X, box, [&](Index i, voro::voronoicell_neighbor& cell, double unit) {
      append_facets<d>(X, box, i, cell, unit, facets);
    });
    std::stable_sort(facets.begin(), facets.end(),
                     [](const Facet<d>& a, const Facet<d>& b) { return a.owner < b.owner; });
  }
  return facets;
}

template std::vector<double> voronoi_volumes<1>(const std::vector<Vec<1>>&, const Box<1>&);
template std::vector<double> voronoi_volumes<2>(const std::vector<Vec<2>>&, const Box<2>&);
template std::vector<double> voronoi_volumes<3>(const std::vector<Vec<3>>&, const Box<3>&);
template std::vector<Facet<1>> voronoi_facets<1>(const std::vector<Vec<1>>&, const Box<1>&);
template std::vector<Facet<2>> voronoi_facets<2>(const std::vector<Vec<2>>&, const Box<2>&);
template std::vector<Facet<3>> voronoi_facets<3>(const std::vector<Vec<3>>&, const Box<3>&);

}  // namespace plumb
