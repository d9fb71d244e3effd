// Loads and prescribed motion of scenes: what they do, against mechanics, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/input/scene_error.hpp"
#include "lib/scene/held_motion.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb::loads_scene_test {
namespace {

const std::string square = R"(
[scene]
dimension = 2
end_time = "2 ms"
[body]
size = [1, 1]
spacing = 0.2
layout = "node"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
cfl = 0.02
)";

/// The scene run to its end.
TlsphBody<2> after(const std::string& more) {
  TlsphBody<2> s = make_tlsph<2>(parse_scene(square + more, "loads.toml"));
  EXPECT_TRUE(run<2>(s.solid, s.state, s.integrator, s.control).completed());
  return s;
}

Vec<2> displacement(const TlsphBody<2>& s, Index i) {
  return vector_at<2>(s.state.u, s.solid.bonds.slots.of(i));
}

TEST(LoadsOfAScene, GravityActsOnTheMassWithItsRamp) {
  const TlsphBody<2> s = after("[load]\ngravity = [0, \"-9.81 m/s^2\"]\nramp = \"1 ms\"\n");
  // half of the ramp's time is lost: the integral of 10 s^3 - 15 s^4 + 6 s^5 over 0 to 1 is 1/2
  const Momentum p = momentum_of(s.solid, s.state);
  // Verlet's trapezoidal rule on some 70 steps, an error of (dt/ramp)^2 and less
  EXPECT_NEAR(p.linear[1], -1100 * 9.81 * 1.5e-3, 1e-3 * 1100 * 9.81 * 1.5e-3);
  EXPECT_NEAR(p.linear[0], 0, 1e-12);
}

TEST(LoadsOfAScene, ABodyForceIsPerVolumeAndMayDependOnPlaceAndTime) {
  const TlsphBody<2> s = after("[load]\nbody_force = [\"1e4*X\", \"1e7*t\"]\n");
  const Momentum p = momentum_of(s.solid, s.state);
  EXPECT_NEAR(p.linear[0], 0.5e4 * 2e-3, 1e-11);      // the integral of X over the square is 1/2
  EXPECT_NEAR(p.linear[1], 0.5 * 1e7 * 4e-6, 1e-11);  // the trapezoidal rule is exact for t
}

TEST(LoadsOfAScene, ATractionAndAPressureLoadTheirFace) {
  const TlsphBody<2> s = after(
      "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"1 kPa\", \"2e6*t\"]\n"
      "[[boundary]]\nwhere = \"Y < 1e-9 && X < 0.5\"\nkind = \"pressure\"\npressure = \"1 kPa\"\n");
  const Momentum p = momentum_of(s.solid, s.state);
  EXPECT_NEAR(p.linear[0], 1e3 * 2e-3,
              2e-3 * 2e-3 * 1e3);  // the pressure turns with its face: strains of 1e-4
  // pieces of the lower face whose middles lie left of 0.5: 0 to 0.5 m
  EXPECT_NEAR(p.linear[1], 0.5 * 2e6 * 4e-6 + 1e3 * 0.5 * 2e-3, 2e-3 * 5);
}

/// The integral of a ramp over its time is half of that time.
TEST(LoadsOfAScene, APressureAndATractionGrowWithTheirRamps) {
  const TlsphBody<2> s = after(
      "[[boundary]]\nface = \"x+\"\nkind = \"pressure\"\npressure = \"1 kPa\"\nramp = \"1 ms\"\n"
      "[[boundary]]\nface = \"y+\"\nkind = \"traction\"\ntraction = [0, \"1 kPa\"]\nramp = \"2 ms\"\n");
  const Momentum p = momentum_of(s.solid, s.state);
  // Verlet's trapezoidal rule on some 70 steps, and a face that turns by strains of 1e-4
  EXPECT_NEAR(p.linear[0], -1e3 * 1.5e-3, 2e-3 * 1.5);
  EXPECT_NEAR(p.linear[1], 1e3 * 1e-3, 2e-3 * 1);
}

TEST(LoadsOfAScene, APrescribedDisplacementIsThereAtTheEnd) {
  const TlsphBody<2> s = after(
      "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n"
      "[[boundary]]\nface = \"x+\"\nkind = \"displacement\"\ndisplacement = [\"0.01*sin(500*t)\", "
      "\"0.002*Y*t/0.002\"]\n");
  for (Index i = 0; i < s.solid.cloud.size(); ++i) {
    const Vec<2>& X = s.solid.cloud.X[i];
    if (X[0] > 1 - 1e-9) {
      EXPECT_DOUBLE_EQ(displacement(s, i)[0], 0.01 * std::sin(500 * s.state.time));
      EXPECT_DOUBLE_EQ(displacement(s, i)[1], 0.002 * X[1] * s.state.time / 0.002);
    }
    if (X[0] < 1e-9) {
      EXPECT_EQ(displacement(s, i).norm(), 0);
    }
  }
}

