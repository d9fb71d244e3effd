// Numbers of the summary, of the series and of the frames, each against a closed form or against one that is
// computed again from another file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lib/run/checkpoint.hpp"
#include "tests/support/run_scene.hpp"

namespace plumb::run_values_test {
namespace {

using nlohmann::json;
using test::SceneFolder;

double at(const json& value) {
  return value.get<double>();
}

/// A free plate of 2 x 1 m that turns about its middle, (3, 2), at 5 rad/s; one very short step.
constexpr const char* turning = R"toml(
[scene]
name = "turning"
dimension = 2
max_steps = 1
[body]
origin = [2, 1.5]
size = [2, 1]
spacing = 0.1
layout = "cell"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
time_step = 1e-9
[initial]
spin = 5
[output]
vtk = true
series = true
[[output.probe]]
name = "corner"
at = [4, 2.5]
)toml";

TEST(RunValues, OfAPlateThatTurns) {
  const SceneFolder folder(turning);
  ASSERT_EQ(folder.run("out").code, 0);
  const json s = folder.summary("out");
  const double m = 1100 * 0.01, w = 5, tiny = 1e-7;  // it turns by 5e-9
  double inertia = 0, angular_scale = 0, linear_scale = 0;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 10; ++k) {
      const double x = -0.95 + 0.1 * i, y = -0.45 + 0.1 * k;
      inertia += m * (x * x + y * y);
      linear_scale += m * w * std::hypot(x, y);
      angular_scale += m * w * std::hypot(x, y) * std::hypot(x + 3, y + 2);
    }
  EXPECT_EQ(s["particles"], 200);
  EXPECT_NEAR(at(s["energy"]["kinetic"]), 0.5 * w * w * inertia, tiny * w * w * inertia);
  EXPECT_NEAR(at(s["energy"]["initial"]), 0.5 * w * w * inertia, tiny * w * w * inertia);
  EXPECT_NEAR(at(s["energy"]["strain"]), 0, tiny);
  EXPECT_TRUE(s["energy"]["terms"].empty());
  EXPECT_EQ(at(s["energy"]["support_work"]), 0);
  EXPECT_DOUBLE_EQ(at(s["energy"]["total"]), at(s["energy"]["kinetic"]) + at(s["energy"]["strain"]));
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(at(s["linear_momentum"][k]), 0, tiny * linear_scale);
  EXPECT_NEAR(at(s["angular_momentum"][2]), w * inertia, tiny * w * inertia);
  EXPECT_NEAR(at(s["extent"]["min"][0]), 2.05, tiny);
  EXPECT_NEAR(at(s["extent"]["max"][0]), 3.95, tiny);
  EXPECT_NEAR(at(s["extent"]["min"][1]), 1.55, tiny);
  EXPECT_NEAR(at(s["extent"]["max"][1]), 2.45, tiny);
  const json probe = s["probes"]["corner"];
  EXPECT_NEAR(at(probe["reference"][0]), 3.95, 1e-12);
  EXPECT_NEAR(at(probe["reference"][1]), 2.45, 1e-12);
  EXPECT_NEAR(at(probe["distance"]), 0.05 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(at(probe["velocity"][0]), -w * 0.45, tiny);
  EXPECT_NEAR(at(probe["velocity"][1]), w * 0.95, tiny);
  EXPECT_NEAR(at(probe["position"][0]), 3.95, tiny);
  for (const char* dt : {"first", "min", "max", "last"}) EXPECT_EQ(at(s["dt"][dt]), 1e-9) << dt;
  // 8 neighbours within 1.8 spacings inside; every pair counts for both
  EXPECT_NEAR(at(s["neighbours"]["mean"]), 2.0 * (19 * 10 + 20 * 9 + 2 * 19 * 9) / 200, 1e-12);
  EXPECT_EQ(s["neighbours"]["max"], 8);
  EXPECT_NEAR(at(s["timing"]["computing_s"]) + at(s["timing"]["writing_s"]), at(s["timing"]["wall_s"]), 1e-9);
}

/// The same free plate, away from the origin, by a scheme that keeps no angular momentum.
TEST(RunValues, DriftsAreRelativeToTheScalesOfTheFirstState) {
  const SceneFolder folder(turning);
  const std::string more =
      " --set method.momentum=symmetrised --set method.time_step=2e-5 --set scene.max_steps=200"
      " --set initial.spin=50";
  ASSERT_EQ(folder.run("out", more).code, 0);
  const json s = folder.summary("out"), first = folder.frames("out")[0];
  double linear_scale = 0, angular_scale = 0;
  for (std::size_t i = 0; i < first["points"].size(); ++i) {
    const auto& x = first["points"][i];
    const auto& v = first["arrays"]["velocity [m/s]"][i];
    const double speed = std::hypot(at(v[0]), at(v[1]));
    linear_scale += 1100 * 0.01 * speed;
    angular_scale += 1100 * 0.01 * speed * std::hypot(at(x[0]), at(x[1]));
  }
  auto rows = folder.columns("out", "series.csv");
  const auto change = [&](const char* column) { return rows[column].back() - rows[column].front(); };
  const double angular = std::abs(change("angular momentum z [kg m/s]")) / angular_scale;
  const double linear =
      std::hypot(change("linear momentum x [kg/s]"), change("linear momentum y [kg/s]")) / linear_scale;
  EXPECT_GT(angular, 1e-9) << "there is nothing to see";
  EXPECT_NEAR(at(s["angular_drift"]), angular, 1e-9 * angular);
  EXPECT_NEAR(at(s["linear_drift"]), linear, 1e-9 * linear + 1e-18);
}

/// All particles are moved as x = (1 + t/2) X, y = Y: F, energies and momenta are known at every time.
constexpr const char* pulled = R"toml(
[scene]
name = "pulled"
dimension = 2
end_time = "0.4 s"
[body]
size = [1, 1]
spacing = 0.25
layout = "node"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[[boundary]]
where = "X > -1"
kind = "velocity"
velocity = ["0.5*X", "0"]
[output]
every = "0.1 s"
series = true
vtk = true
budget = true
[[output.probe]]
name = "end"
at = [1, 0.5]
)toml";

