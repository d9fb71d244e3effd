// Solutions with loads: what linear elasticity says about them, for every Poisson's ratio, in plane strain and
// plane stress. They need no body force; free edges are free; loads are those of the closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lib/scene/study.hpp"
#include "mms/annulus.hpp"
#include "mms/manufactured.hpp"
#include "mms/static_study.hpp"
#include "mms/static_surface.hpp"

namespace plumb::mms::loaded_solutions_test {
namespace {

struct Case {
  Elastic elastic;
  Plane plane;
  double modulus() const { return elastic.lame() + 2 * elastic.shear_modulus(); }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double poisson : {0.0, 0.3, 0.45})
    for (const Plane plane : {Plane::strain, Plane::stress}) all.push_back({{2e9, poisson, 1300}, plane});
  return all;
}

Manufactured<2> field(const std::string& name, const Case& of) {
  return manufactured<2>(name, {}, of.elastic, LawChoice("linear-elastic", {}, of.plane));
}

/// Points of the body and times, drawn anew.
template <class Use>
void at_random(const Manufactured<2>& m, Use&& use) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int k = 0; k < 50; ++k) {
    const Vec<2> X =
        m.domain.box.origin + Vec<2>(uniform(random), uniform(random)).cwiseProduct(m.domain.box.size);
    if (m.domain.contains(X)) use(X, uniform(random) * m.period);
  }
}

TEST(LoadedSolutions, NeedNoBodyForceInLinearElasticity) {
  for (const char* name :
       {"lame-mode", "loaded-bar", "churchill-bar", "kirsch-plate", "lame-ring", "plane-cantilever"})
    for (const Case& of : cases()) {
      const Manufactured<2> m = field(name, of);
      at_random(m, [&](const Vec<2>& X, double t) {
        const Motion<2> motion = m.motion(X, t);
        double bend = 0;
        for (const auto& part : motion.dF) bend += part.norm();
        EXPECT_LT(m.body_force(X, t).norm(), 1e-12 * of.modulus() * (bend + 1e-6))
            << name << " nu " << of.elastic.poisson;
      });
    }
}

TEST(LoadedSolutions, LamesModeIsFreeOnAllEdges) {
  for (const Case& of : cases()) {
    const Manufactured<2> m = field("lame-mode", of);
    at_random(m, [&](const Vec<2>& X, double t) {
      for (int axis = 0; axis < 2; ++axis)
        for (const double side : {0.0, 1.0}) {
          Vec<2> at = X, N = Vec<2>::Zero();
          at[axis] = side;
          N[axis] = 2 * side - 1;
          EXPECT_LT(m.traction(at, t, N).norm(), 1e-12 * of.elastic.young);
        }
    });
    EXPECT_GT(m.traction({0.5, 0.5}, m.period / 4, {1, 0}).norm(), 0.01 * of.elastic.young);
  }
}

TEST(LoadedSolutions, BarsAreHeldAtOneEndAndLoadedAtTheOther) {
  for (const Case& of : cases()) {
    const Elastic effective = in_dimension(2, of.elastic, of.plane);
    const double modulus = effective.lame() + 2 * effective.shear_modulus();
    const Manufactured<2> wave = field("loaded-bar", of), churchill = field("churchill-bar", of);
    at_random(wave, [&](const Vec<2>& X, double t) {
      for (const auto* m : {&wave, &churchill}) EXPECT_LT(m->displacement({0, X[1]}, t).norm(), 1e-17);
      const double stress = modulus * 0.02 * std::cos(2.0) * std::sin(2 * M_PI * t / wave.period);
      EXPECT_NEAR(wave.traction({1, X[1]}, t, {1, 0})[0], stress, 1e-12 * modulus);
      EXPECT_NEAR(churchill.traction({1, X[1]}, t, {1, 0})[0], 0.01 * modulus, 1e-13 * modulus);
    });
    // a quarter of the period later the wave has come back from the held end: twice the displacement at rest
    const double back = churchill.displacement({1, 0}, churchill.period / 2)[0];
    EXPECT_NEAR(back, 0.01 * (1 + 8 / (M_PI * M_PI) * (1 + 1 / 9.0 + 1 / 25.0)), 1e-15);
  }
}

TEST(LoadedSolutions, TheHoleIsFreeAndItsStressThreeTimesTheTension) {
  for (const Case& of : cases()) {
    const Manufactured<2> m = field("kirsch-plate", of);
    const double tension = 1e-3 * of.elastic.shear_modulus();
    for (const double angle : {0.0, 0.4, 1.5, 2.6, 4.0}) {
      const Vec<2> N(std::cos(angle), std::sin(angle));
      EXPECT_LT(m.traction(N, 0, N).norm(), 1e-12 * tension * 1e3);
      const Vec<2> around(-N[1], N[0]);  // hoop stress S (1 - 2 cos 2 angle)
      EXPECT_NEAR(m.traction(N, 0, around).dot(around), tension * (1 - 2 * std::cos(2 * angle)),
                  1e-9 * tension);
    }
    EXPECT_NEAR(m.traction({1e4, 0}, 0, {1, 0})[0], tension, 1e-6 * tension);  // far away
  }
}

