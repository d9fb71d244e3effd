#include "lib/schemes/blocks.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace plumb {
namespace {

/// Square of min |x_ab| (stretch_a + stretch_b) over the bonds of one block.
template <int d, int W>
double least_square(const BondTable<d>& t, const Field& u, const Field& stretch, const Block& block) {
  using Real = Pack<W>;
  const Real none(std::numeric_limits<double>::max());
  Real least = none;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Vec<d, Real> own = load_vector<d, W>(u, pack * W);
    const Real here = Real::load(stretch[0] + pack * W);
    for_bonds<d, W>(t, pack, [&](std::int64_t n, Index j) {
      const Vec<d, Real> X = bond_vector<d, W>(t.separation, n);
      Vec<d, Real> x = X;
      for (int k = 0; k < d; ++k) x[k] += Real::load(u[k] + j) - own[k];
      const Real both = here + Real::load(stretch[0] + j);
      const Real square = dot<d, Real>(x, x) * both * both;
      least = min(least, lesser_where_positive(square, none, dot<d, Real>(X, X)));
    });
  }
  double smallest = least[0];
  for (int lane = 1; lane < W; ++lane) smallest = std::min(smallest, least[lane]);
  return smallest;
}

template <int d>
void tie_in(const Field& F, Field& H, Field& J, Index slots) {
  for (Index i = 0; i < slots; ++i) {
    Mat<d> in_plane;
    for (int n = 0; n < d * d; ++n) in_plane(n / d, n % d) = F[n][i];
    const Mat<3> whole = in_3d<d, double>(in_plane, 1), cof = cofactor<3, double>(whole);
    for (int n = 0; n < 9; ++n) H[n][i] = cof(n / 3, n % 3);
    J[0][i] = determinant<3, double>(whole);
  }
}

}  // namespace

template <int d>
void gradients_of_positions(const BondTable<d>& t, const Field& u, Field& F) {
  with_width(t, [&]<int W>() {
    for_blocks(t, [&](const Block& block) {
      for (Index pack = block.first_pack; pack < block.end_pack; ++pack)
        store_tensor<d, W>(gradient_of_positions<d, W>(t, u, pack), F, pack * W);
    });
  });
}

template <int d>
double crossing_time_of(const BondTable<d>& t, const Field& u, const Field& F, Field& stretch) {
  std::vector<double> least(static_cast<std::size_t>(block_count(t)));
  with_width(t, [&]<int W>() {
    for_blocks(t, [&](const Block& block) {
      for (Index i = block.begin(); i < block.end(); i += W)
        least_stretch<d, Pack<W>>(load_tensor<d, W>(F, i)).store(stretch[0] + i);
    });
    for_blocks(t, [&](const Block& block) {
      least[static_cast<std::size_t>(block.begin() / block_slots)] = least_square<d, W>(t, u, stretch, block);
    });
  });
  return 0.5 * std::sqrt(*std::min_element(least.begin(), least.end()));
}

void tie(const Field& F, Field& H, Field& J, Index slots, int d) {
  if (d == 1) tie_in<1>(F, H, J, slots);
  if (d == 2) tie_in<2>(F, H, J, slots);
  if (d == 3) tie_in<3>(F, H, J, slots);
}

bool same_values(const Field& a, const Field& b, Index slots) {
  if (a.components() != b.components()) return false;
  for (int k = 0; k < a.components(); ++k)
    if (!std::equal(a[k], a[k] + slots, b[k])) return false;
  return true;
}

#define PLUMBLINE_INSTANTIATE(d)                                                      \
  template void gradients_of_positions<d>(const BondTable<d>&, const Field&, Field&); \
  template double crossing_time_of<d>(const BondTable<d>&, const Field&, const Field&, Field&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
