#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "lib/core/error.hpp"
#include "lib/geometry/cloud.hpp"

namespace plumb {

template <int d>
std::array<Index, d> cells_of(const Box<d>& box, double spacing) {
  std::array<Index, d> cells;
  for (int k = 0; k < d; ++k) {
    const double exact = box.size[k] / spacing;
    cells[k] = std::max<Index>(1, static_cast<Index>(std::llround(exact)));
    // 1e-6: a spacing typed with seven digits is meant to divide the size
    if (std::abs(exact - static_cast<double>(cells[k])) > 1e-6 * exact)
      throw InputError(fmt::format("spacing {:.9g} m does not divide the size {:.9g} m of axis {}", spacing,
                                   box.size[k], "xyz"[k]),
                       "particles would not fill the body",
                       fmt::format("use {:.9g} m", box.size[k] / static_cast<double>(cells[k])));
  }
  return cells;
}

template <int d>
Cloud<d> lattice(const Box<d>& box, const std::array<Index, d>& cells, Layout layout) {
  const bool on_nodes = layout == Layout::node;
  std::array<int, d> order;  // axes from the fastest to the slowest
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return cells[a] > cells[b]; });

  std::array<Index, d> count;
  Vec<d> step;
  Index total = 1;
  for (int k = 0; k < d; ++k) {
    count[k] = cells[k] + (on_nodes ? 1 : 0);
    step[k] = box.size[k] / static_cast<double>(cells[k]);
    total *= count[k];
  }
  Cloud<d> cloud;
  cloud.X.reserve(total);
  cloud.V.reserve(total);
  cloud.spacing = std::pow(step.prod(), 1.0 / d);
  cloud.box = box;
  cloud.line = count[order[0]];
  cloud.count = count;
  Index stride = 1;
  for (const int k : order) {
    cloud.stride[k] = stride;
    stride *= count[k];
  }
  for (Index n = 0; n < total; ++n) {
    Vec<d> X;
    double volume = step.prod();
    Index rest = n;
    for (const int k : order) {
      const Index i = rest % count[k];
      rest /= count[k];
      X[k] = box.origin[k] + (static_cast<double>(i) + (on_nodes ? 0.0 : 0.5)) * step[k];
      if (on_nodes && i == cells[k]) X[k] = box.origin[k] + box.size[k];
      if (on_nodes && (i == 0 || i == cells[k])) volume *= 0.5;
    }
    cloud.X.push_back(X);
    cloud.V.push_back(volume);
  }
  return cloud;
}

template <int d>
Cloud<d> jittered(Cloud<d> cloud, double fraction, std::uint64_t seed, Layout layout) {
  std::mt19937_64 random(seed);
  // 53 random bits to (-1, 1): the standard's distributions differ between libraries, this does not
  const auto next = [&random] { return 2 * ((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53) - 1; };
  const Vec<d> lower = cloud.box.origin, upper = cloud.box.origin + cloud.box.size;
  for (auto& X : cloud.X) {
    const bool on_face =
        layout == Layout::node && ((X - lower).array() == 0 || (X - upper).array() == 0).any();
    for (int k = 0; k < d; ++k) {
      const double shift = fraction * cloud.spacing * next();
      if (!on_face) X[k] = std::clamp(X[k] + shift, lower[k], upper[k]);
    }
  }
  cloud.line = 0;
  cloud.V = voronoi_volumes<d>(cloud.X, cloud.box);
  return cloud;
}

template std::array<Index, 1> cells_of<1>(const Box<1>&, double);
template std::array<Index, 2> cells_of<2>(const Box<2>&, double);
template std::array<Index, 3> cells_of<3>(const Box<3>&, double);
template Cloud<1> lattice<1>(const Box<1>&, const std::array<Index, 1>&, Layout);
template Cloud<2> lattice<2>(const Box<2>&, const std::array<Index, 2>&, Layout);
template Cloud<3> lattice<3>(const Box<3>&, const std::array<Index, 3>&, Layout);
template Cloud<1> jittered<1>(Cloud<1>, double, std::uint64_t, Layout);
template Cloud<2> jittered<2>(Cloud<2>, double, std::uint64_t, Layout);
template Cloud<3> jittered<3>(Cloud<3>, double, std::uint64_t, Layout);

}  // namespace plumb
