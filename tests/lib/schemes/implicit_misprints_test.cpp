// [implicit] misprints: (27), (29) and (61) of paper 004 as they are printed, in the solver itself: what they are the derivative of,
// and what Newton's method makes of them. The ledger (verification/claims) cites these numbers.
#include "lib/schemes/implicit/misprints.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"
#include "tests/lib/schemes/tangent_checks.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

/// Moved particles with supports of their own and the hourglass energy (21).
template <int d>
DiscreteEnergy<d> energy_with(const std::vector<std::string>& misprints, double alpha = 1) {
  Cloud<d> cloud = testing::block<d>(d == 2 ? 6 : 4, Layout::node, 0.2);
  const std::vector<double> radius = testing::varied_radii(cloud);
  ImplicitOptions options;
  options.misprints = misprints;
  const Solid<d> solid =
      testing::dual_body<d>(std::move(cloud), radius, "neo-hookean-logarithmic", testing::rubber, alpha);
  return {with_misprints(stored_energy(solid), options), free_unknowns(d * solid.cloud.size(), {})};
}

/// |K v - dr/ds| / |K v| and the work of the forces over the change of the energy, along a direction that no symmetry spares.
struct Consistency {
  double of_tangent, of_forces;
};
template <int d>
Consistency consistency(const std::vector<std::string>& misprints, double alpha = 1) {
  DiscreteEnergy<d> energy = energy_with<d>(misprints, alpha);
  const VectorXd u = testing::smooth_motion(energy.cloud(), 0.05),
                 v = testing::some_direction<d>(u.size(), 5);
  const double s = 1e-3 * energy.cloud().spacing;
  energy.linearise_at(u);
  const VectorXd Kv = energy.tangent() * v;
  EXPECT_LT((Kv - energy.tangent_times(v)).norm(), 1e-13 * Kv.norm());
  const auto at = [&](double t) { return energy.energy(u + t * s * v); };
  const double slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * s);
  return {(Kv - testing::slope_of_residual(energy, u, v, s)).norm() / Kv.norm(),
          energy.residual(u)->dot(v) / slope};
}

/// Everything mended: K is the derivative of the forces, and they of the energy. Each misprint breaks one of the two, wherever it
/// stands.
TEST(Misprints, EachBreaksADerivative) {
  const auto check = [&]<int d>() {
    const Consistency mended = consistency<d>({});
    EXPECT_LT(mended.of_tangent, 1e-9);
    EXPECT_NEAR(mended.of_forces, 1, 1e-8);  // differences of fourth order of an energy near its least value
    const Consistency sign = consistency<d>({"27"}), half = consistency<d>({"29"}),
                      term = consistency<d>({"61"});
    EXPECT_GT(std::abs(sign.of_forces - 1), 0.03);  // 0.044: that share is hourglass energy
    EXPECT_GT(sign.of_tangent, 0.3);                // K stays that of the energy
    EXPECT_GT(half.of_tangent, 0.1);
    EXPECT_NEAR(half.of_forces, mended.of_forces, 1e-12);
    EXPECT_GT(term.of_tangent, 0.04);  // 0.051 and 0.081
    EXPECT_NEAR(term.of_forces, mended.of_forces, 1e-12);
    // without hourglass energy there is nothing that (27) and (29) could break
    EXPECT_LT(consistency<d>({"27", "29"}, 0).of_tangent, 1e-9);
  };
  check.operator()<2>();
  check.operator()<3>();
}

/// (61) at rest: every entry of dP/dF beside those of J_FF is right, and those are off by mu.
TEST(Misprints, TheTangentOf61IsOffByMuAtRest) {
  const auto check = [&]<int d>() {
    const Solid<d> solid = testing::dual_body<d>(testing::block<d>(4, Layout::node, 0),
                                                 std::vector<double>(d == 2 ? 25 : 125, 0.6),
                                                 "neo-hookean-logarithmic", {10, 0.3, 1});
    ImplicitOptions options;
    options.misprints = {"61"};
    const StoredEnergy<d> right = stored_energy(solid), wrong = with_misprints(right, options);
    const Tangent<d> off = wrong.tangent(Mat<d>::Identity(), 0) - right.tangent(Mat<d>::Identity(), 0);
    for (int m = 0; m < d * d; ++m)
      for (int k = 0; k < d * d; ++k) {
        const int a = m / d, A = m % d, b = k / d, B = k % d;
        const double second = (a == A ? 1 : 0) * (b == B ? 1 : 0) - (a == B ? 1 : 0) * (A == b ? 1 : 0);
        EXPECT_NEAR(off(m, k), 10 / 2.6 * second, 1e-13) << m << ' ' << k;
      }
  };
  check.operator()<2>();
  check.operator()<3>();
}

