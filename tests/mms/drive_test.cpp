#include "mms/drive.hpp"

#include <gtest/gtest.h>

#include "lib/scene/tlsph.hpp"
#include "mms/norms.hpp"

namespace plumb::mms {
namespace {

Scene scene_in(int dimension, double time_step, double end) {
  Scene scene;
  scene.dimension = dimension;
  scene.end_time = end;
  scene.body.size.assign(static_cast<std::size_t>(dimension), 1.0);
  scene.body.spacing = 0.25;
  scene.material.young = 17e6;
  scene.material.poisson = 0.3;
  scene.material.density = 1100;
  scene.method.integrator = "rk3";
  scene.method.cfl.reset();
  scene.method.time_step = time_step;
  return scene;
}

/// Largest error of displacement after a driven run.
template <int d>
double error_after(const char* solution_name, double time_step, double end, double* boundary = nullptr) {
  const Manufactured<d> solution = manufactured<d>(solution_name, {}, Elastic{17e6, 0.3, 1100});
  TlsphBody<d> simulation = make_tlsph<d>(scene_in(d, time_step, end));
  const ChosenIntegrator<d> integrator =
      drive(simulation.solid, simulation.state, simulation.integrator, solution, {Layout::node, true});
  EXPECT_TRUE(run(simulation.solid, simulation.state, integrator, simulation.control).completed());
  double worst = 0;
  const Cloud<d>& cloud = simulation.solid.cloud;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d> u = vector_at<d>(simulation.state.u, simulation.solid.bonds.slots.of(i));
    const double error = (u - solution.displacement(cloud.X[i], simulation.state.time)).norm();
    worst = std::max(worst, error);
    const Vec<d> inside = (cloud.X[i].array() - 0.5).abs();
    if (boundary && inside.maxCoeff() > 0.49) *boundary = std::max(*boundary, error);
  }
  return worst;
}

// No stress, no tractions: the centripetal load alone moves the body. With loads at the times of the stages
// RK3 is of third order (local error dt^4 U^(4)/24 ..); with loads at the start of the step it would be of
// first.
TEST(Drive, RigidRotationIsFollowedToThirdOrderInTime) {
  const double coarse = error_after<3>("rigid-rotation", 2e-4, 4e-3),
               fine = error_after<3>("rigid-rotation", 1e-4, 4e-3);
  EXPECT_GT(coarse, 1e-8);
  EXPECT_NEAR(std::log2(coarse / fine), 3, 0.15);
}

// All boundary particles are held on the exact motion. F is uniform, but next to the faces the weights of the
// force do not balance, so that inside a force is left: 5e-3 m is 1 % of the displacements (0.5 m), which a
// missing load exceeds.
TEST(Drive, PrescribedFacesAreExactAtTheEndOfEveryStep) {
  double boundary = 0;
  const double inside = error_after<2>("affine-patch", 1e-4, 5e-3, &boundary);
  EXPECT_LT(boundary, 1e-15);
  EXPECT_LT(inside, 5e-3);
}

// Linear in the loads: the clamp at the base and the tractions on the other faces must hold the column on its
// way. A missing or wrong traction shows as an error of the size of the displacement (0.3 m at this time).
TEST(Drive, TractionsCarryTheColumn) {
  const Manufactured<2> solution = manufactured<2>("stretched-column", {}, Elastic{17e6, 0.3, 1100});
  Scene scene = scene_in(2, 1e-4, 0.04);
  scene.body.origin = {-0.5, 0};
  scene.body.size = {1, 2};
  scene.body.spacing = 0.125;
  TlsphBody<2> simulation = make_tlsph<2>(scene);
  const ChosenIntegrator<2> integrator =
      drive(simulation.solid, simulation.state, simulation.integrator, solution, {Layout::node, true});
  ASSERT_TRUE(run(simulation.solid, simulation.state, integrator, simulation.control).completed());
  const ErrorNorms error = nodal_norms<2>(
      simulation.solid.cloud, nodal_values<2>(simulation.solid, simulation.state, solution.first_piola),
      [&](const Vec<2>& X) -> PointValue<2> {
        const Motion<2> m = solution.motion(X, 0.04);
        return {m.displacement, m.F - Mat<2>::Identity()};
      });
  EXPECT_GT(solution.displacement({0, 2}, 0.04)[1], 0.3);
  EXPECT_LT(error.linf, 0.03);
}

// F is uniform and every particle that is read has a whole support, so that no error in space is left.
TEST(Drive, ABandOfTwoSupportsMakesAffineMotionExact) {
  const Manufactured<2> solution = manufactured<2>("affine-patch", {}, Elastic{17e6, 0.3, 1100});
  Scene scene = scene_in(2, 1e-4, 5e-3);
  scene.body.spacing = 0.1;
  TlsphBody<2> simulation = make_tlsph<2>(scene);
  const DriveOptions options{Layout::node, true, 0.3};
  const ChosenIntegrator<2> integrator =
      drive(simulation.solid, simulation.state, simulation.integrator, solution, options);
  ASSERT_TRUE(run(simulation.solid, simulation.state, integrator, simulation.control).completed());
  double worst = 0;
  const Cloud<2>& cloud = simulation.solid.cloud;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<2> u = vector_at<2>(simulation.state.u, simulation.solid.bonds.slots.of(i));
    worst = std::max(worst, (u - solution.displacement(cloud.X[i], simulation.state.time)).norm());
  }
  // the motion is not polynomial in time: what is left is the error of RK3 at this step, 2e-8 m
  EXPECT_LT(worst, 5e-8);
}

}  // namespace
}  // namespace plumb::mms
