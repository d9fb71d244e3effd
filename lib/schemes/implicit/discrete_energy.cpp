#include "lib/schemes/implicit/discrete_energy.hpp"

#include <cmath>
#include <limits>

namespace plumb {
namespace {

/// T: the law's tangents at these deformation gradients, one block per place.
template <int d>
SparseMatrix block_tangents(const StoredEnergy<d>& stored, const Eigen::VectorXd& gradients) {
  constexpr int block = d * d;
  const Index places = gradients.size() / block;
  SparseMatrix T(gradients.size(), gradients.size());
  T.reserve(Eigen::VectorXi::Constant(static_cast<int>(gradients.size()), block));
  for (Index column = 0; column < gradients.size(); ++column)
    for (int m = 0; m < block; ++m) T.insert(column / block * block + m, column) = 0;
  T.makeCompressed();
#pragma omp parallel for schedule(static)
  for (Index q = 0; q < places; ++q) {
    Mat<d> F;
    for (int m = 0; m < block; ++m) F(m / d, m % d) = gradients[block * q + m];
    const Tangent<d> tangent = stored.tangent(F, q);
    for (int k = 0; k < block; ++k)
      for (int m = 0; m < block; ++m) T.valuePtr()[(block * q + k) * block + m] = tangent(m, k);
  }
  return T;
}

/// |A| v without a copy of A.
Eigen::VectorXd size_of_product(const SparseMatrix& A, const Eigen::VectorXd& v) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(A.rows());
  for (Index c = 0; c < A.cols(); ++c)
    for (SparseMatrix::InnerIterator it(A, c); it; ++it) product[it.row()] += std::abs(it.value()) * v[c];
  return product;
}

}  // namespace

template <int d>
DiscreteEnergy<d>::DiscreteEnergy(StoredEnergy<d> energy, std::vector<Index> unknowns)
    : stored_(std::move(energy)), unknowns_(std::move(unknowns)) {}

template <int d>
void DiscreteEnergy<d>::take_parts() {
  const LinearOperators& operators = stored_.operators;
  std::vector<Index> all(static_cast<std::size_t>(operators.gradient.rows()));
  for (std::size_t n = 0; n < all.size(); ++n) all[n] = static_cast<Index>(n);
  gradient_part_ = part_of(operators.gradient, all, unknowns_);
  force_part_ = part_of(operators.force, unknowns_, all);
  terms_part_ = part_of(per_component(operators.terms, d), unknowns_, unknowns_);
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::particle_gradients(const Eigen::VectorXd& u) const {
  const auto& at = stored_.at_particles;
  if (at) return at->identity + at->gradient * u;
  return stored_.operators.identity + stored_.operators.gradient * u;
}

template <int d>
const SparseMatrix& DiscreteEnergy<d>::particle_operator() const {
  return stored_.at_particles ? stored_.at_particles->gradient : stored_.operators.gradient;
}

template <int d>
void DiscreteEnergy<d>::linearise_at(const Eigen::VectorXd& u) {
  material_ = block_tangents(stored_, stored_.operators.identity + stored_.operators.gradient * u);
}

template <int d>
SparseMatrix DiscreteEnergy<d>::tangent() {
  if (gradient_part_.rows() == 0) take_parts();
  const SparseMatrix& material = stiffness_.of(force_part_, stress_.of(material_, gradient_part_));
  return terms_part_.nonZeros() > 0 ? SparseMatrix(material + terms_part_) : material;
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::tangent_times(const Eigen::VectorXd& v) const {
  const LinearOperators& operators = stored_.operators;
  const Eigen::VectorXd stress = material_ * (operators.gradient * v);
  return operators.force * stress + component_product<d>(operators.terms, v);
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::largest_products(const Eigen::VectorXd& u) const {
  const LinearOperators& operators = stored_.operators;
  const Eigen::VectorXd size = u.cwiseAbs();
  const Eigen::VectorXd stress = size_of_product(material_, size_of_product(operators.gradient, size));
  return size_of_product(operators.force, stress) + component_product<d>(operators.terms.cwiseAbs(), size);
}

template <int d>
double DiscreteEnergy<d>::residual_round_off(const Eigen::VectorXd& u) const {
  constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();
  const LinearOperators& operators = stored_.operators;
  const Eigen::VectorXd F = (operators.identity + operators.gradient * u).cwiseAbs();
  return unit * size_of_product(operators.force, size_of_product(material_, F)).norm();
}

template class DiscreteEnergy<1>;
template class DiscreteEnergy<2>;
template class DiscreteEnergy<3>;

}  // namespace plumb