TEST(RunValues, OfAPlateThatIsPulled) {
  const double mu = 17e6 / 2.6, kappa = 17e6 / 1.2, J = 1.2;
  const double strain = 0.5 * mu * (std::pow(J, -2.0 / 3) * (1.44 + 2) - 3) + 0.5 * kappa * 0.04;
  // the trapezoidal sum of X^2 over five nodes
  const double square = 0.25 * (0.5 + 0.0625 + 0.25 + 0.5625), kinetic = 0.5 * 1100 * 0.25 * square;
  for (const std::string integrator : {"verlet", "rk3"}) {
    const SceneFolder folder(pulled);
    ASSERT_EQ(folder.run("out", "--set method.integrator=" + integrator).code, 0);
    const json s = folder.summary("out"), e = s["energy"];
    EXPECT_NEAR(at(e["strain"]), strain, 1e-9 * strain);
    EXPECT_NEAR(at(e["kinetic"]), kinetic, 1e-9 * kinetic);
    EXPECT_NEAR(at(e["total"]), strain + kinetic, 1e-9 * strain);
    EXPECT_NEAR(at(e["initial"]), kinetic, 1e-9 * kinetic);
    EXPECT_NEAR(at(e["relative_change"]), strain / kinetic, 1e-9 * strain / kinetic);
    // 1e-4: the trapezoidal rule in time, over some hundred steps
    EXPECT_NEAR(at(e["support_work"]), strain, 1e-4 * strain) << integrator;
    EXPECT_NEAR(at(e["net_change"]),
                (at(e["total"]) - kinetic - at(e["support_work"])) / (kinetic + at(e["support_work"])),
                1e-12);
    EXPECT_LT(std::abs(at(e["net_change"])), 1e-4);
    auto budget = folder.columns("out", "budget.csv");
    const double by_budget = budget["supports: energy [J/m]"].back();
    EXPECT_NEAR(at(e["support_work"]), by_budget, 1e-9 * by_budget) << integrator;
    EXPECT_NEAR(at(s["linear_momentum"][0]), 1100 * 0.25, 1e-9 * 275);
    EXPECT_NEAR(at(s["linear_momentum"][1]), 0, 1e-9 * 275);
    EXPECT_NEAR(at(s["angular_momentum"][2]), -1100 * 0.125, 1e-9 * 137.5);
    EXPECT_NEAR(at(s["extent"]["max"][0]), 1.2, 1e-12);
    EXPECT_NEAR(at(s["extent"]["max"][1]), 1, 1e-12);
    EXPECT_NEAR(at(s["hourglass_share"]), 0, 1e-12);
    EXPECT_NEAR(at(s["probes"]["end"]["displacement"][0]), 0.2, 1e-12);
    EXPECT_NEAR(at(s["probes"]["end"]["position"][1]), 0.5, 1e-12);
  }
}

