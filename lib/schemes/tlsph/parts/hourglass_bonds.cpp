#include "lib/schemes/tlsph/parts/hourglass_bonds.hpp"

#include "lib/schemes/tlsph/bonds/each_bond.hpp"

namespace plumb {
template <int d>
HourglassBonds hourglass_bonds(const Solid<d>& solid, const RadialKernel<d>& kernel, double alpha) {
  const BondTable<d>& t = solid.bonds;
  const double h = solid.smoothing_length, mu = solid.elastic.shear_modulus();
  HourglassBonds k;
  k.own.assign(t.offset.size() * static_cast<std::size_t>(t.width), 0.0);
  k.other = k.own;
  k.per_volume.assign(t.slots.count(), 0.0);
  std::vector<double> sum(t.slots.count(), 0.0);  // of V W h^d
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    k.per_volume[i] = 1 / solid.volume[i];
    sum[i] = solid.volume[i] * kernel.w(0);
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      sum[i] += solid.volume[bond.other] * kernel.w(X.norm() / h);
    });
  }
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      const Index j = bond.other;
      const double pair =
          alpha * mu * solid.volume[i] * solid.volume[j] * kernel.w(X.norm() / h) / X.squaredNorm();
      k.own[bond.place()] = pair / sum[i];
      k.other[bond.place()] = pair / sum[j];
    });
  }
  return k;
}

/// With u_ij - G_i X_ij = sum_m D_jm u_m over the particle and its neighbours, K_i = sum_j k_ij D_j^T D_j in
/// each component.
template <int d>
void add_hourglass_stiffness(const Solid<d>& solid, const HourglassBonds& k, const AddStiffness& add) {
  const BondTable<d>& t = solid.bonds;
  std::vector<Index> particle(t.slots.count(), -1);
  for (Index p = 0; p < solid.cloud.size(); ++p) particle[t.slots.of(p)] = p;
  for (Index p = 0; p < solid.cloud.size(); ++p) {
    std::vector<Index> unknown{p};
    std::vector<double> springs;
    std::vector<Vec<d>> X, c;
    for_each_bond(t, t.slots.of(p), [&](const BondEntry<d>& bond, const Vec<d>& separation) {
      unknown.push_back(particle[bond.other]);
      springs.push_back(k.own[bond.place()]);
      X.push_back(separation);
      c.push_back(bond.vector(t.stencil));
    });
    const auto n = static_cast<Index>(X.size());
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(n, n + 1);
    for (Index j = 0; j < n; ++j) {
      for (Index m = 0; m < n; ++m) D(j, m + 1) = (m == j ? 1 : 0) - c[m].dot(X[j]);
      D(j, 0) = -D.row(j).sum();
    }
    const Eigen::MatrixXd K =
        D.transpose() * Eigen::Map<const Eigen::VectorXd>(springs.data(), n).asDiagonal() * D;
    for (Index a = 0; a <= n; ++a)
      for (Index b = 0; b <= n; ++b) add(unknown[a], unknown[b], K(a, b));
  }
}

template HourglassBonds hourglass_bonds<1>(const Solid<1>&, const RadialKernel<1>&, double);
template HourglassBonds hourglass_bonds<2>(const Solid<2>&, const RadialKernel<2>&, double);
template HourglassBonds hourglass_bonds<3>(const Solid<3>&, const RadialKernel<3>&, double);
template void add_hourglass_stiffness<1>(const Solid<1>&, const HourglassBonds&, const AddStiffness&);
template void add_hourglass_stiffness<2>(const Solid<2>&, const HourglassBonds&, const AddStiffness&);
template void add_hourglass_stiffness<3>(const Solid<3>&, const HourglassBonds&, const AddStiffness&);

}  // namespace plumb
