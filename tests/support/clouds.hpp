#pragma once
#include <random>
#include <string>
#include <vector>

#include "lib/geometry/cloud.hpp"
#include "lib/kernel/neighbourhood.hpp"

namespace plumb::test {

/// A cloud with a name for messages.
template <int d>
struct NamedCloud {
  std::string name;
  Cloud<d> cloud;
};

/// A small box of unequal sides with the lower corner away from the origin; spacing `spacing` [m].
template <int d>
Cloud<d> small_lattice(Layout layout, double spacing = 0.2) {
  constexpr std::array<Index, 3> count = {8, 6, 5};
  Box<d> box;
  std::array<Index, d> cells;
  for (int k = 0; k < d; ++k) {
    cells[k] = count[k];
    box.origin[k] = (-0.7 + 0.9 * k) * spacing / 0.2;
    box.size[k] = static_cast<double>(count[k]) * spacing;
  }
  return lattice<d>(box, cells, layout);
}

/// Lattices of both layouts and clouds jittered by 0.2 and 0.3 spacings: corners, edges and faces included.
template <int d>
std::vector<NamedCloud<d>> all_clouds(double spacing = 0.2) {
  const Cloud<d> cell = small_lattice<d>(Layout::cell, spacing);
  const Cloud<d> node = small_lattice<d>(Layout::node, spacing);
  return {{"cell lattice", cell},
          {"node lattice", node},
          {"cell layout, jitter 0.2", jittered<d>(cell, 0.2, 1, Layout::cell)},
          {"node layout, jitter 0.2", jittered<d>(node, 0.2, 2, Layout::node)},
          {"cell layout, jitter 0.3", jittered<d>(cell, 0.3, 3, Layout::cell)}};
}

/// The neighbours of a point by brute force (independent of the neighbour search), the particle itself
/// included.
template <int d>
std::vector<Neighbour<d>> neighbours_of(const Cloud<d>& cloud, const Vec<d>& point, double R,
                                        std::vector<Index>* numbers = nullptr) {
  std::vector<Neighbour<d>> found;
  for (Index j = 0; j < cloud.size(); ++j) {
    const Vec<d> separation = cloud.X[j] - point;
    if (separation.norm() >= R * (1 - 1e-12)) continue;  // the kernel is zero at R: rounding must not decide
    found.push_back({separation, cloud.V[j]});
    if (numbers != nullptr) numbers->push_back(j);
  }
  return found;
}

/// Reproducible numbers in (-1, 1).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}
  double next() { return 2 * ((static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53) - 1; }
  template <int d>
  Vec<d> vector() {
    Vec<d> v;
    for (int k = 0; k < d; ++k) v[k] = next();
    return v;
  }
  template <int d>
  Mat<d> matrix() {
    Mat<d> m;
    for (int k = 0; k < d; ++k) m.col(k) = vector<d>();
    return m;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace plumb::test
