#include "lib/schemes/tlsph/parts/slope_hourglass.hpp"

#include <memory>

#include "lib/schemes/gather.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "lib/schemes/tlsph/parts/hourglass_bonds.hpp"

namespace plumb {
namespace {

/// Springs of a body's bonds, and what finds H from them.
template <int d>
struct SlopeBonds {
  HourglassBonds springs;  ///< k_ij = 2 alpha mu V_i w_ij / r^2
  Field inverse;           ///< per slot: (sum k X (x) X)^-1
};

template <int d>
SlopeBonds<d> slope_bonds(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha,
                          const std::vector<double>& radius) {
  const BondTable<d>& t = solid.bonds;
  const double mu = solid.elastic.shear_modulus();
  std::vector<double> sum(t.slots.count(), 0.0), reach(t.slots.count(), 0.0);
  for (Index p = 0; p < solid.cloud.size(); ++p) reach[t.slots.of(p)] = radius[p];
  const auto weight = [&](Index i, Index j, double r) {
    return r < reach[i] ? -solid.volume[j] * kernel.dw(r / reach[i] * kernel.support) * r / reach[i] : 0.0;
  };
  SlopeBonds<d> made;
  HourglassBonds& k = made.springs;
  k.own.assign(t.offset.size() * static_cast<std::size_t>(t.width), 0.0);
  k.other = k.own;
  k.per_volume.assign(t.slots.count(), 0.0);
  made.inverse = solid.make_field(d * d);
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    k.per_volume[i] = 1 / solid.volume[i];
    for_each_bond(
        t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) { sum[i] += weight(i, bond.other, X.norm()); });
  }
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    Mat<d> A = Mat<d>::Zero();
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      const Index j = bond.other;
      const double r = X.norm(), twice = 2 * alpha * mu / (r * r);
      k.own[bond.place()] = twice * solid.volume[i] * weight(i, j, r) / sum[i];
      k.other[bond.place()] = twice * solid.volume[j] * weight(j, i, r) / sum[j];
      A += k.own[bond.place()] * X * X.transpose();
    });
    const Mat<d> inverse = A.inverse();
    for (int n = 0; n < d * d; ++n) made.inverse[n][i] = inverse(n / d, n % d);
  }
  return made;
}

/// H = (sum k u_ij (x) X_ij) (sum k X_ij (x) X_ij)^-1 of one pack.
template <int d, int W>
Mat<d, Pack<W>> best_gradient(const Solid<d>& solid, const SlopeBonds<d>& bonds, const Field& u, Index pack) {
  using Real = Pack<W>;
  const Vec<d, Real> own = load_vector<d, W>(u, pack * W);
  Mat<d, Real> B = zero_tensor<d, Real>(), H = B;
  for_bonds<d, W>(solid.bonds, pack, [&](std::int64_t n, Index j) {
    const Vec<d, Real> X = bond_vector<d, W>(solid.bonds.separation, n);
    Vec<d, Real> pull = load_vector<d, W>(u, j);
    for (int a = 0; a < d; ++a) pull[a] = bond_number<W>(bonds.springs.own, n) * (pull[a] - own[a]);
    add_outer<d, Real>(B, pull, X);
  });
  const Mat<d, Real> inverse = load_tensor<d, W>(bonds.inverse, pack * W);
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b)
      for (int c = 0; c < d; ++c) H(a, b) += B(a, c) * inverse(c, b);
  return H;
}

/// Calls use(own spring, other spring, X, u_ij - H X, u_ij) for the bonds of one pack.
template <int d, int W, class Use>
void for_excess(const Solid<d>& solid, const SlopeBonds<d>& bonds, const Field& u, Index pack,
                const Mat<d, Pack<W>>& H, Use&& use) {
  using Real = Pack<W>;
  const Vec<d, Real> own = load_vector<d, W>(u, pack * W);
  for_bonds<d, W>(solid.bonds, pack, [&](std::int64_t n, Index j) {
    const Vec<d, Real> HX = times<d, Real>(H, bond_vector<d, W>(solid.bonds.separation, n));
    Vec<d, Real> apart = load_vector<d, W>(u, j), excess;
    for (int a = 0; a < d; ++a) {
      apart[a] = apart[a] - own[a];
      excess[a] = apart[a] - HX[a];
    }
    use(bond_number<W>(bonds.springs.own, n), bond_number<W>(bonds.springs.other, n), excess, apart);
  });
}

/// H of every slot of the block, and what the force takes from it.
template <int d, int W>
void own_part(const Solid<d>& solid, const SlopeBonds<d>& bonds, const Block& block, const Field& u,
              Field& gradient, Field& partial) {
  using Real = Pack<W>;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Mat<d, Real> H = best_gradient<d, W>(solid, bonds, u, pack);
    store_tensor<d, W>(H, gradient, pack * W);
    Vec<d, Real> f = zero_vector<d, Real>();
    for_excess<d, W>(solid, bonds, u, pack, H,
                     [&](Real own, Real other, const Vec<d, Real>& excess, const Vec<d, Real>& apart) {
                       for (int a = 0; a < d; ++a) f[a] += own * excess[a] + other * apart[a];
                     });
    store_vector<d, W>(f, partial, pack * W);
  }
}

