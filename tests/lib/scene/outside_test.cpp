// Loads, damping and supports of the schemes mixed, updated and element: their work against mechanics, rest in time against
// the direct solve and closed forms, reactions, restarts.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/schemes/mixed/mixed.hpp"
#include "lib/schemes/updated/updated.hpp"
#include "tests/support/loadings.hpp"

namespace plumb {
namespace {

/// A block of density 1000 and 0.5 kg per 1e-3 m^d.
std::string block(int d, const std::string& scheme, const std::string& more) {
  const char* size = d == 1 ? "[0.5]" : d == 2 ? "[0.5, 1]" : "[0.5, 0.5, 0.5]";
  return fmt::format(R"([scene]
dimension = {}
end_time = "20 ms"
[body]
size = {}
spacing = 0.125
layout = "node"
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[method]
scheme = "{}"
)",
                     d, size, scheme) +
         more;
}

constexpr double volume(int d) {
  return d == 3 ? 0.125 : 0.5;
}

template <int d>
struct Ended {
  Simulation<d> simulation;
  RunRecord record;
  RunResult result;
  double before;  ///< energy at the start [J]

  std::map<std::string, double> works() const {
    std::map<std::string, double> all;
    for (const auto& [name, done] : simulation.external_work()) all[name] = done;
    return all;
  }
  double change() { return simulation.energy().total() - before; }
};

template <int d>
Ended<d> run_of(const std::string& text) {
  Ended<d> ended{make_simulation<d>(parse_scene(text, "test.toml")).simulation, {}, {}, 0};
  ended.before = ended.simulation.energy().total();
  ended.result = run<d>(ended.simulation, {}, ended.record);
  EXPECT_TRUE(ended.result.completed()) << text;
  return ended;
}

const std::vector<std::string> schemes = {"mixed", "updated", "element"};

/// g per component along x, nothing along the others.
std::string along_x(int d, const std::string& x) {
  return "[\"" + x + "\"" + (d > 1 ? ", 0" : "") + (d > 2 ? ", 0" : "") + "]";
}

/// Falling in a medium: v = g/c + (v0 - g/c) exp(-c t), to the square of the step; what loads and damping have done is the
/// kinetic energy, to round-off.
template <int d>
void falls(const std::string& scheme) {
  const double g = 30, c = 40, t = 0.02;
  std::vector<double> off;
  for (const char* step : {"4e-4", "2e-4"}) {
    auto end =
        run_of<d>(block(d, scheme,
                        std::string("time_step = ") + step + "\n[load]\ngravity = " + along_x(d, "30") +
                            "\n[damping]\nrate = 40\n[initial]\nvelocity = " + along_x(d, "2") + "\n"));
    const Snapshot<d> shown = end.simulation.snapshot();
    off.push_back(shown.v[1][0] - (g / c + (2 - g / c) * std::exp(-c * t)));
    const auto works = end.works();
    const double mass = 1000 * volume(d);
    ASSERT_EQ(works.size(), 2u);
    EXPECT_GT(works.at("loads"), 0.3 * mass);
    EXPECT_LT(works.at("damping"), -0.3 * mass);
    // strains are rounding of displacements of 0.03 m, whose stresses are some 1e-16 of 1 MPa
    EXPECT_NEAR(works.at("loads") + works.at("damping"), end.change(), 1e-11 * mass) << scheme << d;
    EXPECT_NEAR(end.change(), 0.5 * mass * (std::pow(shown.v[1][0], 2) - 4), 1e-11 * mass) << scheme << d;
  }
  EXPECT_LT(std::abs(off[0]), 1e-4) << scheme << d;
  EXPECT_NEAR(off[0] / off[1], 4, 0.1) << scheme << d;
}
TEST(Outside, AFallInAMediumIsOfOrderTwoAndItsWorksAreItsEnergy) {
  for (const auto& scheme : schemes) {
    falls<1>(scheme);
    falls<2>(scheme);
    falls<3>(scheme);
  }
}

/// A support that carries the whole body through a medium does its kinetic energy m (2 a t)^2/2 and what the damping takes,
/// the integral of m c (2 a t)^2. It pushes with m (2 a + c v).
template <int d>
void is_carried(const std::string& scheme, double rate) {
  const double a = 50, t = 0.02, mass = 1000 * volume(d);
  auto end = run_of<d>(block(d, scheme,
                             "time_step = 1e-4\n[[boundary]]\nwhere = \"X > -1\"\nkind = \"displacement\"\n"
                             "displacement = " +
                                 along_x(d, "50*t^2") + "\n" +
                                 (rate > 0 ? fmt::format("[damping]\nrate = {}\n", rate) : "")));
  const double kinetic = 0.5 * mass * std::pow(2 * a * t, 2),
               taken = mass * rate * 4 * a * a * std::pow(t, 3) / 3;
  const auto works = end.works();
  EXPECT_NEAR(end.change(), kinetic, 1e-6 * kinetic)
      << scheme << d;  // velocities are differences of the formula
  // the trapezoidal rule on 200 steps: (dt/t)^2/2 of the integral
  EXPECT_NEAR(works.at("supports"), kinetic + taken, 1e-6 * kinetic + 2e-5 * taken) << scheme << d;
  if (rate > 0) {
    EXPECT_NEAR(works.at("damping"), -taken, 1e-6 * kinetic + 2e-5 * taken) << scheme << d;
    EXPECT_NEAR(works.at("supports") + works.at("damping"), end.change(), 1e-11 * mass) << scheme << d;
  } else {
    EXPECT_EQ(works.size(), 1u);
    EXPECT_NEAR(works.at("supports"), end.change(), 1e-11 * mass) << scheme << d;
  }
  const auto reactions = end.simulation.reactions();
  ASSERT_EQ(reactions.size(), 1u);
  EXPECT_NEAR(reactions[0].force[0], mass * (2 * a + rate * 2 * a * t), 1e-5 * mass * 2 * a) << scheme << d;
}
TEST(Outside, TheWorkOfASupportThatCarriesABodyIsItsKineticEnergy) {
  for (const auto& scheme : schemes)
    for (const double rate : {0.0, 40.0}) {
      is_carried<1>(scheme, rate);
      is_carried<2>(scheme, rate);
      is_carried<3>(scheme, rate);
    }
}

const std::string all_at_work = R"toml([load]
gravity = ["3*X", "-9.81 - 200*t"]
[damping]
rate = 40
[initial]
velocity = ["0.5", "X"]
[[boundary]]
face = "x-"
kind = "displacement"
displacement = ["1e-3*(1 - cos(300*t))", "0"]
[[boundary]]
face = "x+"
kind = "traction"
traction = ["2e4*cos(700*t)", "1e4"]
[[boundary]]
face = "y+"
kind = "pressure"
pressure = "3e4"
)toml";

