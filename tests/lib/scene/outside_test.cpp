// Loads, damping and supports of the schemes that step velocities: their work and reactions against mechanics,
// restarts, and steps that fail.
#include "tests/support/outside.hpp"

#include <cmath>

namespace plumb::testing {
namespace {

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
    // Eulerian kernels take particles that fly apart for fragments, as long as they are somewhere
    ASSERT_TRUE(simulation.steps.advance(scheme == "eulerian" ? 1e200 : 1e6)) << scheme;
    const SavedState after = simulation.save();
    for (std::size_t k = 0; k < before.fields.size(); ++k)
      EXPECT_EQ(before.fields[k].values, after.fields[k].values) << scheme << ' ' << before.fields[k].name;
  }
}

}  // namespace
}  // namespace plumb::testing
