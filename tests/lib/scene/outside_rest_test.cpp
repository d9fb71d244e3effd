// Dynamic relaxation of the schemes that step velocities: against the direct solve and closed forms.
#include <cmath>

#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/mixed/mixed.hpp"
#include "lib/schemes/updated/updated.hpp"
#include "tests/support/loadings.hpp"
#include "tests/support/outside.hpp"

namespace plumb::testing {
namespace {

/// Elements that come to rest in time and Newton's method on the same mesh find one equilibrium, with the same reactions.
TEST(Outside, ElementsComeToRestWhereNewtonsMethodFindsTheEquilibrium) {
  for (const char* order : {"linear", "reduced", "quadratic"})
    for (const auto& [name, text] : loadings) {
      SCOPED_TRACE(std::string(order) + ", " + name);
      const std::string stands = std::string("[[boundary]]\nface = \"y-\"\nkind = \"clamped\"\n") + text;
      const auto element = [&](const std::string& more) {
        Scene scene = parse_scene(
            block(2, "element", stands + "[element]\norder = \"" + order + "\"\n" + more), "test.toml");
        scene.end_time = 4;
        return make_simulation<2>(scene).simulation;
      };
      auto rest = element("[relaxation]\nresidual = 1e-9\n"), direct = element("solve = \"newton\"\n");
      RunRecord one, other;
      const RunResult result = run<2>(rest, {}, one);
      ASSERT_TRUE(result.completed());
      EXPECT_LE(*result.residual, 1e-9);
      EXPECT_LT(rest.steps.now().time, 4);
      ASSERT_TRUE(run<2>(direct, {}, other).completed());
      const Snapshot<2> a = rest.snapshot(), b = direct.snapshot();
      double most = 0;
      for (const auto& u : b.u) most = std::max(most, u.norm());
      ASSERT_GT(most, 0.01);
      for (std::size_t i = 0; i < a.u.size(); ++i)  // the softest motion is some 1e2 times softer than a bond
        EXPECT_NEAR((a.u[i] - b.u[i]).norm(), 0, 1e-6 * most) << i;
      const auto by_rest = rest.reactions(), by_solve = direct.reactions();
      ASSERT_EQ(by_rest.size(), by_solve.size());
      double largest = 0;
      for (const auto& reaction : by_solve) largest = std::max(largest, reaction.force.norm());
      for (std::size_t k = 0; k < by_rest.size(); ++k) {
        EXPECT_EQ(by_rest[k].boundary, by_solve[k].boundary);
        EXPECT_NEAR((by_rest[k].force - by_solve[k].force).norm(), 0, 1e-6 * largest) << k;
      }
    }
}

/// A bar under its weight, by schemes that have no direct solve: u = rho g (L X - X^2/2)/M of small strains, in which all
/// laws agree, and the weight at the held end.
TEST(Outside, ABarComesToRestUnderItsWeight) {
  const double modulus = 1e6 * 0.7 / (1.3 * 0.4), g = 0.02;
  for (const std::string scheme : {"mixed", "updated", "eulerian", "evolved"}) {
    std::vector<double> off;
    for (const int cells : {20, 40}) {
      auto end = run_of<1>(fmt::format(R"([scene]
dimension = 1
end_time = "20 s"
[body]
size = [1]
particles = [{}]
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[load]
gravity = ["0.02"]
[[boundary]]
face = "x-"
kind = "clamped"
[relaxation]
residual = 1e-7
[method]
scheme = "{}"
{})",
                                       cells + 1, scheme == "evolved" ? "mixed" : scheme,
                                       scheme == "evolved" ? "[mixed]\nkinematics = \"evolved\"\n" : ""));
      EXPECT_LT(end.simulation.steps.now().time, 20) << scheme;
      const Snapshot<1> shown = end.simulation.snapshot();
      off.push_back(shown.u.back()[0] / (1000 * g / (2 * modulus)) - 1);
      EXPECT_LT(shown.v[static_cast<std::size_t>(cells / 2)].norm(), 1e-8) << scheme;
      const auto reactions = end.simulation.reactions();
      ASSERT_EQ(reactions.size(), 1u);
      EXPECT_NEAR(reactions[0].force[0] / (1000 * g), -1, 1e-6) << scheme;
    }
    EXPECT_LT(std::abs(off[0]), 0.08) << scheme << ' ' << off[0];
    // strains of 1e-5, in which laws differ by as much
    EXPECT_LT(std::abs(off[1]), std::max(1e-5, 0.6 * std::abs(off[0])))
        << scheme << ' ' << off[0] << ' ' << off[1];
  }
}

/// What moves on a prescribed path keeps its velocity in a relaxation.
TEST(Outside, RelaxationLeavesHeldComponentsTheirVelocity) {
  for (const auto& scheme : schemes) {
    auto simulation =
        make_simulation<2>(parse_scene(block(2, scheme,
                                             "time_step = 1e-4\n"
                                             "[[boundary]]\nface = \"y-\"\nkind = \"clamped\"\n"
                                             "[[boundary]]\nface = \"y+\"\nkind = \"velocity\"\n"
                                             "velocity = [0.1, 0.2]\n[damping]\nrate = 5\n[relaxation]\n"),
                                       "test.toml"))
            .simulation;
    const Snapshot<2> first = simulation.snapshot();
    std::size_t held = 0;
    while (first.X[held][1] < 1 - 1e-9) ++held;
    simulation.control.max_steps = 60;  // from the tenth on there is a rate of damping
    RunRecord history;
    run<2>(simulation, {}, history);
    EXPECT_EQ(simulation.steps.now().step, 60);
    EXPECT_EQ(simulation.at(static_cast<Index>(held)).v, Vec<2>(0.1, 0.2)) << scheme;
  }
}

/// A body that nothing holds falls, and all of the load is unbalanced, whatever damps its motion.
TEST(Outside, RelaxationLooksAtForcesWithoutDamping) {
  for (const auto& scheme : schemes) {
    auto simulation =
        make_simulation<2>(parse_scene(block(2, scheme,
                                             "time_step = 1e-4\n"
                                             "[load]\ngravity = [\"3\", \"-10\"]\n[damping]\nrate = 20\n"
                                             "[initial]\nvelocity = [\"0.1\", \"-0.4\"]\n[relaxation]\n"),
                                       "test.toml"))
            .simulation;
    RunRecord history;
    simulation.control.max_steps = 11;  // the look is after the tenth
    const RunResult result = run<2>(simulation, {}, history);
    ASSERT_TRUE(result.residual.has_value());
    EXPECT_NEAR(*result.residual, 1, 1e-9) << scheme;  // strains are rounding of displacements
  }
}

/// Forces at rest have no dissipation: they are those of a body whose velocity is zero.
TEST(Outside, ForcesAtRestHaveNoDissipation) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>(1, 1)}, {8, 8}, Layout::cell);
  InitialMotion<2> motion, still;
  for (const Vec<2>& X : cloud.X) {
    motion.u.push_back(0.02 * Vec<2>(std::sin(3 * X[1]), X[0] * X[1]));
    motion.v.push_back(Vec<2>(5 * X[0], -3 * X[0] * X[1]));
  }
  still.u = motion.u;
  const Specimen<2> rubber{cloud, LawChoice("neo-hookean"), {1e6, 0.3, 1000}};
  const auto apart = [&](const Field& a, const Field& b) {
    double square = 0;
    for (int k = 0; k < 2; ++k)
      for (Index i = 0; i < cloud.size(); ++i) square += std::pow(a[k][i] - b[k][i], 2);
    return std::sqrt(square);
  };
  Mixed<2> mixed(rubber, {}, {});
  const auto moving = mixed.start(motion), resting = mixed.start(still);
  const Field at_rest = mixed.open(resting, false)->all;
  EXPECT_EQ(apart(mixed.open(moving, true)->all, at_rest), 0);
  EXPECT_GT(apart(mixed.open(moving, false)->all, at_rest), 1);
  UpdatedOptions none;
  none.dissipation = "none";
  Updated<2> dissipates(rubber, {}, {}), keeps(rubber, none, {});
  const auto one = dissipates.start(motion), other = keeps.start(motion);
  const Field kept = keeps.open(other, false)->all;
  EXPECT_EQ(apart(dissipates.open(one, true)->all, kept), 0);
  EXPECT_GT(apart(dissipates.open(one, false)->all, kept), 1);
}