// The last row of the series, the last frame and the summary are one state.
TEST(RunValues, SeriesFramesAndSummaryAgree) {
  const SceneFolder folder(pulled);
  ASSERT_EQ(folder.run("out").code, 0);
  const json s = folder.summary("out"), frames = folder.frames("out"), last = frames.back();
  auto rows = folder.columns("out", "series.csv");
  const auto end = [&](const char* column) { return rows.at(column).back(); };
  EXPECT_EQ(end("step"), at(s["steps"]));
  EXPECT_EQ(end("time [s]"), at(s["time"]));
  EXPECT_EQ(end("kinetic energy [J/m]"), at(s["energy"]["kinetic"]));
  EXPECT_EQ(end("strain energy [J/m]"), at(s["energy"]["strain"]));
  EXPECT_EQ(end("total energy [J/m]"), at(s["energy"]["total"]));
  EXPECT_EQ(end("linear momentum x [kg/s]"), at(s["linear_momentum"][0]));
  EXPECT_EQ(end("linear momentum y [kg/s]"), at(s["linear_momentum"][1]));
  EXPECT_EQ(end("angular momentum z [kg m/s]"), at(s["angular_momentum"][2]));
  EXPECT_EQ(end("hourglass share"), at(s["hourglass_share"]));
  const json probe = s["probes"]["end"];
  const auto particle = probe["particle"].get<std::size_t>();
  for (int k = 0; k < 2; ++k) {
    const std::string axis(1, "xy"[k]);
    EXPECT_EQ(end(("end position " + axis + " [m]").c_str()), at(probe["position"][k]));
    EXPECT_EQ(end(("end displacement " + axis + " [m]").c_str()), at(probe["displacement"][k]));
    EXPECT_EQ(end(("end velocity " + axis + " [m/s]").c_str()), at(probe["velocity"][k]));
    EXPECT_EQ(at(last["points"][particle][k]), at(probe["position"][k]));
    EXPECT_EQ(at(last["arrays"]["displacement [m]"][particle][k]), at(probe["displacement"][k]));
    EXPECT_EQ(at(last["arrays"]["velocity [m/s]"][particle][k]), at(probe["velocity"][k]));
    EXPECT_EQ(at(frames[0]["points"][particle][k]), at(probe["reference"][k]));
    double least = 1e9, most = -1e9;
    for (const auto& point : last["points"]) {
      least = std::min(least, at(point[k]));
      most = std::max(most, at(point[k]));
    }
    EXPECT_EQ(least, at(s["extent"]["min"][k]));
    EXPECT_EQ(most, at(s["extent"]["max"][k]));
  }
  EXPECT_EQ(at(last["time"]), at(s["time"]));
  ASSERT_EQ(frames.size(), rows["time [s]"].size());
  for (std::size_t n = 0; n < frames.size(); ++n) EXPECT_EQ(at(frames[n]["time"]), rows["time [s]"][n]);
}

/// A plate in a corner of two rollers, with an hourglass energy.
constexpr const char* cornered = R"toml(
[scene]
name = "cornered"
dimension = 2
max_steps = 40
[body]
size = [1, 1]
spacing = 0.1
layout = "node"
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[hourglass]
alpha = 0.5
[initial]
velocity = ["1 + 2*Y*Y", "2 + 3*X"]
[[boundary]]
face = "x-"
kind = "roller"
[[boundary]]
face = "y-"
kind = "roller"
[output]
every = "0.5 ms"
series = true
vtk = true
)toml";

TEST(RunValues, TheEnergiesAddUpWithThatOfTheHourglassTerm) {
  const SceneFolder folder(cornered);
  const auto outcome = folder.run("out");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json e = folder.summary("out")["energy"];
  const double hourglass = at(e["terms"]["hourglass"]);
  EXPECT_GT(hourglass, 1e-9 * at(e["total"])) << "there is nothing to see";
  EXPECT_NEAR(at(e["kinetic"]) + at(e["strain"]) + hourglass, at(e["total"]), 1e-14 * at(e["total"]));
  auto rows = folder.columns("out", "series.csv");
  for (std::size_t n = 0; n < rows["step"].size(); ++n)
    EXPECT_NEAR(rows["kinetic energy [J/m]"][n] + rows["strain energy [J/m]"][n] +
                    rows["hourglass energy [J/m]"].at(n),
                rows["total energy [J/m]"][n], 1e-14 * rows["total energy [J/m]"][n]);
  EXPECT_EQ(rows["hourglass energy [J/m]"].back(), hourglass);
  // the force of all three derives from an energy: at these steps it is kept to some thousandths
  EXPECT_NEAR(at(e["net_change"]), 0, 0.005);
  double total = 0, kinetic = 0, strain = 0, printed = 0;
  const auto place = outcome.out.find("  energy ");
  ASSERT_NE(place, std::string::npos) << outcome.out;
  ASSERT_EQ(
      std::sscanf(outcome.out.c_str() + place, "  energy %lf J/m = kinetic %lf + strain %lf + hourglass %lf",
                  &total, &kinetic, &strain, &printed),
      4)
      << outcome.out;
  EXPECT_NEAR(kinetic + strain + printed, total, 1e-8 * total);
}