TEST(LoadedSolutions, ThePressureIsInsideTheRingAndNothingOutside) {
  for (const Case& of : cases()) {
    const Manufactured<2> m = field("lame-ring", of);
    const double pressure = 1e-3 * of.elastic.shear_modulus();
    for (const double angle : {0.0, 0.7, 2.0, 3.9}) {
      const Vec<2> N(std::cos(angle), std::sin(angle));
      EXPECT_LT((m.traction(N, 0, -N) - pressure * N).norm(), 1e-9 * pressure);
      EXPECT_LT(m.traction(2 * N, 0, N).norm(), 1e-9 * pressure);
    }
  }
  // (1 + nu) p a^2/(E (b^2 - a^2)) ((1 - 2 nu) a + b^2/a) at the inner edge, plane strain
  const Elastic e{2e9, 0.3, 1300};
  const Manufactured<2> m = field("lame-ring", {e, Plane::strain});
  EXPECT_NEAR(m.displacement({0, 1}, 0)[1], 1e-3 * e.shear_modulus() * 1.3 / (2e9 * 3) * (0.4 + 4), 1e-17);
}

TEST(LoadedSolutions, TheCantileverHasFreeSidesAndAParabolaAtItsEnd) {
  for (const Case& of : cases()) {
    const Manufactured<2> m = field("plane-cantilever", of);
    const double mean = 1e-4 * of.elastic.shear_modulus();
    for (const double y : {-1.5, -0.4, 0.0, 1.1, 1.5}) {
      const Vec<2> end = m.traction({8, y}, 0, {1, 0});
      EXPECT_NEAR(end[0], 0, 1e-9 * mean);
      EXPECT_NEAR(end[1], 1.5 * mean * (1 - y * y / 2.25), 1e-9 * mean);
    }
    for (const double x : {0.3, 4.0, 7.9})
      for (const double side : {-1.0, 1.0})
        EXPECT_LT(m.traction({x, 1.5 * side}, 0, {0, side}).norm(), 1e-9 * mean);
  }
  // paper 004, 6.4: E = 30 GPa, nu = 0.3, 1000 N on 3 m: the tip rises by 2.77284e-6 m
  const Elastic e{30e9, 0.3, 1000};
  const Manufactured<2> m = field("plane-cantilever", {e, Plane::stress});
  const double share = 1000 / 3.0 / e.shear_modulus() / 1e-4;
  EXPECT_NEAR(share * m.displacement({8, 0}, 0)[1], 2.77284e-6, 5e-12);
}

// A field at rest is no motion, and one that moves without a support is no equilibrium with tractions.
TEST(LoadedSolutions, FieldsAtRestAreNotFollowedInTime) {
  const std::string text = R"(
[study]
name = "ring"
solution = "lame-ring"
spacings = [0.5, 0.25]
periods = 1
quadrature = "nodal"
[body]
origin = [-2, -2]
size = [4, 4]
layout = "node"
[material]
model = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
)";
  for (const char* scheme : {"tlsph", "updated"}) {
    const Study study = parse_study(text + "[method]\nscheme = \"" + scheme + "\"\n", "ring.toml");
    EXPECT_THROW(run_study(study), InputError) << scheme;
  }
}

// The hole of the plate is free and its outer circle is displaced, so that no particle of the hole is prescribed.
TEST(LoadedSolutions, AStaticStudyKnowsTheTwoCirclesApart) {
  const Study study = parse_study(R"(
[study]
name = "static"
solution = "kirsch-plate"
periods = 1
spacings = [0.25, 0.125]
[body]
origin = [-2, -2]
size = [4, 4]
layout = "node"
[material]
model = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
)",
                                  "static.toml", {}, {}, StudyOf::equilibrium);
  const Manufactured<2> m = field("kirsch-plate", {{1e6, 0.3, 1000}, Plane::strain});
  Solid<2> solid;
  const Cloud<2>& cloud = solid.cloud = polar_cloud(1, 2, 0.25);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(2 * cloud.size()), load = u;
  const auto prescribed = surface_conditions<2>(study, m, solid, 0, u, load);
  std::size_t around = 0;
  for (const auto& X : cloud.X) around += std::abs(X.norm() - 2) < 1e-12;
  EXPECT_GT(around, 30u);
  EXPECT_EQ(prescribed.size(), 2 * around);
  for (const Prescribed& one : prescribed)
    EXPECT_NEAR(cloud.X[static_cast<std::size_t>(one.unknown / 2)].norm(), 2, 1e-12);
}

// Two levels are no order, but errors of the sizes that d^2 gives. Without the traction, or with its sign
// turned, the field itself is the error.
TEST(LoadedSolutions, AStaticStudyHasTheTractions) {
  const std::string head = R"(
[study]
name = "static"
periods = 1
spacings = [0.25, 0.125]
)";
  const std::string tail = R"(
layout = "node"
[material]
model = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
[method]
gradient = "compatible"
momentum = "adjoint"
)";
  const auto error = [&](const std::string& solution, const std::string& body) {
    const Study study = parse_study(head + "solution = \"" + solution + "\"\n[body]\n" + body + tail,
                                    "static.toml", {}, {}, StudyOf::equilibrium);
    const StaticResult result = run_static_study(study);
    EXPECT_FALSE(result.levels[1].frequency_error);
    return result.levels[1].relative(&ErrorNorms::l2);
  };
  EXPECT_LT(error("lame-ring", "origin = [-2, -2]\nsize = [4, 4]"), 0.02);
  EXPECT_LT(error("kirsch-plate", "origin = [-2, -2]\nsize = [4, 4]"), 0.02);
  EXPECT_LT(error("plane-cantilever", "origin = [0, -1.5]\nsize = [8, 3]"), 0.02);
}

}  // namespace
}  // namespace plumb::mms::loaded_solutions_test
