// Static cases with closed forms or published numbers, from the scenes: bonds and elements.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "places.hpp"

namespace plumb {
namespace {

const std::string scenes = PLUMBLINE_SOURCE_DIR "/verification/scenes/";
using Sets = std::vector<std::string>;

struct Found2 {
  Snapshot<2> shown;
  Energy energy;
};
struct Found3 {
  Snapshot<3> shown;
  Energy energy;
};

template <int d, class Found>
Found equilibrium(const std::string& file, const Sets& set) {
  auto simulation = make_simulation<d>(read_scene(scenes + file, set)).simulation;
  RunRecord history;
  EXPECT_TRUE(run<d>(simulation, {}, history).completed()) << file;
  return {simulation.snapshot(), simulation.energy()};
}
Found2 in_plane(const std::string& file, const Sets& set = {}) {
  return equilibrium<2, Found2>(file, set);
}
Found3 in_space(const std::string& file, const Sets& set = {}) {
  return equilibrium<3, Found3>(file, set);
}

template <int d>
Vec<d> displacement_at(const Snapshot<d>& shown, const Vec<d>& X) {
  for (std::size_t i = 0; i < shown.X.size(); ++i)
    if ((shown.X[i] - X).norm() < 1e-6) return shown.u[i];
  ADD_FAILURE() << "no particle at " << X.transpose();
  return Vec<d>::Zero();
}

/// Relative error in L2 of the displacement over all particles.
template <int d, class Exact>
double error_of(const Snapshot<d>& shown, Exact&& exact) {
  double error = 0, size = 0;
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    const Vec<d> u = exact(shown.X[i]);
    error += shown.mass[i] * (shown.u[i] - u).squaredNorm();
    size += shown.mass[i] * u.squaredNorm();
  }
  return std::sqrt(error / size);
}

const Sets quadratic{"method.scheme=element", "element.solve=newton", "element.order=quadratic"};
const Sets linear{"method.scheme=element", "element.solve=newton"};
const Sets reduced{"method.scheme=element", "element.solve=newton", "element.order=reduced"};
const Sets compatible{"method.gradient=compatible"};

TEST(Statics, CooksMembrane) {
  const Snapshot<2> strain = in_plane("cook-membrane.toml").shown;
  // corner: 32.27 mm of CalculiX; singular at the clamped corner, 16 to 22 cells along the sides
  EXPECT_NEAR(displacement_at<2>(strain, {0.048, 0.060})[1], 32.27e-3, 0.02 * 32.27e-3);
  const Snapshot<2> stress = in_plane("cook-membrane.toml", {"material.plane=stress"}).shown;
  EXPECT_NEAR(displacement_at<2>(stress, {0.048, 0.052})[1], 23.96e-3 / 0.7, 0.02 * 23.96e-3 / 0.7);
}

TEST(Statics, BarUnderItsWeight) {
  const auto exact = [](const Vec<2>& X) -> Vec<2> {
    return {0, -1100 * 9.81 / (2 * 17e6) * (1 - X[1] * X[1])};
  };
  EXPECT_LT(error_of(in_plane("weighing-bar.toml", quadratic).shown, exact), 1e-12);  // a parabola
  EXPECT_LT(error_of(in_plane("weighing-bar.toml", linear).shown, exact), 1e-12);  // nodal values are exact
  const double coarse = error_of(in_plane("weighing-bar.toml", compatible).shown, exact);
  EXPECT_LT(coarse, 0.005);
}

TEST(Statics, LamesRing) {
  const auto exact = [](const Vec<2>& X) -> Vec<2> {
    return 1.3 * 1e3 / (1e9 * 3) * (0.4 + 4 / X.squaredNorm()) * X;
  };
  const double coarse = error_of(in_plane("lame-ring.toml").shown, exact),
               fine = error_of(in_plane("lame-ring.toml", {"body.spacing=0.05"}).shown, exact);
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(fine, 0.5 * coarse);  // second order, on irregular clouds
}

TEST(Statics, KirschsPlate) {
  const auto exact = [](const Vec<2>& X) -> Vec<2> {
    const double G = 1e9 / 2.6, k = (3 - 0.3) / 1.3, r = X.norm(), t = std::atan2(X[1], X[0]);
    const double scale = 1e3 / (8 * G);
    return {scale * (r * (k + 1) * std::cos(t) + 2 / r * ((1 + k) * std::cos(t) + std::cos(3 * t)) -
                     2 / std::pow(r, 3) * std::cos(3 * t)),
            scale * (r * (k - 3) * std::sin(t) + 2 / r * ((1 - k) * std::sin(t) + std::sin(3 * t)) -
                     2 / std::pow(r, 3) * std::sin(3 * t))};
  };
  EXPECT_NEAR(exact({1, 0})[0], 3e-6, 1e-18);
  EXPECT_NEAR(exact({0, 1})[1], -1e-6, 1e-18);
  const double coarse = error_of(in_plane("kirsch-plate.toml").shown, exact);
  const Snapshot<2> shown = in_plane("kirsch-plate.toml", {"body.spacing=0.1"}).shown;
  EXPECT_LT(coarse, 0.02);
  EXPECT_LT(error_of(shown, exact), 0.5 * coarse);
  double most = 0;
  for (std::size_t i = 0; i < shown.X.size(); ++i) most = std::max(most, shown.cauchy[i](0, 0));
  EXPECT_NEAR(most, 3e3, 0.1 * 3e3);  // of first order at an edge, 10 cells along the radius
}

/// Paper 004, 6.3: compatible bonds and elements pass the patch test, kernels without correction do not.
TEST(Statics, PulledRod) {
  for (const Sets& set : {compatible, quadratic, linear, reduced}) {
    const Found3 found = in_space("pulled-rod.toml", set);
    EXPECT_NEAR(found.energy.strain, 800, 1e-8 * 800) << set[0];
    EXPECT_NEAR(displacement_at<3>(found.shown, {8, 3, 2})[0], 8e6 / 30e9, 1e-8 * 8e6 / 30e9);
  }
  const double of_paper = in_space("pulled-rod.toml", {"method.paper=\"004\""}).energy.strain;
  EXPECT_GT(of_paper, 801);
  EXPECT_LT(of_paper, 820);
}

/// Beam theory in plane stress, which is 0.02 % from the body's own answer at the tip.
TEST(Statics, Cantilever) {
  const auto exact = [](const Vec<3>& X) -> Vec<3> {
    const double c = 1000 / (6 * 30e9 * 2.25), x = X[0], y = X[1], nu = 0.3;
    return {-c * y * ((48 - 3 * x) * x + (2 + nu) * (y * y - 2.25)),
            c * (3 * nu * y * y * (8 - x) + (4 + 5 * nu) * 9 * x / 4 + (24 - x) * x * x),
            nu * 6 * c * (8 - x) * y * X[2]};
  };
  EXPECT_LT(error_of(in_space("cantilever.toml", quadratic).shown, exact), 0.005);
  EXPECT_LT(error_of(in_space("cantilever.toml", compatible).shown, exact), 0.06);
  EXPECT_LT(error_of(in_space("cantilever.toml", reduced).shown, exact), 0.06);
}

/// Paper 004, 6.6, at half the load: triquadratic elements of 4^3 cells against those of another program,
/// which has 0.13641 m with 10^3 cells.
TEST(Statics, PressedCube) {
  Sets half = quadratic;
  half.push_back("boundary.1.traction=[\"0\",\"0\",\"-1 + (abs(Y - 0.5) < 0.001 ? 0.5 : 0)\"]");
  const Snapshot<3> shown = in_space("pressed-cube.toml", half).shown;
  EXPECT_NEAR(displacement_at<3>(shown, {0, 0, 1})[2], -0.13641, 0.02 * 0.13641);
}

}  // namespace
}  // namespace plumb
