#include "lib/spectrum/linear_operator.hpp"

#include <cmath>
#include <set>

#include "lib/geometry/rigid_motions.hpp"
#include "lib/linear/dense.hpp"
#include "lib/material/models/linear_elastic.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/loops/make_sweeps.hpp"

namespace plumb {
namespace {

/// Loops for linear response: the deformation is scaled freely, so J means nothing.
template <int d>
Sweeps<d> linear_sweeps(const Elastic& elastic, const BondTable<d>& all) {
  const LinearElastic material(elastic);  // the tangent at F = I of every law with these constants
  Sweeps<d> sweeps = all.width == 1 ? plain_sweeps<d>(material, all) : lattice_sweeps<d>(material, all);
  sweeps.stress = [stress = sweeps.stress](const BondTable<d>& bonds, const Field& u, const Block& block,
                                           StressWindow& P, Field* F) {
    stress(bonds, u, block, P, F);
    return true;
  };
  return sweeps;
}

}  // namespace

template <int d>
LinearOperator<d>::LinearOperator(Solid<d> solid, const std::vector<Support<d>>& supports)
    : solid_(std::move(solid)) {
  for (const auto& term : solid_.terms)
    if (term.whole)
      throw InputError("a spectrum with [" + term.name + "]",
                       "its matrix couples every particle with every other", "leave the section out");
  own_sweeps_ = solid_.sweeps;
  solid_.sweeps = linear_sweeps<d>(solid_.elastic, solid_.bonds);
  state_ = make_state(solid_);
  std::set<std::pair<Index, int>> held;
  for (const auto& s : supports) held.insert({s.particle, s.component});
  for (Index i = 0; i < solid_.cloud.size(); ++i)
    for (int k = 0; k < d; ++k)
      if (!held.count({i, k})) components_.push_back({i, k});
  at_rest_ = Eigen::VectorXd::Zero(size());
  at_rest_ = response(nullptr, nullptr);
  // any term that acts on velocities answers to a field without symmetry
  Eigen::VectorXd probe(size());
  for (Index n = 0; n < size(); ++n) probe[n] = std::sin(12.9898 * static_cast<double>(n + 1));
  damped_ = damping(probe).norm() > 0;
}

template <int d>
Eigen::VectorXd LinearOperator<d>::response(const Eigen::VectorXd* a, const Eigen::VectorXd* b) {
  const double length = solid_.cloud.spacing, speed = solid_.elastic.wave_speed();
  for (Index n = 0; n < size(); ++n) {
    const Index slot = solid_.bonds.slots.of(components_[n].particle);
    state_.u[components_[n].axis][slot] = a ? (*a)[n] * length : 0.0;
    state_.v[components_[n].axis][slot] = b ? (*b)[n] * speed : 0.0;
  }
  Field force = solid_.make_field(d);
  evaluate(solid_, workspace_, state_, 0.0, [&](const Block& block, BlockForce<d>& f) {
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) force[k][i] = f(k, i);
  });
  const double per_mass = length / (speed * speed * solid_.elastic.density);
  Eigen::VectorXd result(size());
  for (Index n = 0; n < size(); ++n)
    result[n] = per_mass * force[components_[n].axis][solid_.bonds.slots.of(components_[n].particle)];
  return result - at_rest_;
}

template <int d>
Eigen::VectorXd LinearOperator<d>::stiffness(const Eigen::VectorXd& a) {
  return -response(&a, nullptr);
}

template <int d>
Eigen::VectorXd LinearOperator<d>::damping(const Eigen::VectorXd& b) {
  return -response(nullptr, &b);
}

template <int d>
Eigen::SparseMatrix<double> LinearOperator<d>::damping_matrix() {
  Eigen::SparseMatrix<double> result(size(), size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(size());
  double largest = 0;
  for (Index n = 0; n < size(); ++n) {
    unit[n] = 1;
    const Eigen::VectorXd column = damping(unit);
    unit[n] = 0;
    largest = std::max(largest, column.cwiseAbs().maxCoeff());
    for (Index m = 0; m < size(); ++m)
      if (std::abs(column[m]) > 1e-15 * largest)
        entries.emplace_back(static_cast<int>(m), static_cast<int>(n), column[m]);
  }
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template <int d>
Eigen::SparseMatrix<double> LinearOperator<d>::stiffness_matrix() const {
  Solid<d> solid = solid_;
  solid.sweeps = own_sweeps_;
  const Linearised linear = linearise(solid);
  std::vector<Index> free;
  for (const auto& [particle, axis] : components_) free.push_back(d * particle + axis);
  SparseMatrix K = part_of(linear.stiffness, free, free);
  const double unit = time_unit() * time_unit();
  for (Index column = 0; column < K.cols(); ++column)
    for (SparseMatrix::InnerIterator it(K, column); it; ++it)
      it.valueRef() *= unit / linear.mass[free[it.row()]];
  return K;
}

template <int d>
Eigen::VectorXd LinearOperator<d>::root_masses() const {
  const double mean = std::pow(solid_.cloud.spacing, d);
  Eigen::VectorXd masses(size());
  for (Index n = 0; n < size(); ++n) masses[n] = std::sqrt(solid_.cloud.V[components_[n].particle] / mean);
  return masses;
}

template <int d>
Eigen::MatrixXd LinearOperator<d>::rigid_motions() const {
  const RigidMotions<d> rigid(solid_.cloud.box);
  constexpr int motions = RigidMotions<d>::count;
  const auto& cloud = solid_.cloud;
  // what the motions do to the held components must vanish
  Eigen::MatrixXd free(size(), motions);
  Eigen::MatrixXd held = Eigen::MatrixXd::Zero(motions, motions);
  std::vector<std::array<bool, d>> is_free(cloud.size(), std::array<bool, d>{});
  for (Index n = 0; n < size(); ++n) {
    is_free[components_[n].particle][components_[n].axis] = true;
    free.row(n) = rigid.at(cloud.X[components_[n].particle]).row(components_[n].axis);
  }
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; k < d; ++k) {
      if (is_free[i][k]) continue;
      const Eigen::VectorXd row = rigid.at(cloud.X[i]).row(k);
      held += row * row.transpose();
    }
  if (solid_.bonds.mirror)  // nothing leaves a wall
    for (const Wall& wall : solid_.bonds.mirror->walls)
      for (const Vec<d>& X : cloud.X) {
        Vec<d> foot = X;
        foot[wall.axis] = cloud.box.origin[wall.axis] + (wall.upper ? cloud.box.size[wall.axis] : 0);
        const Eigen::VectorXd row = rigid.at(foot).row(wall.axis);
        held += row * row.transpose();
      }
  const SymmetricPairs by_hold = symmetric_pairs(held);
  Index allowed = 0;
  const double most = by_hold.values[motions - 1];
  while (allowed < motions && by_hold.values[allowed] <= 1e-10 * std::max(most, 1e-300)) ++allowed;
  return orthonormal_basis(free * by_hold.vectors.leftCols(allowed), 0);
}

template class LinearOperator<1>;
template class LinearOperator<2>;
template class LinearOperator<3>;

}  // namespace plumb