/// All of them on a body that strains: its energy changes by their work, but for the square of the step.
TEST(Outside, TheWorksMakeUpForTheEnergyToTheSquareOfTheStep) {
  for (const std::string& scheme : {std::string("element"), std::string("mixed")}) {
    std::vector<double> off;
    for (const char* step : {"4e-4", "2e-4", "1e-4"}) {
      auto end = run_of<2>(block(2, scheme,
                                 std::string("time_step = ") + step + "\n" + all_at_work +
                                     (scheme == "mixed" ? "[mixed]\nupwind = \"none\"\n" : "")));
      double sum = 0, sizes = 0;
      for (const auto& [name, done] : end.works()) {
        EXPECT_GT(std::abs(done), 0.5) << name;
        sum += done;
        sizes += std::abs(done);
      }
      EXPECT_EQ(end.works().size(), 3u);
      off.push_back((end.change() - sum) / sizes);
    }
    EXPECT_LT(std::abs(off[2]), 5e-4) << scheme;
    EXPECT_NEAR(off[0] / off[1], 4, 1) << scheme << ' ' << off[0] << ' ' << off[1] << ' ' << off[2];
    EXPECT_NEAR(off[1] / off[2], 4, 0.5) << scheme << ' ' << off[0] << ' ' << off[1] << ' ' << off[2];
  }
}

/// What acts from outside and has a rate of its own goes on after a restart.
TEST(Outside, RestartsHaveTheSameBits) {
  for (const auto& scheme : schemes)
    for (const std::string more : {"", "[relaxation]\nresidual = 1e-12\n"}) {
      const std::string rest = more.empty() ? all_at_work : all_at_work + more;
      Scene scene = parse_scene(block(2, scheme, rest), "test.toml");
      scene.max_steps = 37;
      auto whole = make_simulation<2>(scene).simulation, first = make_simulation<2>(scene).simulation,
           second = make_simulation<2>(scene).simulation;
      RunRecord record, halves;
      run<2>(whole, {}, record);
      run<2>(
          first, [&] { return first.steps.now().step < 20; }, halves);
      second.restore(first.save());
      run<2>(second, {}, halves);
      const SavedState a = whole.save(), b = second.save();
      ASSERT_EQ(a.fields.size(), b.fields.size());
      for (std::size_t k = 0; k < a.fields.size(); ++k)
        EXPECT_EQ(a.fields[k].values, b.fields[k].values) << scheme << ' ' << a.fields[k].name;
      const SavedField* rate = field_named(a.fields, "rate of relaxation");
      ASSERT_NE(rate, nullptr);
      EXPECT_EQ(rate->values[0] > 0, !more.empty()) << scheme;
    }
}

/// A step that fails leaves velocities and works as they were, with a damping too.
TEST(Outside, AStepThatFailsChangesNothing) {
  for (const auto& scheme : schemes) {
    auto simulation = make_simulation<2>(parse_scene(block(2, scheme, all_at_work), "test.toml")).simulation;
    ASSERT_FALSE(simulation.steps.advance(1e-4));
    const SavedState before = simulation.save();
    ASSERT_TRUE(simulation.steps.advance(1e6)) << scheme;
    const SavedState after = simulation.save();
    for (std::size_t k = 0; k < before.fields.size(); ++k)
      EXPECT_EQ(before.fields[k].values, after.fields[k].values) << scheme << ' ' << before.fields[k].name;
  }
}

/// Elements that come to rest in time and Newton's method on the same mesh find one equilibrium, with the same reactions.
TEST(Outside, ElementsComeToRestWhereNewtonsMethodFindsTheEquilibrium) {
  for (const char* order : {"linear", "reduced", "quadratic"})
    for (const auto& [name, text] : testing::loadings) {
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
  for (const std::string& scheme : {std::string("mixed"), std::string("updated"), std::string("evolved")}) {
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

}  // namespace
}  // namespace plumb
