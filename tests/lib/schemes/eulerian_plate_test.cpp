// The oscillating plate of paper 001 (3.2) against another program: ten particles across, 500 steps, a wall of three
// columns that is held, a new reference at every tenth step.
#include <gtest/gtest.h>

#include "lib/schemes/point_fields.hpp"
#include "tests/support/eulerian.hpp"

namespace plumb::testing {
namespace {

constexpr double spacing = 0.002, height = 0.02, length = 0.2;

/// Plate of 100 x 10 particles, then the wall of 3 x 16.
Cloud<2> plate_with_wall() {
  Cloud<2> cloud = lattice<2>({Vec<2>(0, -height / 2), Vec<2>(length, height)}, {100, 10}, Layout::cell);
  const Cloud<2> wall = lattice<2>({Vec<2>(-3 * spacing, -8 * spacing), Vec<2>(3 * spacing, 16 * spacing)},
                                   {3, 16}, Layout::cell);
  cloud.X.insert(cloud.X.end(), wall.X.begin(), wall.X.end());
  cloud.V.insert(cloud.V.end(), wall.V.begin(), wall.V.end());
  return cloud;
}

/// The first mode of a beam that is clamped at x = 0, (36) with k l = 1.875.
double mode(double x) {
  const double k = 1.875, y = k * x / length;
  return (std::cos(k) + std::cosh(k)) * (std::cosh(y) - std::cos(y)) +
         (std::sin(k) - std::sinh(k)) * (std::sinh(y) - std::sin(y));
}

struct End {
  double tip, kinetic, elastic, stress;
};
End after_500_steps(EulerianOptions o) {
  o.rereference = 10;
  const Cloud<2> cloud = plate_with_wall();
  Actions<2> actions;
  Held<2> held;
  held.motion = [](const Vec<2>&, int, double) { return HeldMotion{}; };
  for (Index i = 1000; i < cloud.size(); ++i)
    for (int k = 0; k < 2; ++k) held.places.push_back({i, k, cloud.X[i]});
  actions.held.push_back(held);
  auto body = eulerian_body<2>(cloud, o, soft, actions);
  const double speed = 0.05 * body.law().sound_speed();
  auto state = body.start(moving<2>(cloud, [&](const Vec<2>& X) {
    return X[0] < 0 ? Vec<2>(0, 0) : Vec<2>(0, speed * mode(X[0]) / mode(length));
  }));
  for (int n = 0; n < 500; ++n) EXPECT_FALSE(body.advance(state, 2e-5));
  End end{0, 0, 0, state.work.stress};
  for (Index i = 0; i < 1000; ++i)
    if (cloud.X[i][0] > length - spacing) end.tip += (cloud.X[i][1] + state.u[1][i]) / 10;
  for (Index i = 0; i < 1000; ++i)  // that program has the velocities of half a step before
    end.kinetic += 0.5 * body.mass()[i] *
                   (vector_at<2>(state.v, i) - 1e-5 * vector_at<2>(state.acceleration, i)).squaredNorm();
  end.elastic = body.energy(state).strain;
  return end;
}

TEST(EulerianPlate, IsWhereAnotherProgramHasIt) {
  EulerianOptions undamped;
  undamped.damping = "none";
  const End adjoint = after_500_steps(undamped), printed = after_500_steps(EulerianOptions::of_paper());
  EXPECT_NEAR(adjoint.tip, 0.0276400283, 1e-9);
  EXPECT_NEAR(adjoint.kinetic, 3.823068771, 1e-7);
  EXPECT_NEAR(adjoint.elastic, 0.238292960, 4e-7);  // by which volume: strains of 1e-6 of it
  EXPECT_NEAR(adjoint.stress, 0.238146, 1e-4);      // that program takes the stress of the end of each step
  EXPECT_NEAR(printed.tip, 0.0276251433, 1e-9);
  EXPECT_NEAR(printed.kinetic, 3.807410595, 1e-7);
  EXPECT_NEAR(printed.elastic, 0.229588230, 4e-7);
  EXPECT_NEAR(printed.stress, 0.229448, 1e-4);
}

}  // namespace
}  // namespace plumb::testing
