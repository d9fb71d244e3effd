#pragma once
#include <memory>
#include <span>
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Neighbour search in any cloud (nanoflann k-d tree). Points are neighbours if r < R (1 - 1e-12): at exactly
/// R the kernel is zero, and rounding must not decide. The cloud must outlive the search.
template <int d>
class NeighbourSearch {
 public:
  explicit NeighbourSearch(const std::vector<Vec<d>>& X);
  ~NeighbourSearch();
  NeighbourSearch(NeighbourSearch&&) noexcept;
  NeighbourSearch& operator=(NeighbourSearch&&) noexcept;

  /// Numbers of all points within R of the point, ascending.
  void within(const Vec<d>& point, double R, std::vector<Index>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// All neighbours of all particles, themselves included, ascending (compressed rows).
struct Neighbours {
  std::vector<Index> begin;        ///< size N + 1
  std::vector<std::int32_t> list;  ///< particle numbers

  std::span<const std::int32_t> of(Index i) const {
    return {list.data() + begin[i], static_cast<std::size_t>(begin[i + 1] - begin[i])};
  }
};

/// Throws InputError with both particles if two of them coincide (distance below 1e-8 spacings).
template <int d>
Neighbours find_neighbours(const Cloud<d>& cloud, double R);

}  // namespace plumb
