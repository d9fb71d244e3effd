#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <voro++/voro++.hh>

#include "plumbline/core/error.hpp"
#include "plumbline/geometry/cloud.hpp"

namespace plumb {
namespace {

std::vector<double> volumes_on_a_line(const std::vector<Vec<1>>& X, const Box<1>& box) {
  std::vector<std::size_t> order(X.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return X[a][0] < X[b][0]; });
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

}  // namespace

/// In 2D the points lie in the middle of a slab of unit thickness, where the cells are prisms: volume = area.
/// Lengths are scaled to a unit box first, because voro++ compares with absolute tolerances.
template <int d>
std::vector<double> voronoi_volumes(const std::vector<Vec<d>>& X, const Box<d>& box) {
  if constexpr (d == 1) {
    return volumes_on_a_line(X, box);
  } else {
    const double scale =
        std::pow(box.size.prod() / static_cast<double>(X.size()), 1.0 / d);  // mean spacing -> 1
    Vec<3> size = Vec<3>::Ones();
    size.template head<d>() = box.size / scale;
    const double per_block = 5;  // particles per block that voro++'s author found fastest
    std::array<int, 3> blocks;
    const double edge = std::pow(per_block, 1.0 / d);
    for (int k = 0; k < 3; ++k) blocks[k] = k < d ? std::max(1, static_cast<int>(size[k] / edge)) : 1;
    voro::container container(0, size[0], 0, size[1], 0, size[2], blocks[0], blocks[1], blocks[2], false,
                              false, false, 8);
    for (std::size_t i = 0; i < X.size(); ++i) {
      Vec<3> p = 0.5 * size;
      // voro++ takes no points on an upper face: a shift of 1e-13 changes a volume as little
      p.template head<d>() = ((X[i] - box.origin) / scale).cwiseMin((1 - 1e-13) * size.template head<d>());
      container.put(static_cast<int>(i), p[0], p[1], p[2]);
    }
    std::vector<double> volumes(X.size(), 0.0);
    voro::c_loop_all loop(container);
    voro::voronoicell cell;
    if (loop.start()) do {
        if (container.compute_cell(cell, loop)) volumes[loop.pid()] = cell.volume() * std::pow(scale, d);
      } while (loop.inc());
    for (std::size_t i = 0; i < X.size(); ++i)
      if (!(volumes[i] > 0))
        throw InputError(fmt::format("particle {} has no Voronoi cell", i),
                         "it lies outside of the body's box", "move it inside or enlarge the box");
    return volumes;
  }
}

template std::vector<double> voronoi_volumes<1>(const std::vector<Vec<1>>&, const Box<1>&);
template std::vector<double> voronoi_volumes<2>(const std::vector<Vec<2>>&, const Box<2>&);
template std::vector<double> voronoi_volumes<3>(const std::vector<Vec<3>>&, const Box<3>&);

}  // namespace plumb
