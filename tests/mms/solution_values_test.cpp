// Every solution of the catalogue at stated points and times against its formula, written a second time with
// plain doubles; its domain, period and default parameters. The two derivations that `plumb mms --check`
// compares share the displacement.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mms/manufactured.hpp"

namespace plumb::mms {
namespace {

constexpr double turn = 2 * std::numbers::pi;
const Elastic steel{210e9, 0.3, 7850};
const double mu = 210e9 / 2.6, pressure_speed = std::sqrt((175e9 + 4.0 / 3 * mu) / 7850);

/// u(X, t) with the default parameters.
template <int d>
struct Formula {
  const char* name;
  double period;
  Vec<d> origin, size;
  std::function<Vec<d>(const Vec<d>& X, double t)> u;
};

template <int d>
Vec<d> unit(double x, double y = 0, double z = 0) {
  const double all[] = {x, y, z};
  Vec<d> v;
  for (int k = 0; k < d; ++k) v[k] = all[k];
  return v;
}

template <int d>
Vec<d> affine(const Vec<d>& X, double t) {
  const double g = std::sin(turn * t / 0.05);
  Vec<d> y = X;
  y[0] += g * (0.2 * X[0] + 0.15 * X[1]);
  y[1] -= g * 0.1 * X[1];
  if (d == 3) y[2] += g * (0.2 / 3 * X[2] + 0.075 * X[0]);
  Vec<d> x = y;
  x[0] = std::cos(0.7 * g) * y[0] - std::sin(0.7 * g) * y[1];
  x[1] = std::sin(0.7 * g) * y[0] + std::cos(0.7 * g) * y[1];
  return x - X;
}
template <int d>
Vec<d> rotation(const Vec<d>& X, double t) {
  const double angle = 105 * t, x = X[0] - 0.5, y = X[1] - 0.5;
  return unit<d>(std::cos(angle) * x - std::sin(angle) * y - x,
                 std::sin(angle) * x + std::cos(angle) * y - y);
}
template <int d>
Vec<d> standing(const Vec<d>& X, double t) {
  return unit<d>(0.01 * std::sin(turn / 2 * X[0]) * std::cos(turn / 2 * pressure_speed * t));
}
template <int d>
Vec<d> travelling(const Vec<d>& X, double t) {
  return unit<d>(0.01 * std::sin(turn * (X[0] - pressure_speed * t)));
}
template <int d>
Vec<d> column(const Vec<d>& X, double t) {
  const double g = std::pow(std::sin(turn / 2 * t / 0.2), 2), Z = X[d - 1];
  Vec<d> u = -0.25 * g * std::sin(turn / 8 * Z) * X;
  u[d - 1] = g * (Z + 0.2 * std::sin(turn / 4 * Z));
  return u;
}

template <int d>
Vec<d> driven_bar(const Vec<d>& X, double t) {
  return unit<d>(0.01 * std::sin(2 * X[0]) * std::sin(2 * pressure_speed * t));
}
template <int d>
Vec<d> churchill(const Vec<d>& X, double t) {
  const double x = turn / 4 * X[0], phase = turn / 4 * pressure_speed * t, factor = 32 / (turn * turn);
  return unit<d>(0.01 *
                 (X[0] - factor * (std::sin(x) * std::cos(phase) - std::sin(3 * x) * std::cos(3 * phase) / 9 +
                                   std::sin(5 * x) * std::cos(5 * phase) / 25)));
}
/// In polar coordinates; nu = 0.3, plane strain.
Vec<2> kirsch(const Vec<2>& X, double) {
  const double r = X.norm(), a = std::atan2(X[1], X[0]), k = 3 - 4 * 0.3;
  return 1e-3 / 8 *
         Vec<2>(r * (k + 1) * std::cos(a) + 2 / r * ((1 + k) * std::cos(a) + std::cos(3 * a)) -
                    2 / std::pow(r, 3) * std::cos(3 * a),
                r * (k - 3) * std::sin(a) + 2 / r * ((1 - k) * std::sin(a) + std::sin(3 * a)) -
                    2 / std::pow(r, 3) * std::sin(3 * a));
}
Vec<2> ring(const Vec<2>& X, double) {
  return 1e-3 / 6 * ((1 - 2 * 0.3) + 4 / X.squaredNorm()) * X;
}
/// nu/(1 - nu) = 3/7 in plane strain; P/(6 E I) = 3e-4/(6 x 2 (1 + 3/7) x 27/12).
Vec<2> beam(const Vec<2>& X, double) {
  const double c = 3e-4 / (6 * 2 * (1 + 3 / 7.0) * 27 / 12), nu = 3 / 7.0, x = X[0], y = X[1];
  return c * Vec<2>(-y * ((48 - 3 * x) * x + (2 + nu) * (y * y - 2.25)),
                    3 * nu * y * y * (8 - x) + (4 + 5 * nu) * 9 * x / 4 + (24 - x) * x * x);
}

template <int d>
std::vector<Formula<d>> formulas() {
  const Vec<d> zero = Vec<d>::Zero(), one = Vec<d>::Ones();
  Vec<d> foot = Vec<d>::Constant(-0.5), tall = one;
  foot[d - 1] = 0, tall[d - 1] = 2;
  std::vector<Formula<d>> all = {{"affine-patch", 0.05, zero, one, affine<d>},
                                 {"rigid-rotation", turn / 105, zero, one, rotation<d>},
                                 {"standing-wave", 2 / pressure_speed, zero, one, standing<d>},
                                 {"travelling-wave", 1 / pressure_speed, zero, one, travelling<d>},
                                 {"stretched-column", 0.2, foot, tall, column<d>},
                                 {"loaded-bar", turn / (2 * pressure_speed), zero, one, driven_bar<d>},
                                 {"churchill-bar", 4 / pressure_speed, zero, one, churchill<d>}};
  if constexpr (d == 2) {
    const double w = turn / 4 * std::sqrt(2 * mu / 7850);
    all.push_back({"swinging-plate", turn / w, zero, 2 * one, [w](const Vec<2>& X, double t) {
                     const double a = turn / 4 * X[0], b = turn / 4 * X[1];
                     return Vec<2>(0.01 * std::sin(w * t) *
                                   Vec<2>(-std::sin(a) * std::cos(b), std::cos(a) * std::sin(b)));
                   }});
    all.push_back({"generalized-vortex", 1, -1.25 * one, 2.5 * one, [](const Vec<2>& X, double t) {
                     const double r = X.norm() - 1, h = 1 - 32 * r * r + 256 * r * r * r * r;
                     const double angle = 0.5 * (1 - std::cos(turn * t)) * h, c = std::cos(angle),
                                  s = std::sin(angle);
                     return Vec<2>(c * X[0] - s * X[1] - X[0], s * X[0] + c * X[1] - X[1]);
                   }});
    const double shear_speed = std::sqrt(mu / 7850), swing = turn / 2 * std::sqrt(2 * mu / 7850);
    all.push_back({"lame-mode", turn / swing, zero, one, [swing](const Vec<2>& X, double t) {
                     const double a = turn / 2 * X[0], b = turn / 2 * X[1];
                     return Vec<2>(0.01 * std::sin(swing * t) *
                                   Vec<2>(std::cos(a) * std::sin(b), -std::sin(a) * std::cos(b)));
                   }});
    all.push_back({"kirsch-plate", 1 / shear_speed, -2 * one, 4 * one, kirsch});
    all.push_back({"lame-ring", 1 / shear_speed, -2 * one, 4 * one, ring});
    all.push_back({"plane-cantilever", 8 / shear_speed, Vec<2>(0, -1.5), Vec<2>(8, 3), beam});
  } else {
    const double w = turn / 2 * std::sqrt(3 * mu / 7850);
    all.push_back({"trigonometric-cube", turn / w, zero, one, [w](const Vec<3>& X, double t) {
                     const Vec<3> s = (turn / 2 * X).array().sin(), c = (turn / 2 * X).array().cos();
                     return Vec<3>(
                         0.05 * std::sin(w * t) *
                         Vec<3>(s[0] * c[1] * c[2], -0.6 * c[0] * s[1] * c[2], -0.4 * c[0] * c[1] * s[2]));
                   }});
  }
  return all;
}

template <int d>
void expect_values() {
  const auto all = formulas<d>();
  std::size_t in_dimension = 0;
  for (const auto& entry : solution_list())
    in_dimension += std::count(entry.dimensions.begin(), entry.dimensions.end(), d);
  EXPECT_EQ(all.size(), in_dimension);  // a solution without a formula here
  for (const auto& f : all) {
    const auto m = manufactured<d>(f.name, {}, steel);
    EXPECT_NEAR(m.period, f.period, 1e-14 * f.period) << f.name;
    EXPECT_EQ(m.density, 7850);
    EXPECT_EQ(m.domain.box.origin, f.origin) << f.name;
    EXPECT_EQ(m.domain.box.size, f.size) << f.name;
    for (const Vec<d>& X : {unit<d>(0.21, 0.83, 0.34), unit<d>(0.77, 0.49, 0.92)})
      for (const double share : {0.0, 0.13, 0.41, 0.77}) {
        const double t = share * f.period, step = 1e-4 * f.period;
        const Motion<d> motion = m.motion(X, t);
        const Vec<d> u = f.u(X, t);
        EXPECT_LT((motion.displacement - u).norm(), 1e-14) << f.name;
        // differences of fourth order: 1e-16 of the derivative, rounding 1e-16 over the step
        const auto in_time = [&](double s) { return f.u(X, t + s); };
        const Vec<d> velocity =
            (8 * (in_time(step) - in_time(-step)) - (in_time(2 * step) - in_time(-2 * step))) / (12 * step);
        const Vec<d> acceleration =
            (16 * (in_time(step) + in_time(-step)) - (in_time(2 * step) + in_time(-2 * step)) - 30 * u) /
            (12 * step * step);
        EXPECT_LT((motion.velocity - velocity).norm(), 1e-9 / f.period) << f.name;
        EXPECT_LT((motion.acceleration - acceleration).norm(), 1e-5 / (f.period * f.period)) << f.name;
        for (int b = 0; b < d; ++b) {
          const double h = 1e-4;
          const auto in_space = [&](double s) { return f.u(Vec<d>(X + s * Vec<d>::Unit(b)), t); };
          const Vec<d> slope =
              (8 * (in_space(h) - in_space(-h)) - (in_space(2 * h) - in_space(-2 * h))) / (12 * h);
          EXPECT_LT((motion.F.col(b) - slope - Vec<d>(Vec<d>::Unit(b))).norm(), 1e-10) << f.name;
        }
      }
  }
}

TEST(SolutionValues, AreThoseOfTheirFormulas) {
  expect_values<2>();
  expect_values<3>();
}

/// s = rho u_tt - Div P, by differences of P between neighbouring points.
template <int d>
void expect_body_force() {
  for (const auto& f : formulas<d>()) {
    const auto m = manufactured<d>(f.name, {}, steel);
    const Vec<d> X = unit<d>(0.6, 0.7, 0.35);
    const double t = 0.37 * f.period, h = 1e-3;
    Vec<d> divergence = Vec<d>::Zero();
    for (int b = 0; b < d; ++b) {
      const auto P = [&](double s) {
        return m.first_piola(m.motion(Vec<d>(X + s * Vec<d>::Unit(b)), t).F).col(b).eval();
      };
      divergence += (8 * (P(h) - P(-h)) - (P(2 * h) - P(-2 * h))) / (12 * h);
    }
    const Vec<d> expected = 7850 * m.motion(X, t).acceleration - divergence;
    EXPECT_LT((m.body_force(X, t) - expected).norm(), 1e-6 * (expected.norm() + 1e11))
        << f.name;  // stresses of 1e11 Pa
    const Vec<d> N = unit<d>(0.6, -0.8);
    EXPECT_LT((m.traction(X, t, N) - m.first_piola(m.motion(X, t).F) * N).norm(), 1e-6) << f.name;
  }
}

TEST(SolutionValues, BodyForceBalancesInertiaAndStress) {
  expect_body_force<2>();
  expect_body_force<3>();
}

TEST(Domains, KnowDepthLengthAndWhatTheyContain) {
  const auto box = box_domain<3>(Vec<3>(1, 2, 3), Vec<3>(4, 2, 3), roller);
  EXPECT_EQ(box.length(), 2);
  EXPECT_DOUBLE_EQ(box.depth(Vec<3>(1.5, 3, 4.5)), 0.5);
  EXPECT_NEAR(box.depth(Vec<3>(3, 3, 5.9)), 0.1, 1e-14);
  EXPECT_TRUE(box.contains(Vec<3>(1, 2, 6)) && box.contains(Vec<3>(5, 4, 3)));
  EXPECT_FALSE(box.contains(Vec<3>(0.99, 3, 4)) || box.contains(Vec<3>(3, 4.01, 4)) ||
               box.contains(Vec<3>(3, 3, 2.9)));
  for (const auto& face : box.faces) {
    EXPECT_EQ(face.normal, Known::displacement);
    EXPECT_EQ(face.tangential, Known::traction);
  }
  const auto ring = annulus_domain(0.75, 1.25, held);
  EXPECT_DOUBLE_EQ(ring.length(), 0.5);
  EXPECT_NEAR(ring.depth(Vec<2>(0.6, 0.8)), 0.25, 1e-15);
  EXPECT_NEAR(ring.depth(Vec<2>(0, -0.8)), 0.05, 1e-15);
  EXPECT_NEAR(ring.depth(Vec<2>(1.2, 0)), 0.05, 1e-15);
  EXPECT_TRUE(ring.contains(Vec<2>(0.76, 0)) && ring.contains(Vec<2>(0, -1.24)));
  EXPECT_FALSE(ring.contains(Vec<2>(0.74, 0)) || ring.contains(Vec<2>(0.9, 0.9)));
  EXPECT_EQ(ring.box.origin, Vec<2>(-1.25, -1.25));
  EXPECT_EQ(ring.box.size, Vec<2>(2.5, 2.5));
}

}  // namespace
}  // namespace plumb::mms
