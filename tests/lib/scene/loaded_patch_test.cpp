// Patch test with tractions: a body that stands aslant to its lattice, stretched and turned, stays where the
// tractions P N on all its sides hold it.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "lib/material/point.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb {
namespace {

/// A square of 1 m, turned by 0.5 rad about the origin.
const double c = std::cos(0.5), s = std::sin(0.5);

Vec<2> turned(double x, double y) {
  return {c * x - s * y, s * x + c * y};
}

std::string point(const Vec<2>& X) {
  return fmt::format("[{:.17g}, {:.17g}]", X[0], X[1]);
}

/// Stretched, sheared and turned by 0.7 rad.
Mat<2> deformation() {
  Mat<2> U, R;
  U << 1.2, 0.1, 0.1, 0.85;
  R << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  return R * U;
}

Mat<2> first_piola(const Mat<2>& F) {
  Mat<3> in_space = Mat<3>::Identity();
  in_space.topLeftCorner<2, 2>() = F;
  const Mat<3> cauchy = make_point(LawChoice("neo-hookean"), {1e6, 0.3, 1000})(in_space).cauchy;
  return (in_space.determinant() * cauchy * in_space.inverse().transpose()).topLeftCorner<2, 2>();
}

/// The square with what `side` says about the sides, by their normals in the frame of the square.
template <class Side>
Scene square(const std::string& initial, Side&& side) {
  std::string text = R"([scene]
dimension = 2
max_steps = 200
[body]
shape = "polygon"
spacing = 0.1
layout = "node"
[material]
model = "neo-hookean"
young = 1e6
poisson = 0.3
density = 1000
[method]
gradient = "compatible"
momentum = "adjoint"
cfl = 0.5
)" + initial;
  const std::string corners = fmt::format("corners = [{}, {}, {}, {}]\n", point(turned(0, 0)),
                                          point(turned(1, 0)), point(turned(1, 1)), point(turned(0, 1)));
  text.insert(text.find("spacing"), corners);
  for (int axis = 0; axis < 2; ++axis)
    for (const double end : {0.0, 1.0}) {
      const Vec<2> N = turned(axis == 0 ? 2 * end - 1 : 0, axis == 1 ? 2 * end - 1 : 0);
      text += fmt::format("[[boundary]]\nwhere = \"{:.17g}*X + {:.17g}*Y > {:.17g}\"\n{}", N[0], N[1],
                          end - 1e-6, side(N));
    }
  return parse_scene(text, "patch.toml");
}

TEST(LoadedPatch, ABodyAslantStaysWhereItsTractionsHoldIt) {
  const Mat<2> F = deformation(), P = first_piola(F), H = F - Mat<2>::Identity();
  const std::string start =
      fmt::format("[initial]\ndisplacement = [\"{:.17g}*X + {:.17g}*Y\", \"{:.17g}*X + {:.17g}*Y\"]\n",
                  H(0, 0), H(0, 1), H(1, 0), H(1, 1));
  auto simulation =
      make_simulation<2>(square(start, [&](const Vec<2>& N) {
        const Vec<2> t = P * N;
        return fmt::format("kind = \"traction\"\ntraction = [\"{:.17g}\", \"{:.17g}\"]\n", t[0], t[1]);
      })).simulation;
  RunRecord record;
  ASSERT_TRUE(run<2>(simulation, {}, record).completed());
  const Snapshot<2> shown = simulation.snapshot();
  double weight = 0;
  for (const double mass : shown.mass) weight += mass;
  EXPECT_NEAR(weight, 1000, 1e-9);  // the cells fill the square
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    // the projection leaves 1e-14 of the stress; 200 steps double it some times
    EXPECT_LT((shown.u[i] - H * shown.X[i]).norm(), 1e-10) << shown.X[i].transpose();
    EXPECT_LT(shown.v[i].norm(), 1e-9) << shown.X[i].transpose();
  }
}

/// The force of a pressure on one side is p times its length in the turned and stretched body, along its
/// normal there: -p cof F N, whatever the law. The other three sides are free, so that it is all of the force.
TEST(LoadedPatch, APressureOnASideAslantPushesAlongTheNormalOfNow) {
  const Mat<2> F = deformation(), H = F - Mat<2>::Identity();
  const std::string start =
      fmt::format("[initial]\ndisplacement = [\"{:.17g}*X + {:.17g}*Y\", \"{:.17g}*X + {:.17g}*Y\"]\n",
                  H(0, 0), H(0, 1), H(1, 0), H(1, 1));
  const Vec<2> pushed = turned(1, 0);
  Scene scene = square(start, [&](const Vec<2>& N) {
    return fmt::format("kind = \"pressure\"\npressure = \"{}\"\n", (N - pushed).norm() < 1e-12 ? "3e4" : "0");
  });
  scene.max_steps = 1;
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord record;
  ASSERT_TRUE(run<2>(simulation, {}, record).completed());
  const Momentum p = simulation.momentum();
  const Vec<2> a = F * turned(0, 0), b = F * turned(0, 1);  // the side's direction: from (1, 0) to (1, 1)
  const Vec<2> along = b - a, outward(along[1], -along[0]);
  const Vec<2> force = -3e4 * outward;
  const double dt = simulation.steps.now().time;
  // one step of Verlet: the mean of the forces before and after it, which differ by the motion of a step
  EXPECT_NEAR(p.linear[0], dt * force[0], 0.02 * dt * force.norm());
  EXPECT_NEAR(p.linear[1], dt * force[1], 0.02 * dt * force.norm());
}

}  // namespace
}  // namespace plumb