/// The forces of (28) with the printed (27) drive a free lattice apart: of 10 x 10 particles, each of mass 1, E = 1, nu = 0.3, radius
/// 2.05 spacings, another program has -2.348 for the lowest eigenvalue; mended it is 0 three times, for rigid motions.
TEST(Misprints, WithTheSignOf27AFreeLatticeExplodes) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, {10, 10}, Layout::cell);
  const Solid<2> solid =
      testing::dual_body<2>(cloud, std::vector<double>(100, 0.205), "linear-elastic", {1, 0.3, 1}, 1);
  for (const bool as_printed : {true, false}) {
    ImplicitOptions options;
    if (as_printed) options.misprints = {"27"};
    const StoredEnergy<2> energy = with_misprints(stored_energy(solid), options);
    Eigen::MatrixXd K(200, 200);
    for (int n = 0; n < 200; ++n) K.col(n) = 1e3 * *energy.residual(1e-3 * VectorXd::Unit(200, n));  // linear
    const VectorXd found =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
    if (as_printed) {
      EXPECT_NEAR(found[0], -2.348, 5e-4);
    } else {
      EXPECT_LT(found.head(3).cwiseAbs().maxCoeff(), 1e-12);
      EXPECT_GT(found[3], 1e-3);
    }
  }
}

/// The rubber of 6.5 on 11 x 11 moved particles, pulled by 0.25 mm, the paper's increment, in one load step.
StaticResult<2> rubber_with(const std::vector<std::string>& misprints) {
  const Scene scene = parse_scene(R"([scene]
dimension = 2
end_time = "1 s"
[body]
size = ["2 mm", "2 mm"]
spacing = "0.2 mm"
layout = "node"
jitter = 0.2
[material]
model = "neo-hookean-logarithmic"
young = "0.2 MPa"
poisson = 0.45
density = 1000
[method]
paper = "004"
support = "nearest:12"
[hourglass]
alpha = 5
[[boundary]]
face = "y-"
kind = "clamped"
[[boundary]]
face = "y+"
kind = "displacement"
displacement = ["0", "0.25e-3*t"]
)",
                                  "pulled.toml");
  TlsphBody<2> body = make_tlsph<2>(scene);
  ImplicitOptions options;
  options.steps = 1;
  options.adaptive = false;
  options.tolerance = 1e-11;
  options.misprints = misprints;
  return find_equilibrium<2>(body.solid, body.actions, 1, options, body.state);
}

/// The exponents p of r_(n+1) ~ r_n^p, one for every three residuals that follow each other.
std::vector<double> exponents(const std::vector<double>& r) {
  std::vector<double> found;
  for (std::size_t n = 2; n < r.size(); ++n)
    found.push_back(std::log(r[n] / r[n - 1]) / std::log(r[n - 1] / r[n - 2]));
  return found;
}

/// In the first increment of the paper, 0.25 mm, Newton's method is quadratic once all is mended. With half of a stiffness or without
/// a term it is linear, and with the sign of the forces turned no step lowers the potential.
TEST(Misprints, NewtonsMethodTellsThem) {
  const auto mended = rubber_with({});
  ASSERT_TRUE(mended.completed());
  const auto quadratic = exponents(mended.steps.at(0).newton.residuals);  // 0.41, 4.8e-3, 6.2e-7, 1.9e-14
  ASSERT_GE(quadratic.size(), 2u);
  EXPECT_GT(quadratic[0], 1.8);
  EXPECT_GT(quadratic[1], 1.8);
  for (const char* equation : {"29", "61"}) {
    const auto wrong = rubber_with({equation});
    ASSERT_FALSE(wrong.completed()) << equation;
    const auto& r = wrong.failure->residuals;
    EXPECT_EQ(r.size(), 41u) << equation;  // all that are allowed
    EXPECT_NEAR(exponents(r).back(), 1, 0.1) << equation;
    EXPECT_GT(r.back() / r[r.size() - 2], 0.5) << equation;  // 0.95 and 0.64
  }
  const auto driven = rubber_with({"27"});
  ASSERT_FALSE(driven.completed());
  EXPECT_EQ(driven.failure->residuals.size(), 1u);
}

}  // namespace
}  // namespace plumb
