#include "lib/geometry/graded_lattice.hpp"

#include <random>

namespace plumb {
namespace {

/// What lies around a point of the lattice of half spacings: whole cells, divided ones.
struct Around {
  bool whole = false, divided = false;
};

/// Looks at the cells that have the point `at`, in half spacings, within them or on their boundary.
template <int d>
Around cells_around(const std::array<Index, d>& at, const std::array<Index, d>& cells,
                    const std::function<bool(const std::array<Index, d>& cell)>& is_divided) {
  Around around;
  for (int corner = 0; corner < (1 << d); ++corner) {
    std::array<Index, d> cell;
    bool inside = true;
    for (int k = 0; k < d; ++k) {
      const Index step = (corner >> k) & 1;
      if (at[k] % 2 == 1 && step == 1) inside = false;  // the middle of a cell lies in one only
      cell[k] = at[k] / 2 - (at[k] % 2 == 0 ? step : 0);
      if (cell[k] < 0 || cell[k] >= cells[k]) inside = false;
    }
    if (!inside) continue;
    (is_divided(cell) ? around.divided : around.whole) = true;
  }
  return around;
}

}  // namespace

template <int d>
Cloud<d> graded_lattice(const Box<d>& box, double spacing, const std::function<bool(const Vec<d>&)>& finer,
                        double jitter, std::uint64_t seed) {
  const std::array<Index, d> cells = cells_of<d>(box, spacing);
  const auto is_divided = [&](const std::array<Index, d>& cell) {
    Vec<d> middle;
    for (int k = 0; k < d; ++k)
      middle[k] =
          box.origin[k] + (static_cast<double>(cell[k]) + 0.5) * box.size[k] / static_cast<double>(cells[k]);
    return finer(middle);
  };
  Index points = 1;
  for (int k = 0; k < d; ++k) points *= 2 * cells[k] + 1;
  std::mt19937_64 random(seed);
  // 53 random bits to (-1, 1): the standard's distributions differ between libraries, this does not
  const auto next = [&random] { return 2 * ((static_cast<double>(random() >> 11) + 0.5) * 0x1p-53) - 1; };
  Cloud<d> cloud;
  cloud.spacing = spacing;
  cloud.box = box;
  for (Index n = 0; n < points; ++n) {
    std::array<Index, d> at;
    Index rest = n;
    bool coarse = true, on_face = false;
    Vec<d> X;
    for (int k = 0; k < d; ++k) {
      at[k] = rest % (2 * cells[k] + 1);
      rest /= 2 * cells[k] + 1;
      coarse = coarse && at[k] % 2 == 0;
      on_face = on_face || at[k] == 0 || at[k] == 2 * cells[k];
      X[k] = at[k] == 2 * cells[k] ? box.origin[k] + box.size[k]
                                   : box.origin[k] + 0.5 * static_cast<double>(at[k]) * box.size[k] /
                                                         static_cast<double>(cells[k]);
    }
    const Around around = cells_around<d>(at, cells, is_divided);
    if (!coarse && !around.divided) continue;
    for (int k = 0; k < d && !on_face && jitter > 0; ++k)
      X[k] += jitter * (around.divided ? 0.5 : 1) * spacing * next();
    cloud.X.push_back(X);
  }
  cloud.V = voronoi_volumes<d>(cloud.X, box);
  return cloud;
}

template <int d>
std::vector<double> graded_spacings(const Cloud<d>& cloud, const std::function<bool(const Vec<d>&)>& finer) {
  std::vector<double> spacings;
  for (const Vec<d>& X : cloud.X) {
    bool fine = finer(X);
    for (int k = 0; k < d; ++k)
      for (const double side : {-0.25, 0.25}) {
        Vec<d> beside = X;
        beside[k] = std::clamp(X[k] + side * cloud.spacing, cloud.box.origin[k],
                               cloud.box.origin[k] + cloud.box.size[k]);
        fine = fine && finer(beside);
      }
    spacings.push_back(fine ? 0.5 * cloud.spacing : cloud.spacing);
  }
  return spacings;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                        \
  template Cloud<d> graded_lattice<d>(const Box<d>&, double, const std::function<bool(const Vec<d>&)>&, \
                                      double, std::uint64_t);                                           \
  template std::vector<double> graded_spacings<d>(const Cloud<d>&, const std::function<bool(const Vec<d>&)>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
