#include "lib/schemes/tlsph/loops/linearise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/schemes/tlsph/bonds/momentum_form.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"

namespace plumb {
namespace {

const Elastic rubber{17e6, 0.45, 1100};

template <int d>
Solid<d> solid_with(double jitter, std::string_view momentum) {
  Box<d> box;
  std::array<Index, d> cells;
  for (int k = 0; k < d; ++k) box.origin[k] = 0, box.size[k] = 1 + k, cells[k] = 3 * (1 + k);
  Cloud<d> cloud = lattice<d>(box, cells, Layout::node);
  if (jitter > 0) cloud = jittered<d>(std::move(cloud), jitter, 3, Layout::node);
  BondOptions<d> options;
  options.kernel = kernel_named<d>("cubic");
  options.smoothing_length = 1.2 * cloud.spacing;
  options.pair = Correction::W1;
  options.estimator = estimator_named<d>("improved");
  options.momentum = momentum_form_named<d>(momentum);
  return make_solid<d>(std::move(cloud), "neo-hookean", rubber, options);
}

/// -V x force for a displacement, by the solver's own evaluation.
template <int d>
Eigen::VectorXd force_on(Solid<d>& solid, const Eigen::VectorXd& u) {
  State<d> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i), Vec<d>(u.segment<d>(d * i)));
  Eigen::VectorXd result(u.size());
  std::vector<Index> particle(solid.bonds.slots.count(), -1);
  for (Index i = 0; i < solid.cloud.size(); ++i) particle[solid.bonds.slots.of(i)] = i;
  Workspace<d> workspace;
  evaluate(solid, workspace, state, 0, [&](const Block& block, BlockForce<d>& force) {
    for (Index s = block.begin(); s < block.end(); ++s)
      for (int k = 0; k < d && particle[s] >= 0; ++k)
        result[d * particle[s] + k] = -solid.volume[s] * force(k, s);
  });
  return result;
}

template <int d>
Eigen::VectorXd some_motion(Index n) {
  Eigen::VectorXd u(n);
  for (Index i = 0; i < n; ++i) u[i] = std::sin(1.7 * static_cast<double>(i * i + 1));
  return u;
}

template <int d>
void stiffness_is_the_derivative_of_the_force(double jitter, std::string_view momentum) {
  Solid<d> solid = solid_with<d>(jitter, momentum);
  const Linearised linear = linearise(solid);
  const Eigen::VectorXd u = some_motion<d>(linear.mass.size());
  const double s = 1e-5;
  const Eigen::VectorXd by_difference = (force_on(solid, s * u) - force_on(solid, -s * u)) / (2 * s);
  // central difference: (s |grad u|)^2 ~ (1e-4)^2 of the third derivative, which is some tens of the first
  EXPECT_LT((linear.stiffness * u - by_difference).norm(), 1e-5 * by_difference.norm());
}

TEST(Linearise, IsTheDerivativeOfTheForce) {
  for (const double jitter : {0.0, 0.2})
    for (const auto* momentum : {"adjoint", "symmetrised"}) {
      stiffness_is_the_derivative_of_the_force<2>(jitter, momentum);
      stiffness_is_the_derivative_of_the_force<3>(jitter, momentum);
    }
}

TEST(Linearise, AdjointFormGivesASymmetricMatrix) {
  const Linearised adjoint = linearise(solid_with<2>(0.2, "adjoint"));
  const SparseMatrix odd = adjoint.stiffness - SparseMatrix(adjoint.stiffness.transpose());
  // sums of about 100 products: round-off
  EXPECT_LT(odd.norm(), 1e-13 * adjoint.stiffness.norm());
  const Linearised paper = linearise(solid_with<2>(0.2, "symmetrised"));
  const SparseMatrix paper_odd = paper.stiffness - SparseMatrix(paper.stiffness.transpose());
  EXPECT_GT(paper_odd.norm(), 1e-3 * paper.stiffness.norm());
}

TEST(Linearise, PartsKeepTheirOrder) {
  const Linearised linear = linearise(solid_with<2>(0.0, "adjoint"));
  const std::vector<Index> free = free_unknowns(linear.mass.size(), {4, 1, 4, 0});
  ASSERT_EQ(free[0], 2);
  ASSERT_EQ(free[2], 5);
  const SparseMatrix part = part_of(linear.stiffness, free, free);
  EXPECT_EQ(part.rows(), linear.mass.size() - 3);
  EXPECT_EQ(part.coeff(0, 2), linear.stiffness.coeff(2, 5));
}

}  // namespace
}  // namespace plumb