/// Adds the force per volume, with what it takes from the H of the others.
template <int d, int W>
void others_part(const Solid<d>& solid, const SlopeBonds<d>& bonds, const Block& block, const Field& gradient,
                 const Field& partial, BlockForce<d>& force) {
  using Real = Pack<W>;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index i = pack * W;
    Vec<d, Real> f = load_vector<d, W>(partial, i);
    for_bonds<d, W>(solid.bonds, pack, [&](std::int64_t n, Index j) {
      const Vec<d, Real> HX =
          times<d, Real>(load_tensor<d, W>(gradient, j), bond_vector<d, W>(solid.bonds.separation, n));
      for (int a = 0; a < d; ++a) f[a] = f[a] - bond_number<W>(bonds.springs.other, n) * HX[a];
    });
    const Real per_volume = Real::load(bonds.springs.per_volume.data() + i);
    for (int a = 0; a < d; ++a) (Real::load(force.at(a, i)) + f[a] * per_volume).store(force.at(a, i));
  }
}

template <int d, int W>
double energy_of_block(const Solid<d>& solid, const SlopeBonds<d>& bonds, const Block& block,
                       const Field& u) {
  using Real = Pack<W>;
  Real twice(0);
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack)
    for_excess<d, W>(solid, bonds, u, pack, best_gradient<d, W>(solid, bonds, u, pack),
                     [&](Real own, Real, const Vec<d, Real>& excess, const Vec<d, Real>&) {
                       twice += own * dot<d, Real>(excess, excess);
                     });
  double sum = 0;
  for (int lane = 0; lane < W; ++lane) sum += twice[lane];
  return sum / 2;
}

/// K_i = sum_j k_ij (1_j - 1_i)(1_j - 1_i)^T - B^T A^-1 B, B = sum_j k_ij X_ij (1_j - 1_i)^T, A = sum k X (x)
/// X.
template <int d>
void add_stiffness(const Solid<d>& solid, const SlopeBonds<d>& bonds, const AddStiffness& add) {
  const BondTable<d>& t = solid.bonds;
  std::vector<Index> particle(t.slots.count(), -1);
  for (Index p = 0; p < solid.cloud.size(); ++p) particle[t.slots.of(p)] = p;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    std::vector<Index> node{p};
    std::vector<double> springs;
    std::vector<Vec<d>> X;
    for_each_bond(t, t.slots.of(p), [&](const BondEntry<d>& bond, const Vec<d>& separation) {
      if (bonds.springs.own[bond.place()] == 0) return;
      node.push_back(particle[bond.other]);
      springs.push_back(bonds.springs.own[bond.place()]);
      X.push_back(separation);
    });
    const auto n = static_cast<Index>(X.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::Matrix<double, d, Eigen::Dynamic> B = Eigen::Matrix<double, d, Eigen::Dynamic>::Zero(d, n + 1);
    for (Index j = 0; j < n; ++j) {
      K(j + 1, j + 1) += springs[j];
      K(0, 0) += springs[j];
      K(0, j + 1) -= springs[j];
      K(j + 1, 0) -= springs[j];
      B.col(j + 1) += springs[j] * X[j];
      B.col(0) -= springs[j] * X[j];
    }
    Mat<d> inverse;
    for (int m = 0; m < d * d; ++m) inverse(m / d, m % d) = bonds.inverse[m][t.slots.of(p)];
    K -= B.transpose() * inverse * B;
    for (Index a = 0; a <= n; ++a)
      for (Index b = 0; b <= n; ++b) add(node[a], node[b], 0.5 * (K(a, b) + K(b, a)));
  }
}

/// The functions of the term, for one width of packs.
template <int d, int W>
void set_functions(Term<d>& term, const std::shared_ptr<const SlopeBonds<d>>& bonds,
                   const std::shared_ptr<Field>& gradient, const std::shared_ptr<Field>& partial) {
  term.first = [=](const Solid<d>& solid, const Block& block, const Instant<d>& now) {
    own_part<d, W>(solid, *bonds, block, now.state.u, *gradient, *partial);
  };
  term.second = [=](const Solid<d>& solid, const Block& block, const Instant<d>&, BlockForce<d>& force) {
    others_part<d, W>(solid, *bonds, block, *gradient, *partial, force);
  };
  term.energy = [bonds](const Solid<d>& solid, const State<d>& state) {
    return sum_over_blocks(
        solid, [&](const Block& block) { return energy_of_block<d, W>(solid, *bonds, block, state.u); });
  };
}

}  // namespace

template <int d>
Term<d> slope_hourglass_term(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha,
                             std::vector<double> radius) {
  if (radius.empty()) radius.assign(solid.cloud.X.size(), solid.smoothing_length * kernel.support);
  const auto bonds = std::make_shared<const SlopeBonds<d>>(slope_bonds(solid, kernel, alpha, radius));
  const auto gradient = std::make_shared<Field>(solid.make_field(d * d));
  const auto partial = std::make_shared<Field>(solid.make_field(d));
  Term<d> term;
  term.name = "hourglass";
  term.bytes = partial->bytes() + gradient->bytes() + bonds->inverse.bytes() + bonds->springs.bytes();
  if (solid.bonds.width == 1)
    set_functions<d, 1>(term, bonds, gradient, partial);
  else
    set_functions<d, native_width>(term, bonds, gradient, partial);
  term.stiffness = [bonds](const Solid<d>& body, const AddStiffness& add) {
    add_stiffness(body, *bonds, add);
  };
  return term;
}

#define PLUMBLINE_INSTANTIATE(d)                                                            \
  template Term<d> slope_hourglass_term<d>(const Solid<d>&, const RadialKernel<d>&, double, \
                                           std::vector<double>);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
