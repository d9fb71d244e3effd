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

/// |T| v without a copy of T.
Eigen::VectorXd size_of_product(const SparseMatrix& T, const Eigen::VectorXd& v) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(T.rows());
  for (Index c = 0; c < T.cols(); ++c)
    for (SparseMatrix::InnerIterator it(T, c); it; ++it) product[it.row()] += std::abs(it.value()) * v[c];
  return product;
}

}  // namespace

template <int d>
DiscreteEnergy<d>::DiscreteEnergy(StoredEnergy<d> energy, std::vector<Index> unknowns)
    : stored_(std::move(energy)), unknowns_(std::move(unknowns)) {}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::masses() const {
  Eigen::VectorXd mass(d * cloud().size());
  for (Index i = 0; i < cloud().size(); ++i)
    mass.segment<d>(d * i).setConstant(elastic().density * cloud().V[i]);
  return mass;
}

template <int d>
void DiscreteEnergy<d>::take_parts() {
  const EnergyOperators<d>& operators = *stored_.operators;
  gradient_part_ = operators.gradient.matrix(0, operators.gradient.places(), unknowns_);
  force_part_ = gradient_part_.transpose();
  for (Index n = 0; n < force_part_.cols(); ++n) force_part_.col(n) *= operators.weight[n / (d * d)];
  terms_part_ = part_of(per_component(operators.terms(), d), unknowns_, unknowns_);
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::particle_gradients(const Eigen::VectorXd& u) const {
  const auto& at = stored_.at_particles;
  return (at ? at->identity : stored_.operators->identity) + change_of_gradients(u);
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::change_of_gradients(const Eigen::VectorXd& v) const {
  const auto& at = stored_.at_particles;
  return at ? Eigen::VectorXd(at->gradient * v) : stored_.operators->gradient.times(v);
}

template <int d>
SparseMatrix DiscreteEnergy<d>::particle_operator() const {
  return stored_.at_particles ? stored_.at_particles->gradient : stored_.operators->gradient.matrix();
}

template <int d>
void DiscreteEnergy<d>::linearise_at(const Eigen::VectorXd& u) {
  material_ = block_tangents(stored_, stored_.operators->gradients(u));
}

template <int d>
SparseMatrix DiscreteEnergy<d>::tangent() {
  if (gradient_part_.rows() == 0) take_parts();
  const SparseMatrix& material = stiffness_.of(force_part_, stress_.of(material_, gradient_part_));
  return terms_part_.nonZeros() > 0 ? SparseMatrix(material + terms_part_) : material;
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::tangent_times(const Eigen::VectorXd& v) const {
  const EnergyOperators<d>& operators = *stored_.operators;
  return operators.forces(material_ * operators.gradient.times(v), v);
}

template <int d>
Eigen::VectorXd DiscreteEnergy<d>::largest_products(const Eigen::VectorXd& u) const {
  const EnergyOperators<d>& operators = *stored_.operators;
  const Eigen::VectorXd stress = size_of_product(material_, operators.gradient.largest_gradients(u));
  return operators.gradient.largest_forces(operators.weight, stress) + operators.largest_of_terms(u);
}

template <int d>
double DiscreteEnergy<d>::residual_round_off(const Eigen::VectorXd& u) const {
  constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();
  const EnergyOperators<d>& operators = *stored_.operators;
  const Eigen::VectorXd F = operators.gradients(u).cwiseAbs();
  return unit * operators.gradient.largest_forces(operators.weight, size_of_product(material_, F)).norm();
}

template class DiscreteEnergy<1>;
template class DiscreteEnergy<2>;
template class DiscreteEnergy<3>;

}  // namespace plumb
