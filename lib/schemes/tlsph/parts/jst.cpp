#include "lib/schemes/tlsph/parts/jst.hpp"

#include <cmath>
#include <memory>

#include "lib/schemes/gather.hpp"

namespace plumb {
namespace {

/// sum_j w_ij (q_j - q_i) of one block, of q's first K components.
/// With own weights o_i, if there are any: plus o_i q_i.
template <int d, int W, int K = d, class Store>
void laplacian_of(const BondTable<d>& bonds, const AlignedVector& weights, const AlignedVector& own_weights,
                  const Field& q, const Block& block, Store&& store) {
  using Real = Pack<W>;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    const std::int32_t row = bonds.row[pack];
    Real own[K], sum[K];
    const Real extra =
        own_weights.empty() ? Real(0) : Real::load(own_weights.data() + static_cast<Index>(row) * W);
    for (int k = 0; k < K; ++k) own[k] = Real::load(q[k] + i), sum[k] = extra * own[k];
    for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n) {
      const Real w = Real::load(weights.data() + n * W);
      for (int k = 0; k < K; ++k) sum[k] += w * (Real::load(q[k] + i + bonds.offset[n]) - own[k]);
    }
    for (int k = 0; k < K; ++k) store(k, i, sum[k]);
  }
}

/// The same sum over images, sum_j w_ij (R q_j - q_i), where a pack has any.
template <int d, int W, class Add>
void images_laplacian_of(const BondTable<d>& bonds, bool outer, const Field& q, const Block& block,
                         Add&& add) {
  using Real = Pack<W>;
  const MirrorBonds<d>& images = *bonds.mirror;
  const AlignedVector& weights = outer ? images.outer_laplacian : images.laplacian;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W, row = bonds.row[pack];
    for (std::int64_t n = images.begin[row]; n < images.begin[row + 1]; ++n)
      for (int k = 0; k < d; ++k)
        add(k, i,
            Real::load(weights.data() + n * W) *
                (Real(images.signs[n][k]) * Real::load(q[k] + i + images.offset[n]) - Real::load(q[k] + i)));
  }
}

/// to = lap q (or lap' q) of one block, of the first K components; with images of all of them.
template <int d, int K = d>
void store_laplacian(const BondTable<d>& bonds, bool outer, const Field& q, const Block& block, Field& to) {
  const AlignedVector none;
  with_width(bonds, [&]<int W>() {
    laplacian_of<d, W, K>(bonds, outer ? bonds.outer_laplacian : bonds.laplacian,
                          outer ? bonds.own_outer : none, q, block,
                          [&](int k, Index i, Pack<W> sum) { sum.store(to[k] + i); });
    if (K == d && bonds.mirror)
      images_laplacian_of<d, W>(bonds, outer, q, block, [&](int k, Index i, Pack<W> part) {
        (Pack<W>::load(to[k] + i) + part).store(to[k] + i);
      });
  });
}

/// force += factor lap' q of one block.
template <int d>
void add_outer_laplacian(const BondTable<d>& bonds, const Field& q, const Block& block, double factor,
                         BlockForce<d>& force) {
  with_width(bonds, [&]<int W>() {
    const auto add = [&](int k, Index i, Pack<W> sum) {
      (Pack<W>::load(force.at(k, i)) + Pack<W>(factor) * sum).store(force.at(k, i));
    };
    laplacian_of<d, W>(bonds, bonds.outer_laplacian, bonds.own_outer, q, block, add);
    if (bonds.mirror) images_laplacian_of<d, W>(bonds, true, q, block, add);
  });
}

struct Arrays {
  Field inner;   ///< lap v [1/(m s)]
  Field second;  ///< lap' v, only for eta2
};

/// v read, lap v written and read, with eta2 v read and lap' v written and read; the tables of rows of their
/// own.
template <int d>
double bytes_moved(const Solid<d>& solid, bool second) {
  const int laplacians = second ? 3 : 2;
  double bytes = sizeof(double) * d * (second ? 6.0 : 3.0);
  if (solid.bonds.width == 1)
    bytes += laplacians * (sizeof(double) + sizeof(std::int32_t)) * static_cast<double>(solid.bonds.pairs) /
             static_cast<double>(solid.cloud.size());
  return bytes;
}

