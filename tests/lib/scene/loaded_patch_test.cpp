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

/// "1.2*X + 0.1*Y" of a row.
template <int d>
std::string product(const Eigen::Matrix<double, 1, d>& row) {
  std::string text;
  for (int k = 0; k < d; ++k) text += fmt::format("{}{:.17g}*{}", k > 0 ? " + " : "", row[k], "XYZ"[k]);
  return text;
}

/// A body that begins with that displacement gradient, with the tractions P N on the sides where N . X is larger than `beyond`.
template <int d>
struct LoadedSide {
  Vec<d> normal;
  double beyond;
};
template <int d>
std::string loaded(const std::string& body, const Mat<d>& F, const Mat<d>& P,
                   const std::vector<LoadedSide<d>>& sides) {
  const Mat<d> H = F - Mat<d>::Identity();
  std::string text =
      fmt::format("[scene]\ndimension = {}\nmax_steps = 100\n[body]\nspacing = 0.1\n{}", d, body) +
      "[material]\nmodel = \"neo-hookean\"\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n"
      "[method]\ngradient = \"compatible\"\nmomentum = \"adjoint\"\ncfl = 0.5\n[initial]\ndisplacement = [";
  for (int k = 0; k < d; ++k) text += fmt::format("{}\"{}\"", k > 0 ? ", " : "", product<d>(H.row(k)));
  text += "]\n";
  for (const auto& side : sides) {
    const Vec<d> t = P * side.normal;
    text += fmt::format("[[boundary]]\nwhere = \"{} > {:.17g}\"\nkind = \"traction\"\ntraction = [",
                        product<d>(side.normal.transpose()), side.beyond);
    for (int k = 0; k < d; ++k) text += fmt::format("{}\"{:.17g}\"", k > 0 ? ", " : "", t[k]);
    text += "]\n";
  }
  return text;
}

template <int d>
void expect_at_rest(const std::string& text, const Mat<d>& F, const Mat<d>& P) {
  auto simulation = make_simulation<d>(parse_scene(text, "patch.toml")).simulation;
  RunRecord record;
  ASSERT_TRUE(run<d>(simulation, {}, record).completed()) << text;
  const Momentum p = simulation.momentum();
  const double pull = P.norm() * 6 * record.dt.first * 100;  // on sides of at most 6 m^(d-1) in all
  // weights of formulas with 17 digits; some 100 pieces and 100 steps
  EXPECT_LT(std::hypot(p.linear[0], p.linear[1]), 1e-11 * pull);
  const Snapshot<d> shown = simulation.snapshot();
  double apart = 0, fastest = 0;
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    apart = std::max(apart, (shown.u[i] - (F - Mat<d>::Identity()) * shown.X[i]).norm());
    fastest = std::max(fastest, shown.v[i].norm());
  }
  // the projection leaves 1e-12 of the stress; 100 steps double it some times
  EXPECT_LT(apart, 1e-10) << text.substr(0, 120);
  EXPECT_LT(fastest, 1e-8) << text.substr(0, 120);
}

/// A quadrilateral whose sides and corners lie aslant to the lattice in it, loaded on all sides by the tractions of a uniform
/// stress, stays as it is: the particles near a side share its load as they share its area in the compatible table. One side has
/// two boundaries.
TEST(LoadedPatch, APolygonAslantToItsLatticeStaysWhereItsTractionsHoldIt) {
  const Mat<2> F = deformation(), P = first_piola(F);
  const std::vector<Vec<2>> corners{{0.1, 0}, {1.05, 0.31}, {0.9, 1.2}, {-0.2, 0.7}};
  std::string list;
  std::vector<LoadedSide<2>> sides;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2> a = corners[k], edge = corners[(k + 1) % corners.size()] - a,
                 N = Vec<2>(edge[1], -edge[0]).normalized();
    list += fmt::format("{}[{:.17g}, {:.17g}]", k > 0 ? ", " : "", a[0], a[1]);
    sides.push_back({N, N.dot(a) - 1e-7});
  }
  const std::string body = "shape = \"polygon\"\ncorners = [" + list + "]\nlayout = ";
  std::string text = loaded<2>(body + "\"node\"\n", F, P, sides);
  const std::size_t last = text.rfind("[[boundary]]");  // that side again, each for a half of it
  const std::string side = text.substr(last),
                    condition = side.substr(side.find("\"") + 1, side.find(" >") - side.find("\"") - 1);
  text.erase(last);
  for (const char* half : {"Y - 0.4", "0.4 - Y"}) {
    std::string part = side;
    const std::size_t from = part.find("\"") + 1;
    text += part.replace(from, part.find("\"", from) - from,
                         fmt::format("min({} - ({:.17g}), {}) > 0", condition, sides.back().beyond, half));
  }
  expect_at_rest<2>(text, F, P);
  expect_at_rest<2>(loaded<2>(body + "\"node\"\ncloud = \"blue-noise\"\n", F, P, sides), F, P);
}

/// Boxes of particles that lie on no lattice, in 2D and 3D.
TEST(LoadedPatch, BoxesOfIrregularParticlesStayWhereTheirTractionsHoldThem) {
  const Mat<2> F = deformation(), P = first_piola(F);
  const std::vector<LoadedSide<2>> faces{
      {{1, 0}, 1 - 1e-7}, {{-1, 0}, -1e-7}, {{0, 1}, 1 - 1e-7}, {{0, -1}, -1e-7}};
  for (const char* cloud :
       {"layout = \"node\"\njitter = 0.3\n", "layout = \"node\"\ncloud = \"blue-noise\"\n"})
    expect_at_rest<2>(loaded<2>(std::string("size = [1, 1]\n") + cloud, F, P, faces), F, P);
  Mat<3> F3 = Mat<3>::Identity();
  F3 << 1.1, 0.2, 0, -0.1, 0.9, 0.05, 0.1, 0, 1.05;
  const Mat<3> cauchy = make_point(LawChoice("neo-hookean"), {1e6, 0.3, 1000})(F3).cauchy,
               P3 = F3.determinant() * cauchy * F3.inverse().transpose();
  std::vector<LoadedSide<3>> sides;
  for (int k = 0; k < 3; ++k) {
    sides.push_back({Vec<3>::Unit(k), 0.5 - 1e-7});
    sides.push_back({-Vec<3>::Unit(k), -1e-7});
  }
  expect_at_rest<3>(loaded<3>("size = [0.5, 0.5, 0.5]\nlayout = \"node\"\njitter = 0.2\n", F3, P3, sides), F3,
                    P3);
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
