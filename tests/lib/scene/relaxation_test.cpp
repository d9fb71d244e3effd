// A body that comes to rest in time, the forces of its supports, and the fields that files can show beside
// the usual ones.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/run/frame.hpp"
#include "lib/run/output_fields.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "tests/support/loadings.hpp"

namespace plumb {
namespace {

/// A block that stands on its lower face; what else it has is added.
Scene block(const std::string& more) {
  return parse_scene(R"([scene]
dimension = 2
end_time = "2 s"
[body]
size = [0.5, 1]
spacing = 0.125
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[[boundary]]
face = "y-"
kind = "clamped"
)" + more,
                     "test.toml");
}

/// Explicit relaxation and the direct solve find the same equilibrium, with the same reactions.
TEST(Relaxation, FindsTheEquilibriumOfTheDirectSolve) {
  for (const auto& [name, text] : testing::loadings) {
    auto rest = make_simulation<2>(block(std::string(text) + "[relaxation]\nresidual = 1e-9\n")).simulation;
    auto direct =
        make_simulation<2>(block(std::string(text) + "[method]\nscheme = \"implicit\"\n")).simulation;
    RunRecord one, other;
    const RunResult result = run<2>(rest, {}, one);
    ASSERT_TRUE(result.completed()) << name;
    ASSERT_TRUE(run<2>(direct, {}, other).completed()) << name;
    EXPECT_LE(*result.residual, 1e-9) << name;
    EXPECT_LT(rest.steps.now().time, 2) << name;
    const Snapshot<2> a = rest.snapshot(), b = direct.snapshot();
    double most = 0;
    for (const auto& u : b.u) most = std::max(most, u.norm());
    ASSERT_GT(most, 0.01) << name;
    for (std::size_t i = 0; i < a.u.size(); ++i)  // the softest motion is some 1e2 times softer than a bond
      EXPECT_NEAR((a.u[i] - b.u[i]).norm(), 0, 1e-6 * most) << name << ' ' << i;
    const auto by_rest = rest.reactions(), by_solve = direct.reactions();
    ASSERT_EQ(by_rest.size(), by_solve.size()) << name;
    double largest = 0;
    for (const auto& reaction : by_solve) largest = std::max(largest, reaction.force.norm());
    for (std::size_t k = 0; k < by_rest.size(); ++k) {
      EXPECT_EQ(by_rest[k].boundary, by_solve[k].boundary) << name;
      EXPECT_NEAR((by_rest[k].force - by_solve[k].force).norm(), 0, 1e-6 * largest) << name << ' ' << k;
    }
  }
}

TEST(Relaxation, TheSupportCarriesTheWeight) {
  auto rest = make_simulation<2>(block("[load]\ngravity = [\"3\", \"-10\"]\n[relaxation]\n")).simulation;
  RunRecord history;
  ASSERT_TRUE(run<2>(rest, {}, history).completed());
  const auto reactions = rest.reactions();
  ASSERT_EQ(reactions.size(), 1u);
  const double mass = 1000 * 0.5;  // of the body; the residual is 1e-8 of the norm of the loads
  EXPECT_NEAR(reactions[0].force[0], -3 * mass, 1e-6 * mass);
  EXPECT_NEAR(reactions[0].force[1], 10 * mass, 1e-6 * mass);
}

/// With velocity Verlet the momentum changes by the mean of the forces before and after a step.
TEST(Reactions, ChangeTheMomentumWithTheLoads) {
  auto falls = make_simulation<2>(block("[load]\ngravity = [\"3\", \"-10*(1 + 5*t)\"]\n")).simulation;
  const auto force = [&] {
    const double mass = 1000 * 0.5, time = falls.steps.now().time;
    return Vec<2>(falls.reactions()[0].force + mass * Vec<2>(3, -10 * (1 + 5 * time)));
  };
  const auto momentum = [&] {
    const auto p = falls.momentum().linear;
    return Vec<2>(p[0], p[1]);
  };
  Vec<2> before = momentum(), at_start = force();
  double time = 0;
  int looked = 0;
  RunRecord history;
  falls.control.end_time = 0.05;
  run<2>(
      falls,
      [&] {
        const double dt = falls.steps.now().time - time;
        if (dt > 0) {
          const Vec<2> now = momentum(), at_end = force();
          // round-off of 45 forces of some 1e3 N/m
          EXPECT_NEAR(((now - before) - dt * (at_start + at_end) / 2).norm(), 0, 1e-10 * dt * 5e3);
          before = now;
          at_start = at_end;
          ++looked;
        }
        time = falls.steps.now().time;
        return true;
      },
      history);
  EXPECT_GT(looked, 20);
  EXPECT_GT(before.norm(), 1);
}

/// A support that is accelerated carries the inertia of its particles: a body that moves as a whole.
TEST(Reactions, AreTheInertiaOfABodyThatIsCarried) {
  const Scene scene = parse_scene(R"([scene]
dimension = 2
end_time = 0.1
[body]
size = [0.5, 1]
spacing = 0.125
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[[boundary]]
where = "Y > -1"
kind = "displacement"
displacement = ["t^2", "3*t^2"]
)",
                                  "test.toml");
  auto carried = make_simulation<2>(scene).simulation;
  RunRecord history;
  ASSERT_TRUE(run<2>(carried, {}, history).completed());
  const auto reactions = carried.reactions();
  ASSERT_EQ(reactions.size(), 1u);
  EXPECT_NEAR(reactions[0].force[0], 2 * 500, 1e-6 * 500);  // rounding of second differences of the formula
  EXPECT_NEAR(reactions[0].force[1], 6 * 500, 1e-6 * 500);
}