/// Of lap' lap [1/m^4], by power iteration on K components: all of them are alike but for images, whose signs
/// differ by component.
template <int d, int K>
double largest_eigenvalue(const Solid<d>& solid) {
  Field q = solid.make_field(K), inner = solid.make_field(K);
  // a start that holds every mode; its numbers do not matter
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < K; ++k)
      q[k][solid.bonds.slots.of(i)] = std::sin(12.9898 * static_cast<double>(i + 1) + 78.233 * k);
  const auto for_blocks = [&](auto&& f) {
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
    for (Index b = 0; b < solid.blocks(); ++b) f(solid.block(b));
  };
  double eigenvalue = 0;
  // 60 steps give three digits on free bodies, and 1.3 % too little was seen between two mirror walls
  for (int step = 0; step < 60; ++step) {
    const double size = std::sqrt(sum_over_blocks(solid, [&](const Block& block) {
      double sum = 0;
      for (int k = 0; k < K; ++k)
        for (Index i = block.begin(); i < block.end(); ++i) sum += q[k][i] * q[k][i];
      return sum;
    }));
    if (step > 0) eigenvalue = size;
    for_blocks([&](const Block& block) {
      for (int k = 0; k < K; ++k)
        for (Index i = block.begin(); i < block.end(); ++i) q[k][i] /= size;
    });
    for_blocks([&](const Block& block) { store_laplacian<d, K>(solid.bonds, false, q, block, inner); });
    for_blocks([&](const Block& block) { store_laplacian<d, K>(solid.bonds, true, inner, block, q); });
  }
  return eigenvalue;
}

}  // namespace

template <int d>
Term<d> jst_term(const Solid<d>& solid, const JstOptions& options) {
  auto arrays = std::make_shared<Arrays>();
  arrays->inner = solid.make_field(d);
  if (options.eta2 != 0) arrays->second = solid.make_field(d);
  const double speed = solid.elastic.wave_speed() * solid.elastic.density;
  const double h = solid.smoothing_length;
  const double second = options.eta2 * speed * h, fourth = -options.eta4 * speed * h * h * h;
  Term<d> term;
  term.name = "jst";
  term.bytes = arrays->inner.bytes() + arrays->second.bytes();
  term.bytes_per_update = bytes_moved(solid, options.eta2 != 0);
  term.first = [arrays, second](const Solid<d>& body, const Block& block, const Instant<d>& now) {
    store_laplacian<d>(body.bonds, false, now.state.v, block, arrays->inner);
    if (second != 0) store_laplacian<d>(body.bonds, true, now.state.v, block, arrays->second);
  };
  term.second = [arrays, second, fourth](const Solid<d>& body, const Block& block, const Instant<d>&,
                                         BlockForce<d>& force) {
    add_outer_laplacian<d>(body.bonds, arrays->inner, block, fourth, force);
    if (second == 0) return;
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) force(k, i) += second * arrays->second[k][i];
  };
  return term;
}

template <int d>
double biharmonic_radius(const Solid<d>& solid) {
  const double radius =
      solid.bonds.mirror ? largest_eigenvalue<d, d>(solid) : largest_eigenvalue<d, 1>(solid);
  return radius * std::pow(solid.cloud.spacing, 4);
}

template <int d>
double jst_step_limit(const Solid<d>& solid, const JstOptions& options, double limit) {
  const double h = solid.smoothing_length;
  const double radius = biharmonic_radius<d>(solid) / std::pow(solid.cloud.spacing, 4);
  return limit / (options.eta4 * solid.elastic.wave_speed() * h * h * h * radius);
}

template Term<1> jst_term<1>(const Solid<1>&, const JstOptions&);
template Term<2> jst_term<2>(const Solid<2>&, const JstOptions&);
template Term<3> jst_term<3>(const Solid<3>&, const JstOptions&);
template double biharmonic_radius<1>(const Solid<1>&);
template double biharmonic_radius<2>(const Solid<2>&);
template double biharmonic_radius<3>(const Solid<3>&);
template double jst_step_limit<1>(const Solid<1>&, const JstOptions&, double);
template double jst_step_limit<2>(const Solid<2>&, const JstOptions&, double);
template double jst_step_limit<3>(const Solid<3>&, const JstOptions&, double);

}  // namespace plumb