TEST(LoadsOfAScene, APrescribedVelocityMayDependOnTime) {
  const TlsphBody<2> s =
      after("[[boundary]]\nface = \"x+\"\nkind = \"velocity\"\nvelocity = [\"3*cos(500*t)\", 0]\n");
  for (Index i = 0; i < s.solid.cloud.size(); ++i)
    if (s.solid.cloud.X[i][0] > 1 - 1e-9) {
      EXPECT_DOUBLE_EQ(s.state.v[0][s.solid.bonds.slots.of(i)], 3 * std::cos(500 * s.state.time));
      // Verlet's displacement of a given velocity: the midpoint rule, (w dt)^2/24 of it
      EXPECT_NEAR(displacement(s, i)[0], 3 / 500.0 * std::sin(500 * s.state.time), 3 / 500.0 * 2e-3);
    }
}

TEST(LoadsOfAScene, DampingTakesMomentumByItsRate) {
  const TlsphBody<2> s = after("[initial]\nvelocity = [2, 0]\n[damping]\nrate = 100\n");
  // a rigid motion: v' = -c v. Verlet reads the velocity half a step before: an error of c^2 t dt/2 = 3e-4
  EXPECT_NEAR(momentum_of(s.solid, s.state).linear[0], 2200 * std::exp(-100 * 2e-3), 2200 * 5e-4);
}

TEST(LoadsOfAScene, AnInitialDisplacementIsTaken) {
  TlsphBody<2> s =
      make_tlsph<2>(parse_scene(square + "[initial]\ndisplacement = [\"0.01*X\", \"0.02*X*Y\"]\n", "s"));
  for (Index i = 0; i < s.solid.cloud.size(); ++i) {
    const Vec<2>& X = s.solid.cloud.X[i];
    EXPECT_LT((displacement(s, i) - Vec<2>(0.01 * X[0], 0.02 * X[0] * X[1])).norm(), 1e-16);
  }
}

TEST(HeldMotion, RatesOfFormulasAreThoseOfTheirDerivatives) {
  Boundary boundary;
  boundary.kind = BoundaryKind::displacement;
  boundary.displacement = {Expression("X*sin(30*t)", 2, "", Variables::space_and_time), Expression("0", 2)};
  for (const double t : {0.0, 1e-4, 0.013, 0.1}) {
    const HeldMotion m = prescribed_motion(boundary, {2, 0, 0}, 0, t, 0.1);
    EXPECT_DOUBLE_EQ(*m.displacement, 2 * std::sin(30 * t));
    EXPECT_NEAR(m.velocity, 60 * std::cos(30 * t), 60 * 1e-6);  // adaptive differences: 1e-9 and better
    EXPECT_NEAR(m.acceleration, -1800 * std::sin(30 * t), 1800 * 1e-3);  // differences of differences
  }
}

TEST(LoadsOfAScene, ContradictionsAreRefused) {
  const auto problem_of = [](const std::string& more) -> std::string {
    try {
      make_tlsph<2>(parse_scene(square + more, "loads.toml"));
    } catch (const InputError& error) {
      return error.problem();
    }
    return "";
  };
  EXPECT_NE(problem_of("[[boundary]]\nface = \"x+\"\nkind = \"traction\"\npressure = 1\n"), "");
  EXPECT_NE(problem_of("[[boundary]]\nface = \"x+\"\nkind = \"clamped\"\nramp = 1\n"), "");
  EXPECT_NE(problem_of("[load]\nramp = 1\n"), "");
  EXPECT_NE(problem_of("[[boundary]]\nwhere = \"X > 2\"\nkind = \"pressure\"\npressure = 1\n"), "");
  EXPECT_NE(problem_of("[initial]\nvelocity = [\"t\", 0]\n"), "");
  EXPECT_NE(
      problem_of("[[boundary]]\nface = \"x+\"\nkind = \"velocity\"\nvelocity = [1, 0]\n"
                 "[[boundary]]\nwhere = \"X > 0.9\"\nkind = \"displacement\"\ndisplacement = [\"2*t\", 0]\n"),
      "");
  EXPECT_EQ(problem_of("[[boundary]]\nface = \"x+\"\nkind = \"roller\"\n"
                       "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [0, 5]\n"),
            "");
}

}  // namespace
}  // namespace plumb::loads_scene_test