// The corner belongs to both faces: it is held in both directions, from the first moment on.
TEST(RunValues, ACornerOfTwoRollersIsHeldBothWays) {
  const SceneFolder folder(cornered);
  ASSERT_EQ(folder.run("out").code, 0);
  const json s = folder.summary("out"), frames = folder.frames("out");
  double kinetic = 0;
  for (int i = 0; i <= 10; ++i)
    for (int k = 0; k <= 10; ++k) {
      const double X = 0.1 * i, Y = 0.1 * k;
      const double V = 0.01 * (i % 10 ? 1 : 0.5) * (k % 10 ? 1 : 0.5);
      const double vx = i == 0 ? 0 : 1 + 2 * Y * Y, vy = k == 0 ? 0 : 2 + 3 * X;
      kinetic += 0.5 * 1100 * V * (vx * vx + vy * vy);
    }
  EXPECT_NEAR(at(s["energy"]["initial"]), kinetic, 1e-10 * kinetic);
  int held = 0;
  for (std::size_t i = 0; i < frames[0]["points"].size(); ++i)
    for (int k = 0; k < 2; ++k) {
      if (at(frames[0]["points"][i][k]) != 0) continue;
      ++held;
      EXPECT_EQ(at(frames.back()["arrays"]["displacement [m]"][i][k]), 0);
      EXPECT_EQ(at(frames.back()["arrays"]["velocity [m/s]"][i][k]), 0);
    }
  EXPECT_EQ(held, 22);
}

TEST(RunValues, ADriftIsToldOfFreeBodiesOnly) {
  EXPECT_NE(SceneFolder(turning).run("out").out.find("drift of linear momentum"), std::string::npos);
  EXPECT_EQ(SceneFolder(cornered).run("out").out.find("drift"), std::string::npos);
}

TEST(RunValues, TheSummaryTellsTheProbeTheWorkAndTheFiles) {
  const SceneFolder turned(turning), moved(pulled);
  const std::string probe = turned.run("out").out;
  EXPECT_NE(
      probe.find("probe \"corner\": particle 199 at (3.95, 2.45) m, 0.0707 m from (4, 2.5): displacement"),
      std::string::npos)
      << probe;
  const std::string text = moved.run("out").out;
  EXPECT_NE(text.find("work of moving supports"), std::string::npos) << text;
  EXPECT_NE(text.find("net of that work"), std::string::npos) << text;
  EXPECT_NE(text.find("computing "), std::string::npos) << text;
  const std::string end =
      "  see: " + moved.file("out", "summary.json").string() + ", series.csv, particles.pvd, budget.csv\n";
  ASSERT_GE(text.size(), end.size());
  EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

/// A block whose sides are all led by an affine motion follows it; what is off is 1 mm, in x alone.
TEST(RunValues, AnExactDisplacementIsHeldAgainstTheEnd) {
  const auto error_with = [](const std::string& exact) {
    std::string scene = R"toml(
[scene]
name = "affine"
dimension = 2
end_time = "1 s"
[body]
size = [1, 1]
spacing = 0.2
layout = "node"
[material]
model = "linear-elastic"
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = "implicit"
gradient = "compatible"
)toml";
    for (const char* face : {"x-", "x+", "y-", "y+"})
      scene += std::string("[[boundary]]\nface = \"") + face +
               "\"\nkind = \"displacement\"\ndisplacement = [\"0.01*X*t\", \"-0.02*Y*t\"]\n";
    const SceneFolder folder(scene + (exact.empty() ? "" : "[output]\nexact = " + exact + "\n"));
    EXPECT_EQ(folder.run("out").code, 0);
    return folder.summary("out").value("error", json());
  };
  EXPECT_TRUE(error_with("").is_null());
  EXPECT_LT(at(error_with(R"(["0.01*X*t", "-0.02*Y*t"])")["displacement_m"]), 1e-11);
  const json off = error_with(R"(["0.01*X*t + 0.001*t", "-0.02*Y*t"])");
  EXPECT_NEAR(at(off["displacement_m"]), 1e-3, 1e-10);
  double size = 0;  // of the formulas
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k) size += std::pow(0.01 * 0.2 * i + 0.001, 2) + std::pow(0.02 * 0.2 * k, 2);
  EXPECT_NEAR(at(off["displacement"]), 1e-3 / std::sqrt(size / 36), 1e-7);
}

}  // namespace
}  // namespace plumb::run_values_test
