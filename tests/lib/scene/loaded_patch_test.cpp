// Patch test with tractions: a body that is stretched and turned stays where the tractions P N on all its sides hold it.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "lib/material/point.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb {
namespace {

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

/// A square of 1 m with what `side` says about the sides, by their normals.
template <class Side>
Scene square(const std::string& initial, Side&& side) {
  std::string text = R"([scene]
dimension = 2
max_steps = 200
[body]
size = [1, 1]
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
  for (int axis = 0; axis < 2; ++axis)
    for (const int sign : {-1, 1}) {
      const Vec<2> N = sign * Vec<2>::Unit(axis);
      text += fmt::format("[[boundary]]\nface = \"{}{}\"\n{}", "xy"[axis], sign < 0 ? '-' : '+', side(N));
    }
  return parse_scene(text, "patch.toml");
}

TEST(LoadedPatch, ATurnedBodyStaysWhereItsTractionsHoldIt) {
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
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    // the projection leaves 1e-14 of the stress; 200 steps double it some times
    EXPECT_LT((shown.u[i] - H * shown.X[i]).norm(), 1e-10) << shown.X[i].transpose();
    EXPECT_LT(shown.v[i].norm(), 1e-9) << shown.X[i].transpose();
  }
}

/// A quadrilateral whose sides and corners lie aslant to the lattice in it, loaded on all sides by the tractions of a uniform
/// stress: with exact pieces of its sides, at the corners too, they push it nowhere. (It does not stay undeformed: the compatible
/// boundary vectors of such a cloud are no sums of pieces.)
TEST(LoadedPatch, TractionsOfAPolygonAslantToItsLatticeAreBalanced) {
  const Mat<2> F = deformation(), P = first_piola(F), H = F - Mat<2>::Identity();
  const std::vector<Vec<2>> corners{{0.1, 0}, {1.05, 0.31}, {0.9, 1.2}, {-0.2, 0.7}};
  std::string text = R"([scene]
dimension = 2
max_steps = 100
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
)";
  std::string list;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2> a = corners[k], edge = corners[(k + 1) % corners.size()] - a,
                 N = Vec<2>(edge[1], -edge[0]).normalized();
    const Vec<2> t = P * N;
    list += fmt::format("{}[{:.17g}, {:.17g}]", k > 0 ? ", " : "", a[0], a[1]);
    text += fmt::format(
        "[[boundary]]\nwhere = \"{:.17g}*X + {:.17g}*Y > {:.17g}\"\nkind = \"traction\"\n"
        "traction = [\"{:.17g}\", \"{:.17g}\"]\n",
        N[0], N[1], N.dot(a) - 1e-7, t[0], t[1]);
  }
  text.insert(text.find("spacing = 0.1"), "corners = [" + list + "]\n");
  text += fmt::format("[initial]\ndisplacement = [\"{:.17g}*X + {:.17g}*Y\", \"{:.17g}*X + {:.17g}*Y\"]\n",
                      H(0, 0), H(0, 1), H(1, 0), H(1, 1));
  auto simulation = make_simulation<2>(parse_scene(text, "patch.toml")).simulation;
  RunRecord record;
  ASSERT_TRUE(run<2>(simulation, {}, record).completed());
  const Momentum p = simulation.momentum();
  const double pull = P.norm() * 4 * record.dt.first * 100;  // on sides of about 4 m in all
  // weights of formulas with 17 digits; some 100 pieces and 100 steps
  EXPECT_LT(std::hypot(p.linear[0], p.linear[1]), 1e-11 * pull);
  EXPECT_GT(simulation.energy().kinetic, 0);
}

/// The force of a pressure on one side is p times its length in the turned and stretched body, along its
/// normal there: -p cof F N, whatever the law. The other three sides are free, so that it is all of the force.
TEST(LoadedPatch, APressureOnASidePushesAlongTheNormalOfNow) {
  const Mat<2> F = deformation(), H = F - Mat<2>::Identity();
  const std::string start =
      fmt::format("[initial]\ndisplacement = [\"{:.17g}*X + {:.17g}*Y\", \"{:.17g}*X + {:.17g}*Y\"]\n",
                  H(0, 0), H(0, 1), H(1, 0), H(1, 1));
  const Vec<2> pushed = Vec<2>::UnitX();
  Scene scene = square(start, [&](const Vec<2>& N) {
    return fmt::format("kind = \"pressure\"\npressure = \"{}\"\n", (N - pushed).norm() < 1e-12 ? "3e4" : "0");
  });
  scene.max_steps = 1;
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord record;
  ASSERT_TRUE(run<2>(simulation, {}, record).completed());
  const Momentum p = simulation.momentum();
  const Vec<2> a = F * Vec<2>(1, 0), b = F * Vec<2>(1, 1);  // the ends of the side
  const Vec<2> along = b - a, outward(along[1], -along[0]);
  const Vec<2> force = -3e4 * outward;
  const double dt = simulation.steps.now().time;
  // one step of Verlet: the mean of the forces before and after it, which differ by the motion of a step
  EXPECT_NEAR(p.linear[0], dt * force[0], 0.02 * dt * force.norm());
  EXPECT_NEAR(p.linear[1], dt * force[1], 0.02 * dt * force.norm());
}

}  // namespace
}  // namespace plumb
