// Work of loads, damping and supports in the summary: against closed forms, and against the budget, which
// counts it in another way.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/run_scene.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::SceneFolder;

double at(const json& value) {
  return value.get<double>();
}

std::string plate(const std::string& more) {
  return R"toml(
[scene]
name = "plate"
dimension = 2
end_time = "4 ms"
[body]
size = [1, 0.5]
spacing = 0.125
layout = "node"
[material]
young = "1 MPa"
poisson = 0.3
density = 1000
[output]
every = "1 ms"
series = true
)toml" + more;
}

const std::string all_at_work = plate(R"toml(budget = true
[load]
gravity = ["3*X", "-9.81 - 200*t"]
[damping]
rate = 40
[initial]
velocity = ["0.5", "X"]
[[boundary]]
face = "x-"
kind = "displacement"
displacement = ["1e-3*sin(900*t)", "0"]
[[boundary]]
face = "x+"
kind = "traction"
traction = ["2e4*cos(700*t)", "1e4"]
[[boundary]]
face = "y+"
kind = "pressure"
pressure = "3e4"
)toml");

/// Each is the energy that the budget has for its cause; with them the energies of the first and the last
/// state agree but for what the integrator does.
TEST(WorkInTheSummary, IsThatOfTheBudget) {
  const SceneFolder folder(all_at_work);
  for (const std::string integrator : {"verlet", "rk3"}) {
    ASSERT_EQ(folder.run(integrator, "--set method.integrator=" + integrator).code, 0);
    const json e = folder.summary(integrator)["energy"];
    auto budget = folder.columns(integrator, "budget.csv");
    double works = 0, sizes = 0;
    const std::pair<const char*, const char*> pairs[] = {
        {"load_work", "loads"}, {"damping_work", "damping"}, {"support_work", "supports"}};
    for (const auto& [key, part] : pairs) {
      const double done = at(e[key]), expected = budget[std::string(part) + ": energy [J/m]"].back();
      EXPECT_GT(std::abs(expected), 1e-2) << part << " does nothing to speak of";
      // sums of 50 particles over 100 steps; forces are differences of sums that are 1e3 times larger
      EXPECT_NEAR(done, expected, 1e-10 * std::abs(expected)) << integrator << ", " << part;
      works += done;
      sizes += std::abs(done);
    }
    EXPECT_LT(at(e["damping_work"]), 0);
    EXPECT_NEAR(at(e["net_change"]), (at(e["total"]) - at(e["initial"]) - works) / (at(e["initial"]) + sizes),
                1e-12);
    // the error of the step, and that of velocities that are set to those of formulas after it
    EXPECT_LT(std::abs(at(e["net_change"])), 1e-2) << integrator;
    for (const double gap : budget["gap of energy"]) EXPECT_LT(std::abs(gap), 1e-12) << integrator;
  }
}

/// A body that falls free from rest: m g^2 t^2/2 of work, all of it kinetic energy.
TEST(WorkInTheSummary, OfGravityIsTheKineticEnergyOfAFall) {
  const SceneFolder folder(plate("[load]\ngravity = [\"0\", \"-10\"]\n"));
  for (const std::string integrator : {"verlet", "rk3"}) {
    ASSERT_EQ(folder.run(integrator, "--set method.integrator=" + integrator).code, 0);
    const json e = folder.summary(integrator)["energy"];
    const double work = 500 * 100 * 16e-6 / 2;
    EXPECT_NEAR(at(e["load_work"]), work, 1e-12 * work);  // nothing strains it
    EXPECT_NEAR(at(e["kinetic"]), work, 1e-12 * work);
    EXPECT_EQ(at(e["damping_work"]), 0);
    EXPECT_EQ(at(e["support_work"]), 0);
    // the strain energy is known to the rounding of modulus times volume, 1e6 * 0.5 * 2e-16 J of 0.4 J
    EXPECT_LT(std::abs(at(e["net_change"])), 1e-9);
  }
}

/// A support that starts at rest and carries the whole body: all of the kinetic energy m (2 a t)^2/2 is its work.
TEST(WorkInTheSummary, OfASupportThatSetsOffIsTheKineticEnergy) {
  const SceneFolder folder(plate(
      "[[boundary]]\nwhere = \"X > -1\"\nkind = \"displacement\"\ndisplacement = [\"50*t^2\", \"0\"]\n"));
  ASSERT_EQ(folder.run("carried", "").code, 0);
  const json e = folder.summary("carried")["energy"];
  const double work = 500 * std::pow(2 * 50 * 4e-3, 2) / 2;
  EXPECT_NEAR(at(e["support_work"]), work, 1e-6 * work);  // velocities are differences of the formula
  EXPECT_NEAR(at(e["kinetic"]), work, 1e-6 * work);
}

/// A plate that moves and is pulled: its work is counted by the schemes that step in time, and the energy changes by it.
TEST(WorkInTheSummary, OfOtherSchemesIsTheChangeOfTheEnergy) {
  const SceneFolder folder(
      plate("[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"2e4\", \"0\"]\n"
            "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n[damping]\nrate = 40\n"));
  for (const std::string scheme : {"mixed", "updated", "eulerian", "element"}) {
    ASSERT_EQ(folder.run(scheme, "--set method.scheme=" + scheme + " --set method.time_step=2e-5").code, 0)
        << scheme;
    const json e = folder.summary(scheme)["energy"];
    EXPECT_GT(at(e["load_work"]), 1) << scheme;
    EXPECT_LT(at(e["damping_work"]), -0.01) << scheme;
    EXPECT_EQ(at(e["support_work"]), 0) << scheme;  // it stands still
    const double works = at(e["load_work"]) + at(e["damping_work"]),
                 sizes = at(e["load_work"]) - at(e["damping_work"]);
    EXPECT_NEAR(at(e["net_change"]), (at(e["total"]) - works) / sizes, 1e-12) << scheme;
    // elements and Verlet: the square of the step; the others dissipate at the front of the wave
    const double lost = scheme == "element" ? 1e-3 : 0.2;
    EXPECT_LT(std::abs(at(e["net_change"])), lost) << scheme;
    EXPECT_TRUE(folder.columns(scheme, "series.csv").contains("reaction x- x [N/m]")) << scheme;
  }
}

/// Work that nobody counts is not taken for a change of the energy.
TEST(WorkInTheSummary, ThereIsNoNetChangeWhereWorkIsNotCounted) {
  const SceneFolder folder(
      plate("[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"2e4\", \"0\"]\n"
            "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n[initial]\nvelocity = [\"X\", \"0\"]\n"));
  for (const std::string moves : {"midpoint", "energy-momentum"}) {
    ASSERT_EQ(
        folder
            .run(moves,
                 "--set method.scheme=implicit --set implicit.steps=20 --set implicit.dynamics=" + moves)
            .code,
        0)
        << moves;
    const json e = folder.summary(moves)["energy"];
    EXPECT_GT(at(e["initial"]), 1) << moves;
    EXPECT_TRUE(e["load_work"].is_null()) << moves;
    EXPECT_TRUE(e["net_change"].is_null()) << moves;
  }
  for (const std::string scheme : {"tlsph", "mixed", "element"}) {
    ASSERT_EQ(folder
                  .run("rest-" + scheme, "--set method.scheme=" + scheme +
                                             " --set relaxation.residual=1e-3 --set scene.end_time=5")
                  .code,
              0);
    EXPECT_TRUE(folder.summary("rest-" + scheme)["energy"]["net_change"].is_null()) << scheme;
  }
}

}  // namespace
}  // namespace plumb
