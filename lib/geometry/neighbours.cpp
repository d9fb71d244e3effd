#include "plumbline/geometry/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nanoflann.hpp>

#include "plumbline/core/error.hpp"

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

template <int d>
Neighbours find_neighbours(const Cloud<d>& cloud, double R) {
  const NeighbourSearch<d> search(cloud.X);
  const Index n = cloud.size();
  std::vector<std::vector<std::int32_t>> rows(n);
#pragma omp parallel
  {
    std::vector<Index> found;
#pragma omp for schedule(static)
    for (Index i = 0; i < n; ++i) {
      search.within(cloud.X[i], R, found);
      rows[i].assign(found.begin(), found.end());
    }
  }
  Neighbours all;
  all.begin.assign(n + 1, 0);
  for (Index i = 0; i < n; ++i) all.begin[i + 1] = all.begin[i] + static_cast<Index>(rows[i].size());
  all.list.resize(all.begin[n]);
  const double near = 1e-8 * cloud.spacing;  // the bond quotient loses half of its digits there
  for (Index i = 0; i < n; ++i) {
    std::copy(rows[i].begin(), rows[i].end(), all.list.begin() + all.begin[i]);
    for (const auto j : rows[i])
      if (j > i && (cloud.X[j] - cloud.X[i]).norm() < near)
        throw InputError(fmt::format("particles {} and {} coincide", i, j),
                         fmt::format("distance {:.3g} m", (cloud.X[j] - cloud.X[i]).norm()),
                         "remove one of them or reduce the jitter");
  }
  return all;
}

template class NeighbourSearch<1>;
template class NeighbourSearch<2>;
template class NeighbourSearch<3>;
template Neighbours find_neighbours<1>(const Cloud<1>&, double);
template Neighbours find_neighbours<2>(const Cloud<2>&, double);
template Neighbours find_neighbours<3>(const Cloud<3>&, double);

}  // namespace plumb