/// What moves on a prescribed path keeps its velocity: only free motion is damped.
TEST(Relaxation, LeavesHeldComponentsTheirVelocity) {
  auto simulation = make_simulation<2>(block("[[boundary]]\nface = \"y+\"\nkind = \"displacement\"\n"
                                             "displacement = [\"0.1*t\", \"0.2*t^2\"]\n[relaxation]\n"))
                        .simulation;
  const Snapshot<2> first = simulation.snapshot();
  std::size_t held = 0;
  while (first.X[held][1] < 1 - 1e-9) ++held;
  simulation.control.max_steps = 60;  // from the tenth on there is a rate of damping
  RunRecord history;
  run<2>(
      simulation,
      [&] {
        const Vec<2> v = simulation.at(static_cast<Index>(held)).v;
        const double t = simulation.steps.now().time;
        EXPECT_NEAR(v[0], 0.1, 1e-9) << t;  // of differences of a formula
        EXPECT_NEAR(v[1], 0.4 * t, 1e-9) << t;
        return true;
      },
      history);
  EXPECT_EQ(simulation.steps.now().step, 60);
}

/// A body that nothing holds falls, and all of the load is unbalanced; its damping, which is no force at rest, does not
/// make it less.
TEST(Relaxation, LooksAtForcesAtVelocityZero) {
  const Scene falls = parse_scene(R"([scene]
dimension = 2
end_time = 0.1
[body]
size = [0.5, 1]
spacing = 0.125
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[load]
gravity = ["3", "-10"]
[damping]
rate = 20
[initial]
velocity = ["0.1", "-0.4"]
[relaxation]
)",
                                  "test.toml");
  auto simulation = make_simulation<2>(falls).simulation;
  RunRecord history;
  const RunResult result = run<2>(simulation, {}, history);
  ASSERT_TRUE(result.residual.has_value());
  EXPECT_NEAR(*result.residual, 1, 1e-9);  // the velocity -0.4 m/s would make it 20 % less
}

/// A component that two boundaries hold has its force in the later one.
TEST(Reactions, OfTwoBoundariesAtOnePlaceTheLaterOneCarries) {
  const std::string bar = R"([scene]
dimension = 1
end_time = "2 s"
[body]
size = [1]
particles = [21]
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[load]
gravity = ["5"]
[relaxation]
)";
  const std::string face = "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n",
                    where = "[[boundary]]\nwhere = \"X < 0.01\"\nkind = \"clamped\"\n";
  for (const bool face_first : {true, false}) {
    auto rest = make_simulation<1>(parse_scene(bar + (face_first ? face + where : where + face), "bar.toml"))
                    .simulation;
    RunRecord history;
    ASSERT_TRUE(run<1>(rest, {}, history).completed());
    const auto reactions = rest.reactions();
    ASSERT_EQ(reactions.size(), 2u);
    EXPECT_EQ(reactions[0].boundary == "x-", face_first);
    EXPECT_EQ(reactions[0].force[0], 0);
    EXPECT_NEAR(reactions[1].force[0], -5000, 1e-3);  // the weight; the residual is 1e-8 of it and less
  }
}

