// Whether the pairs' dissipation can only take energy: eigenvalues of what it does to the velocities of a body at rest.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

/// Largest and smallest eigenvalue of the symmetric part of the dissipation over the mass, in units of c_p/d.
template <int d>
std::pair<double, double> growth_of_energy(const std::string& upwind, Index cells) {
  const Cloud<d> cloud = cube<d>(cells);
  MixedOptions o = mixed_options(upwind);
  o.volumes = "tributary";
  Mixed<d> body = mixed_body(cloud, o);
  const Index n = d * cloud.size();
  Eigen::MatrixXd A(n, n);
  InitialMotion<d> motion;
  for (Index column = 0; column < n; ++column) {
    motion.v.assign(cloud.X.size(), Vec<d>::Zero());
    motion.v[column / d][column % d] = 1;
    const MixedState<d> state = body.start(motion);
    MixedState<d> rate = state;
    EXPECT_FALSE(body.rates(state, 0, rate));
    for (Index p = 0; p < cloud.size(); ++p)
      A.template block<d, 1>(d * p, column) =
          std::sqrt(cloud.V[p] / cloud.V[column / d]) * vector_at<d>(rate.v, body.bonds().table.slots.of(p));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(0.5 * (A + A.transpose()));
  const double unit = column_rubber.wave_speed() / cloud.spacing;
  return {eigen.eigenvalues().maxCoeff() / unit, eigen.eigenvalues().minCoeff() / unit};
}

// A second program of the printed form has 2.3e-4 for 9 x 9 nodes and 4.3e-3 for 4 x 4 x 4.
TEST(MixedEntropy, ThePrintedFormCanMakeEnergyAndTheAdjointOneCannot) {
  for (const char* upwind : {"constant", "adjoint"}) {
    const auto [plane, plane_least] = growth_of_energy<2>(upwind, 8);
    const auto [space, space_least] = growth_of_energy<3>(upwind, 3);
    EXPECT_LT(plane, 1e-11) << upwind;  // round-off of stresses of an acceleration of c_p/d
    EXPECT_LT(space, 1e-11) << upwind;
    EXPECT_LT(plane_least, -1) << upwind;
    EXPECT_LT(space_least, -1) << upwind;
  }
  EXPECT_NEAR(growth_of_energy<2>("reconstructed", 8).first, 2.3e-4, 0.05e-4);  // the digits that are known
  EXPECT_NEAR(growth_of_energy<3>("reconstructed", 3).first, 4.3e-3, 0.05e-3);
}

}  // namespace
}  // namespace plumb::testing