/// Those of the scheme of paper 001 are the forces of its stress: its dampings have none at rest, and looking changes
/// nothing of the motion.
TEST(Outside, EulerianForcesAtRestHaveNoDamping) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>(1, 1)}, {8, 8}, Layout::cell);
  InitialMotion<2> motion;
  for (const Vec<2>& X : cloud.X) {
    motion.u.push_back(0.02 * Vec<2>(std::sin(3 * X[1]), X[0] * X[1]));
    motion.v.push_back(Vec<2>(5 * X[0], -3 * X[0] * X[1]));
  }
  const Specimen<2> rubber{cloud, LawChoice("linear-elastic"), {1e6, 0.3, 1000}};
  const auto largest = [&](const Field& a, const Field& b) {
    double most = 0;
    for (int k = 0; k < 2; ++k)
      for (Index i = 0; i < cloud.size(); ++i) most = std::max(most, std::abs(a[k][i] - b[k][i]));
    return most;
  };
  EulerianOptions neutral, damped;
  neutral.damping = "none";
  damped.viscosity_linear = 2;
  Eulerian<2> without(rubber, neutral, {}), with(rubber, damped, {}), looked(rubber, damped, {});
  auto a = without.start(motion), b = with.start(motion), c = looked.start(motion);
  // at the start the stress is that of the displacement, and neither damping has received anything
  EXPECT_EQ(largest(without.open(a, true)->all, with.open(b, true)->all), 0);
  EXPECT_GT(largest(with.open(b, false)->all, with.open(b, true)->all), 1);
  for (int step = 0; step < 12; ++step) {
    ASSERT_FALSE(with.advance(b, 2e-5));
    ASSERT_TRUE(looked.open(c, true).has_value());
    ASSERT_FALSE(looked.advance(c, 2e-5));
  }
  EXPECT_EQ(largest(b.v, c.v), 0);
  // a body that has made no step knows nothing of what the last one put into the stress of the damping
  Eulerian<2> fresh(rubber, damped, {});
  EXPECT_LT(largest(fresh.open(b, true)->all, with.open(b, true)->all), 1e-6);
  EXPECT_EQ(largest(with.open(b, false)->all, b.acceleration), 0);
  EXPECT_GT(largest(with.open(b, false)->all, with.open(b, true)->all), 1);
}

}  // namespace
}  // namespace plumb::testing
