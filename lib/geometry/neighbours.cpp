#include "lib/geometry/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

template <int d>
struct Points {
  const std::vector<Vec<d>>& X;
  std::size_t kdtree_get_point_count() const { return X.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return X[i][static_cast<Index>(k)]; }
  template <class BoundingBox>
  bool kdtree_get_bbox(BoundingBox&) const {
    return false;
  }
};

}  // namespace

template <int d>
struct NeighbourSearch<d>::Tree {
  using Kd = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points<d>>, Points<d>,
                                                 d, std::size_t>;
  Points<d> points;
  Kd index;
  explicit Tree(const std::vector<Vec<d>>& X)
      : points{X}, index(d, points, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}
};

template <int d>
NeighbourSearch<d>::NeighbourSearch(const std::vector<Vec<d>>& X) : tree_(std::make_unique<Tree>(X)) {}
template <int d>
NeighbourSearch<d>::~NeighbourSearch() = default;
template <int d>
NeighbourSearch<d>::NeighbourSearch(NeighbourSearch&&) noexcept = default;
template <int d>
NeighbourSearch<d>& NeighbourSearch<d>::operator=(NeighbourSearch&&) noexcept = default;

template <int d>
void NeighbourSearch<d>::within(const Vec<d>& point, double R, std::vector<Index>& found) const {
  std::vector<std::pair<std::size_t, double>> matches;
  const double radius = R * (1 - 1e-12);
  tree_->index.radiusSearch(point.data(), radius * radius, matches, nanoflann::SearchParams(0, 0, false));
  found.clear();
  for (const auto& [i, r2] : matches) found.push_back(static_cast<Index>(i));
  std::sort(found.begin(), found.end());
}

namespace {

/// Concatenates rows that were found in parallel.
Neighbours compressed(const std::vector<std::vector<std::int32_t>>& rows) {
  Neighbours all;
  all.begin.push_back(0);
  for (const auto& row : rows) all.begin.push_back(all.begin.back() + static_cast<Index>(row.size()));
  all.list.resize(all.begin.back());
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy(rows[i].begin(), rows[i].end(), all.list.begin() + all.begin[i]);
  return all;
}

/// A step on the lattice, and what it adds to the particle number.
template <int d>
struct LatticeStep {
  std::array<Index, d> move;
  Index number;
};

/// All steps shorter than R, in ascending order of the particle number.
template <int d>
std::vector<LatticeStep<d>> steps_within(const Cloud<d>& cloud, double R) {
  std::array<double, d> length;
  std::array<Index, d> reach;
  for (int k = 0; k < d; ++k) {
    // from the first to the second particle along the axis; an axis of one particle has no steps
    length[k] = cloud.count[k] > 1 ? cloud.X[cloud.stride[k]][k] - cloud.X[0][k] : 2 * R;
    reach[k] = std::min(static_cast<Index>(R / length[k]), cloud.count[k] - 1);
  }
  std::vector<LatticeStep<d>> steps = {{{}, 0}};
  for (int k = 0; k < d; ++k) {
    std::vector<LatticeStep<d>> longer;
    for (const auto& step : steps)
      for (Index m = -reach[k]; m <= reach[k]; ++m) {
        LatticeStep<d> next = step;
        next.move[k] = m;
        next.number += m * cloud.stride[k];
        longer.push_back(next);
      }
    steps = std::move(longer);
  }
  std::erase_if(steps, [&](const LatticeStep<d>& step) {
    double square = 0;
    for (int k = 0; k < d; ++k) square += std::pow(static_cast<double>(step.move[k]) * length[k], 2);
    return std::sqrt(square) >= R * (1 - 1e-12);
  });
  std::sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return steps;
}

/// Calls f(neighbour) for every particle that a step from particle i leads to.
template <int d, class F>
void for_steps(const Cloud<d>& cloud, const std::vector<LatticeStep<d>>& steps, Index i, F&& f) {
  std::array<Index, d> place;
  for (int k = 0; k < d; ++k) place[k] = i / cloud.stride[k] % cloud.count[k];
  for (const auto& step : steps) {
    bool inside = true;
    for (int k = 0; k < d; ++k) {
      const Index at = place[k] + step.move[k];
      inside = inside && at >= 0 && at < cloud.count[k];
    }
    if (inside) f(static_cast<std::int32_t>(i + step.number));
  }
}

/// By counting on a lattice: no search.
template <int d>
Neighbours lattice_neighbours(const Cloud<d>& cloud, double R) {
  const auto steps = steps_within(cloud, R);
  Neighbours all;
  all.begin.assign(cloud.size() + 1, 0);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < cloud.size(); ++i)
    for_steps(cloud, steps, i, [&](std::int32_t) { ++all.begin[i + 1]; });
  for (Index i = 0; i < cloud.size(); ++i) all.begin[i + 1] += all.begin[i];
  all.list.resize(all.begin.back());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < cloud.size(); ++i) {
    std::int32_t* next = all.list.data() + all.begin[i];
    for_steps(cloud, steps, i, [&](std::int32_t j) { *next++ = j; });
  }
  return all;
}

template <int d>
void refuse_coincident(const Cloud<d>& cloud, const Neighbours& all) {
  const double near = 1e-8 * cloud.spacing;  // the bond quotient loses half of its digits there
  for (Index i = 0; i < cloud.size(); ++i)
    for (const auto j : all.of(i))
      if (j > i && (cloud.X[j] - cloud.X[i]).norm() < near)
        throw InputError(fmt::format("particles {} and {} coincide", i, j),
                         fmt::format("distance {:.3g} m", (cloud.X[j] - cloud.X[i]).norm()),
                         "remove one of them or reduce the jitter");
}

}  // namespace

template <int d>
Neighbours find_neighbours(const Cloud<d>& cloud, double R) {
  if (cloud.line > 0) return lattice_neighbours(cloud, R);
  const NeighbourSearch<d> search(cloud.X);
  std::vector<std::vector<std::int32_t>> rows(cloud.size());
#pragma omp parallel
  {
    std::vector<Index> found;
#pragma omp for schedule(static)
    for (Index i = 0; i < cloud.size(); ++i) {
      search.within(cloud.X[i], R, found);
      rows[i].assign(found.begin(), found.end());
    }
  }
  Neighbours all = compressed(rows);
  refuse_coincident(cloud, all);
  return all;
}

template class NeighbourSearch<1>;
template class NeighbourSearch<2>;
template class NeighbourSearch<3>;
template Neighbours find_neighbours<1>(const Cloud<1>&, double);
template Neighbours find_neighbours<2>(const Cloud<2>&, double);
template Neighbours find_neighbours<3>(const Cloud<3>&, double);

}  // namespace plumb
