#include "lib/spectrum/lattice_symbol.hpp"

#include <cmath>

namespace plumb {

template <int d>
LatticeSymbol<d>::LatticeSymbol(BondOptions<d> options, double beta) {
  options.laplacian = false;
  options.smoothing_length = beta;
  // a block wide enough that its middle particle and all its neighbours have full neighbourhoods
  const Index reach = static_cast<Index>(std::ceil(options.kernel.support * beta)) * 2 + 1;
  Box<d> box{Vec<d>::Zero(), Vec<d>::Constant(static_cast<double>(2 * reach + 1))};
  std::array<Index, d> cells;
  cells.fill(2 * reach + 1);
  Cloud<d> cloud = lattice<d>(box, cells, Layout::cell);
  const BondTable<d> t = make_bond_table<d>(cloud, options);
  const Vec<d> middle = 0.5 * box.size;
  Index centre = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    if ((cloud.X[i] - middle).norm() < (cloud.X[centre] - middle).norm()) centre = i;
  const Index slot = t.slots.of(centre), row = t.row[slot / t.width], lane = slot % t.width;
  for (int k = 0; k < d; ++k) own_force_[k] = t.own_force[(row * d + k) * t.width + lane];
  for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n) {
    Vec<d> X, c, a;
    for (int k = 0; k < d; ++k) {
      X[k] = t.separation[(n * d + k) * t.width + lane];
      c[k] = t.stencil[(n * d + k) * t.width + lane];
      a[k] = t.force_weights()[(n * d + k) * t.width + lane];
    }
    if (X.norm() == 0) continue;  // this lane has no such neighbour
    separation_.push_back(X);
    stencil_.push_back(c);
    force_.push_back(a);
  }
}

template <int d>
Vec<d> LatticeSymbol<d>::gradient(const Vec<d>& theta) const {
  Vec<d> g = Vec<d>::Zero();
  for (std::size_t n = 0; n < separation_.size(); ++n) g += std::sin(theta.dot(separation_[n])) * stencil_[n];
  return g;
}

template <int d>
Vec<d> LatticeSymbol<d>::divergence(const Vec<d>& theta) const {
  Vec<d> g = Vec<d>::Zero();
  for (std::size_t n = 0; n < separation_.size(); ++n) g += std::sin(theta.dot(separation_[n])) * force_[n];
  return g;
}

template <int d>
Mat<d> LatticeSymbol<d>::dynamical_matrix(const Vec<d>& theta, const Elastic& elastic) const {
  const Vec<d> g = gradient(theta), s = divergence(theta);
  const double lambda = elastic.lame(), mu = elastic.shear_modulus();
  // stress of the wave: lambda (g.u) I + mu (u g^T + g u^T); its divergence by s
  const Mat<d> D = lambda * s * g.transpose() + mu * (g.dot(s) * Mat<d>::Identity() + g * s.transpose());
  return D / (lambda + 2 * mu);
}

template class LatticeSymbol<1>;
template class LatticeSymbol<2>;
template class LatticeSymbol<3>;

}  // namespace plumb
