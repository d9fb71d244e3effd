// Paths of one point against closed forms.
#include "lib/scene/material_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

std::string file(const std::string& model, const std::string& path) {
  return "[material]\nyoung = 2.5\npoisson = 0.25\nmodel = \"" + model + "\"\n" +
         path;  // mu 1, lambda 1, kappa 5/3
}
PathRow end_of(const std::string& model, const std::string& path) {
  return follow(parse_material_path(file(model, path), "test.toml")).back();
}

constexpr double rounding = 1e-14;

TEST(MaterialPath, SimpleShearOfEveryLaw) {  // F_12 = g; sigma from the laws by hand
  const std::string path = "[path]\ndeformation = [[1, \"t\"], [0, 1]]\nduration = 0.4\nsteps = 2\n";
  const double g = 0.4;
  const auto expect = [&](const std::string& model, double s11, double s22, double s12) {
    const PathRow row = end_of(model, path);
    EXPECT_NEAR(row.state.cauchy(0, 0), s11, rounding) << model;
    EXPECT_NEAR(row.state.cauchy(1, 1), s22, rounding) << model;
    EXPECT_NEAR(row.state.cauchy(0, 1), s12, rounding) << model;
    EXPECT_NEAR(row.t, 0.4, 0);
    EXPECT_FALSE(row.state.plastic_strain || row.state.iterations || row.state.damage ||
                 row.state.temperature);
  };
  expect("neo-hookean", 2 * g * g / 3, -g * g / 3, g);
  // c1 = .4, c2 = .1: 2 c1 dev b - 2 c2 dev b^-1
  expect("mooney-rivlin", 0.8 * 2 * g * g / 3 + 0.2 * g * g / 3, -0.8 * g * g / 3 - 0.2 * 2 * g * g / 3, g);
  // S = tr E + 2 E with E_12 = g/2, E_22 = g^2/2, sigma = F S F^T
  const double S11 = g * g / 2, S12 = g, S22 = 1.5 * g * g;
  expect("saint-venant-kirchhoff", S11 + 2 * g * S12 + g * g * S22, S22, S12 + g * S22);
  // sigma = P F^T of P = g (e1 e2 + e2 e1)
  expect("linear-elastic", g * g, 0, g);
}

TEST(MaterialPath, UniaxialStrainOfTheKirchhoffLaw) {
  const PathRow row = end_of("saint-venant-kirchhoff", "[path]\ndeformation = [[\"1+t\"]]\nduration = 0.3\n");
  const double E = (1.3 * 1.3 - 1) / 2;  // P = 3 (lambda + 2 mu) E F
  EXPECT_NEAR(row.state.cauchy(0, 0), 1.3 * 3 * E * 1.3 / 1.3, rounding);
  EXPECT_NEAR(row.state.F(1, 1), 1, 0);
}

TEST(MaterialPath, PlaneStressSheetPulledWithItsWidthFree) {
  const PathRow row =
      end_of("neo-hookean", "plane = \"stress\"\n[path]\ndeformation = [[\"1+t\", 0], [0, 1]]\n");
  EXPECT_NEAR(row.state.cauchy(2, 2), 0, rounding);
  EXPECT_LT(row.state.F(2, 2), 1);
}

TEST(MaterialPath, AConstantVelocityGradientIsAnExponential) {
  const PathRow spun = end_of(
      "neo-hookean", "[path]\ngradient = [[0, \"-90 deg/s\"], [\"90 deg/s\", 0]]\nduration = 1\nsteps = 7\n");
  EXPECT_NEAR(spun.state.F(0, 0), 0, rounding);
  EXPECT_NEAR(spun.state.F(1, 0), 1, rounding);
  EXPECT_NEAR(spun.state.equivalent, 0, rounding);  // a rotation has no stress
  const PathRow pulled =
      end_of("neo-hookean", "[path]\ngradient = [[2, 0], [0, -1]]\nduration = 0.5\nsteps = 3\n");
  EXPECT_NEAR(pulled.state.F(0, 0), std::exp(1), 1e-14);
  EXPECT_NEAR(pulled.state.F(1, 1), std::exp(-0.5), 1e-14);
}

TEST(MaterialPath, PiecesFollowEachOther) {
  const std::string two =
      "[[path]]\ndeformation = [[\"1+t\", 0], [0, 1]]\nduration = 0.2\nsteps = 4\n"
      "[[path]]\ngradient = [[0, 1], [0, 0]]\nduration = 0.5\nsteps = 5\n";
  const MaterialPath path = parse_material_path(file("neo-hookean", two), "test.toml");
  const auto rows = follow(path);
  ASSERT_EQ(rows.size(), 10u);  // the start and 4 + 5 increments
  EXPECT_NEAR(rows[4].t, 0.2, 1e-16);
  EXPECT_NEAR(rows[9].t, 0.7, 1e-15);
  EXPECT_NEAR(rows[4].state.F(0, 0), 1.2, 1e-15);
  EXPECT_NEAR(rows[9].state.F(0, 0), 1.2, 1e-15);
  EXPECT_NEAR(rows[9].state.F(0, 1), 0.5, 1e-15);
  EXPECT_EQ(follow(path, 100).size(), 201u);
}

TEST(MaterialPath, PlasticCheckValuesThroughTheFile) {
  const std::string text =
      "[material]\nmodel = \"j2-logarithmic\"\nyoung = \"117 GPa\"\npoisson = 0.35\nyield = \"0.4 GPa\"\n"
      "hardening = \"0.1 GPa\"\n[[path]]\ndeformation = [[1, \"0.1*t\", 0], [0, 1, 0], [0, 0, 1]]\nsteps = "
      "1\n"
      "[[path]]\ndeformation = [[1.02, 0.25, 0], [0, 0.97, 0.01], [0.03, 0, 1.01]]\nsteps = 1\n";
  const auto rows = follow(parse_material_path(text, "test.toml"));
  EXPECT_NEAR(*rows[1].state.plastic_strain, 0.0545920806956853, 1e-14);
  EXPECT_NEAR(*rows[2].state.plastic_strain, 0.147010167531522, 1e-14);
  EXPECT_NEAR(rows[2].state.equivalent, 414701016.753153, 1e-4);
  EXPECT_EQ(*rows[0].state.iterations, 0);
  EXPECT_EQ(*rows[1].state.iterations, 1);
}

TEST(MaterialPath, APointThatIsTurnedInsideOutIsRefusedWithItsTime) {
  const auto path = parse_material_path(
      file("neo-hookean", "[path]\ndeformation = [[\"1-t\", 0], [0, 1]]\nduration = 2\nsteps = 4\n"),
      "test.toml");
  try {
    follow(path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("t = 1 s"), std::string::npos) << error.problem();
  }
}

}  // namespace
}  // namespace plumb
