#include "lib/geometry/cloud_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/geometry/neighbours.hpp"

namespace plumb {
namespace {

/// Numbers of the particles within R, nearest first; R is doubled until there are `least` of them.
template <int d>
std::vector<std::pair<double, Index>> nearest(const NeighbourSearch<d>& search, const std::vector<Vec<d>>& X,
                                              const Vec<d>& at, double R, std::size_t least) {
  std::vector<Index> found;
  for (; found.size() < least; R *= 2) search.within(at, R, found);
  std::vector<std::pair<double, Index>> sorted;
  for (const Index j : found) sorted.emplace_back((X[static_cast<std::size_t>(j)] - at).norm(), j);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace

template <int d>
std::optional<Gap<d>> widest_gap(const std::vector<Vec<d>>& X, const Shape<d>& shape, double spacing) {
  constexpr std::size_t neighbours = 2 * d;
  if (X.size() <= neighbours) return std::nullopt;
  constexpr double most = 2, seen = 1.5;  // local and mean spacings from a gap's middle to its rim
  // particles in tight groups far apart: no more probes than there are particles, but for a factor
  const double of_box = std::pow(shape.box.size.prod() / static_cast<double>(X.size()), 1.0 / d);
  spacing = std::max(spacing, 0.5 * of_box);
  const NeighbourSearch<d> search(X);
  std::array<Index, d> count;
  Index all = 1;
  for (int k = 0; k < d; ++k) all *= count[k] = static_cast<Index>(std::ceil(shape.box.size[k] / spacing));
  std::optional<Gap<d>> widest;
  std::vector<Index> near;
  for (Index n = 0; n < all; ++n) {
    Vec<d> at = shape.box.origin;
    for (Index k = 0, rest = n; k < d; rest /= count[k], ++k)
      at[k] +=
          (static_cast<double>(rest % count[k]) + 0.5) * shape.box.size[k] / static_cast<double>(count[k]);
    search.within(at, seen * spacing, near);
    if (!near.empty() || !(shape.distance(at) < 0)) continue;
    const auto [radius, rim] = nearest<d>(search, X, at, 2 * seen * spacing, 1).front();
    const double local =
        nearest<d>(search, X, X[static_cast<std::size_t>(rim)], 2 * spacing, neighbours + 1)[neighbours]
            .first;
    if (radius > most * local && (!widest || radius / local > widest->radius / widest->spacing))
      widest = {at, radius, local};
  }
  return widest;
}

template <int d>
void find_lattice(Cloud<d>& cloud) {
  std::array<Index, d> count;
  Index all = 1;
  for (int k = 0; k < d; ++k) all *= count[k] = std::lround(cloud.box.size[k] / cloud.spacing) + 1;
  if (all != cloud.size()) return;
  std::array<int, d> axes;  // the first runs fastest
  std::iota(axes.begin(), axes.end(), 0);
  do {
    std::array<Index, d> stride;
    Index step = 1;
    for (const int k : axes) {
      stride[k] = step;
      step *= count[k];
    }
    bool fits = true;
    for (Index i = 0; i < all && fits; ++i)
      for (int k = 0; k < d; ++k) {
        const auto place = static_cast<double>(i / stride[k] % count[k]);
        const double node =
            cloud.box.origin[k] + place * cloud.box.size[k] / static_cast<double>(count[k] - 1);
        fits = fits && std::abs(cloud.X[static_cast<std::size_t>(i)][k] - node) < 1e-9 * cloud.spacing;
      }
    if (!fits) continue;
    cloud.count = count;
    cloud.stride = stride;
    return;
  } while (std::next_permutation(axes.begin(), axes.end()));
}

template std::optional<Gap<2>> widest_gap<2>(const std::vector<Vec<2>>&, const Shape<2>&, double);
template std::optional<Gap<3>> widest_gap<3>(const std::vector<Vec<3>>&, const Shape<3>&, double);
template void find_lattice<2>(Cloud<2>&);
template void find_lattice<3>(Cloud<3>&);

}  // namespace plumb
