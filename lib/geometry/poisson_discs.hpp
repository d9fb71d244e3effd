#pragma once
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Numbers in (0, 1), the same on every machine: the standard's distributions differ between libraries.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}
  double next() { return (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53; }
  /// A point of the box.
  template <int d>
  Vec<d> in(const Box<d>& box) {
    Vec<d> X;
    for (int k = 0; k < d; ++k) X[k] = box.origin[k] + next() * box.size[k];
    return X;
  }

 private:
  std::mt19937_64 random_;
};

/// Points that keep a distance from each other, found through a grid of cells of that size.
template <int d>
class PoissonDiscs {
 public:
  explicit PoissonDiscs(double distance) : distance_(distance) {}

  const std::vector<Vec<d>>& points() const { return points_; }
  void add(const Vec<d>& X) {
    grid_[cell_of(X)].push_back(points_.size());
    points_.push_back(X);
  }
  /// True if no point is nearer than `distance`, which is at most the one of the grid.
  bool is_free(const Vec<d>& X, double distance) const {
    const Cell middle = cell_of(X);
    int count = 1;
    for (int k = 0; k < d; ++k) count *= 3;
    for (int n = 0; n < count; ++n) {
      Cell cell = middle;
      for (int k = 0, rest = n; k < d; ++k, rest /= 3) cell[k] += rest % 3 - 1;
      const auto found = grid_.find(cell);
      if (found == grid_.end()) continue;
      for (const std::size_t i : found->second)
        if ((points_[i] - X).squaredNorm() < distance * distance) return false;
    }
    return true;
  }

 private:
  using Cell = std::array<long, d>;
  Cell cell_of(const Vec<d>& X) const {
    Cell cell;
    for (int k = 0; k < d; ++k) cell[k] = std::lround(std::floor(X[k] / distance_));
    return cell;
  }

  double distance_;
  std::vector<Vec<d>> points_;
  std::map<Cell, std::vector<std::size_t>> grid_;
};

}  // namespace plumb