TEST(Relaxation, SaysThatItFoundNoRest) {
  Scene scene = block("[load]\ngravity = [\"0\", \"-10\"]\n[relaxation]\n");
  scene.end_time = 0.05;
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord history;
  const RunResult result = run<2>(simulation, {}, history);
  ASSERT_TRUE(result.failure.has_value());
  EXPECT_EQ(result.failure->cause, Cause::no_convergence);
  EXPECT_GT(result.failure->value, 1e-8);
  EXPECT_LT(result.failure->value, 1);
}

TEST(Relaxation, WaitsForTheRamp) {
  auto simulation =
      make_simulation<2>(
          block("[load]\ngravity = [\"0\", \"-10\"]\nramp = 0.8\n[relaxation]\nresidual = 0.5\n"))
          .simulation;
  RunRecord history;
  ASSERT_TRUE(run<2>(simulation, {}, history).completed());
  EXPECT_GE(simulation.steps.now().time, 0.8);
  EXPECT_LT(simulation.steps.now().time, 0.9);
}

/// A stretched plate: every field has its closed form.
TEST(OutputFields, HaveTheNumbersOfAStretch) {
  const Scene scene = parse_scene(R"([scene]
dimension = 2
max_steps = 1
[body]
size = [1, 1]
spacing = 0.25
[material]
model = "saint-venant-kirchhoff"
young = 200
poisson = 0.25
density = 1000
[initial]
displacement = ["0.1*X + 0.3*Y", "-0.2*Y"]
[output]
fields = ["F", "stress", "strain", "volume", "reference_position"]
[[output.probe]]
name = "middle"
at = [0.5, 0.5]
)",
                                  "test.toml");
  auto simulation = make_simulation<2>(scene).simulation;
  Mat<3> F = Mat<3>::Identity();
  F(0, 0) = 1.1;
  F(0, 1) = 0.3;
  F(1, 1) = 0.8;
  const Mat<3> E = (F.transpose() * F - Mat<3>::Identity()) / 2;
  const double lambda = 80, mu = 80;  // of E = 200, nu = 1/4
  const Mat<3> S = lambda * E.trace() * Mat<3>::Identity() + 2 * mu * E;
  const Mat<3> cauchy = F * S * F.transpose() / F.determinant();
  const Snapshot<2> shown = simulation.snapshot();
  const auto near = [](const std::vector<double>& values, const Mat<3>& expected, double size) {
    ASSERT_EQ(values.size(), 9u);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(values[3 * a + b], expected(a, b), 1e-13 * size) << a << b;
  };
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    near(shown_field<2>("F", shown).of(i), F, 1);
    near(shown_field<2>("stress", shown).of(i), cauchy, 100);
    near(shown_field<2>("strain", shown).of(i), E, 1);
  }
  double volume = 0;
  for (const double v : shown_field<2>("volume", shown).values) volume += v;
  EXPECT_NEAR(volume, 0.88, 1e-13);
  EXPECT_EQ(shown_field<2>("reference_position", shown).of(6), (std::vector{0.25, 0.25}));
  const PointView<2> at = simulation.at(12);
  near(probe_values<2>("stress", at), cauchy, 100);
  near(probe_values<2>("F", at), F, 1);
  EXPECT_EQ(probe_columns<2>("stress")[1], "stress xy [Pa]");
  EXPECT_EQ(probe_columns<2>("volume"), std::vector<std::string>{"volume [m^2]"});
  const Table table = Frame<2>(shown, scene.output->fields).table();
  const auto column = [&](const std::string& name) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    EXPECT_NE(found, table.columns.end()) << name;
    return static_cast<std::size_t>(found - table.columns.begin());
  };
  EXPECT_NEAR(std::get<double>(table.rows[3][column("stress yx [Pa]")]), cauchy(1, 0), 1e-11);
  EXPECT_NEAR(std::get<double>(table.rows[3][column("F xy")]), 0.3, 1e-13);
  EXPECT_NEAR(std::get<double>(table.rows[3][column("reference_position x [m]")]), shown.X[3][0], 0);
}

}  // namespace
}  // namespace plumb
