#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::run_test {
namespace {

using nlohmann::json;
using test::content_of;
using test::run_plumb;

/// The swinging plate of paper 000 to a quarter period, d = 0.2: 121 particles.
constexpr const char* plate = R"toml(
[scene]
name = "swinging plate"
dimension = 2
end_time = "9.835397e-3 s"
[body]
shape = "box"
size = [2, 2]
spacing = 0.2
layout = "node"
[material]
model = "neo-hookean"
young = "17 MPa"
poisson = 0.495
density = 1100
[method]
kernel = "cubic"
beta = 0.9
pair = "W1"
gradient = "improved"
momentum = "symmetrised"
integrator = "rk3"
cfl = 0.5
[jst]
eta2 = 0
eta4 = 0.125
[initial]
velocity = ["-1.59708*sin(pi*X/2)*cos(pi*Y/2)", "1.59708*cos(pi*X/2)*sin(pi*Y/2)"]
[[boundary]]
face = "x-"
kind = "roller"
[[boundary]]
face = "x+"
kind = "roller"
[[boundary]]
face = "y-"
kind = "roller"
[[boundary]]
face = "y+"
kind = "roller"
[output]
every = "2 ms"
vtk = true
series = true
[[output.probe]]
name = "edge"
at = [0.98, 0.01]
)toml";

/// A plate with every particle moved as x = (1 + 0.5 t) X, y = Y: F is known at every time.
constexpr const char* pulled = R"toml(
[scene]
name = "pulled"
dimension = 2
end_time = "0.4 s"
[body]
shape = "box"
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
vtk = true
)toml";

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);  // heading
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// Runs a scene in a folder of its own.
class RunCommand : public testing::Test {
 protected:
  test::Outcome call(const std::string& command, const char* scene, const std::string& arguments = "") {
    std::ofstream(folder_ / "scene.toml") << scene;
    return run_plumb(command + " " + (folder_ / "scene.toml").string() + " " + arguments);
  }
  test::Outcome run(const char* scene, const std::string& arguments = "") {
    return call("run", scene, "--out " + out().string() + " " + arguments);
  }
  std::filesystem::path out() const { return folder_ / "out"; }

  json read_particles() const {
    const auto outcome =
        test::run_shell("/usr/bin/python3 " PLUMBLINE_SOURCE_DIR "/tests/lib/output/read_back.py " +
                        (out() / "particles.pvd").string());
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return json::parse(outcome.out);
  }

  test::TemporaryFolder folder_;
};

TEST_F(RunCommand, SummaryHasEveryFieldOfTheContract) {
  const auto outcome = run(plate, "--json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json summary = json::parse(outcome.out);
  for (const char* key :
       {"plumbline",       "command",          "provenance",   "scene",         "dimension", "particles",
        "neighbours",      "status",           "steps",        "time",          "dt",        "energy",
        "linear_momentum", "angular_momentum", "linear_drift", "angular_drift", "extent",    "probes",
        "failure",         "timing",           "work",         "memory",        "built",     "left_out"})
    EXPECT_TRUE(summary.contains(key)) << key;
  for (const auto& [key, parts] : std::map<std::string, std::vector<std::string>>{
           {"neighbours", {"mean", "max"}},
           {"dt", {"first", "min", "max", "last"}},
           {"energy", {"kinetic", "strain", "total", "initial", "relative_change"}},
           {"extent", {"min", "max"}},
           {"timing", {"setup_s", "wall_s", "cpu_s", "particle_evaluations_per_s"}},
           {"work", {"particle_evaluations", "pair_evaluations", "bytes"}},
           {"memory", {"bytes_per_particle", "peak_rss"}}})
    for (const auto& part : parts) EXPECT_TRUE(summary[key].contains(part)) << key << "." << part;
  EXPECT_EQ(summary["status"], "completed");
  EXPECT_TRUE(summary["failure"].is_null());
  EXPECT_EQ(summary["particles"], 121);
  // A multiple of the end time's rounding error: the last step is cut to meet it.
  EXPECT_NEAR(summary["time"].get<double>(), 9.835397e-3, 1e-15);
  EXPECT_EQ(json::parse(content_of(out() / "summary.json"))["energy"], summary["energy"]);
}

TEST_F(RunCommand, FirstStepAndNumberOfStepsOfTheSwingingPlate) {
  // no step is cut at an output time, so that all but the last are alike
  const json summary = json::parse(run(plate, "--json - --set 'output.every=1 s'").out);
  // alpha 0.5 of spacing over pressure wave speed, to 7 digits
  EXPECT_NEAR(summary["dt"]["first"].get<double>(), 1.3840341e-4, 5e-12);
  EXPECT_EQ(summary["steps"], 72);
  // Three evaluations a step: work does not depend on the machine.
  EXPECT_EQ(summary["work"]["particle_evaluations"], 121 * 3 * 72);
  // THEORY (10.8) on a lattice: 8 (2 + 2 4 + 2 6) and JST 24 2
  EXPECT_EQ(summary["work"]["bytes"], 121 * 3 * 72 * 224);
}

TEST_F(RunCommand, SeriesHasUnitsAndARowForEveryInterval) {
  ASSERT_EQ(run(plate).code, 0);
  const std::string csv = content_of(out() / "series.csv");
  EXPECT_EQ(
      csv.substr(0, csv.find('\n')),
      "step,time [s],kinetic energy [J/m],strain energy [J/m],total energy [J/m],linear momentum x [kg/s],"
      "linear momentum y [kg/s],angular momentum z [kg m/s],hourglass share,edge position x [m],"
      "edge position y [m],edge displacement x [m],edge displacement y [m],edge velocity x [m/s],"
      "edge velocity y [m/s],reaction x- x [N/m],reaction x- y [N/m],reaction x+ x [N/m],reaction x+ y [N/m],"
      "reaction y- x [N/m],reaction y- y [N/m],reaction y+ x [N/m],reaction y+ y [N/m]");
  const auto rows = numbers_of(csv);
  ASSERT_EQ(rows.size(), 6U) << "0, 2, 4, 6, 8 ms and the last state";
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(rows[k][1], 2e-3 * static_cast<double>(k));
  EXPECT_EQ(rows[5][1], 9.835397e-3);
  for (const auto& row : rows) {
    EXPECT_DOUBLE_EQ(row[4], row[2] + row[3]);
    // The probe takes the particle at (1, 0); its position is its reference point and the displacement.
    EXPECT_NEAR(row[9], 1 + row[11], 1e-15);
    EXPECT_NEAR(row[10], row[12], 1e-15);
  }
  // Kinetic energy of the field at the start: rho U^2 omega^2 / 2 x the nodal sum of the squares, which for
  // the trapezoidal rule on this lattice is the integral, 2 m^2. The velocity is printed with 6 digits.
  EXPECT_NEAR(rows[0][2], 0.5 * 1100 * 1.59708 * 1.59708 * 2, 1e-9 * 2805);
}

TEST_F(RunCommand, ParticleFilesReadBackWithKnownStress) {
  ASSERT_EQ(run(pulled).code, 0);
  const json frames = read_particles();
  ASSERT_EQ(frames.size(), 2U) << "without an interval: the first and the last state";
  // F = diag(1.2, 1, 1) at 0.4 s. Neo-Hookean, from principal stretches:
  // sigma_i = mu J^(-5/3) (l_i^2 - sum l^2 / 3) + kappa (J - 1).
  const double mu = 17e6 / 2.6, kappa = 17e6 / 1.2, J = 1.2, sum = 1.44 + 2;
  const double scale = mu * std::pow(J, -5.0 / 3);
  const double along = scale * (1.44 - sum / 3), across = scale * (1 - sum / 3);
  const auto& arrays = frames[1]["arrays"];
  ASSERT_EQ(frames[1]["points"].size(), 25U);
  for (std::size_t i = 0; i < 25; ++i) {
    // 1e-11: rounding of F at a few hundred steps, times the stiffness ratio
    EXPECT_NEAR(arrays["J"][i][0].get<double>(), J, 1e-11);
    EXPECT_NEAR(arrays["pressure [Pa]"][i][0].get<double>(), -kappa * (J - 1), 1e-10 * kappa);
    EXPECT_NEAR(arrays["von Mises stress [Pa]"][i][0].get<double>(), along - across, 1e-10 * kappa);
    const double X = frames[0]["points"][i][0].get<double>();
    EXPECT_NEAR(arrays["displacement [m]"][i][0].get<double>(), 0.2 * X, 1e-12);
    EXPECT_NEAR(arrays["velocity [m/s]"][i][0].get<double>(), 0.5 * X, 1e-12);
    EXPECT_EQ(arrays["velocity [m/s]"][i][2], 0.0);
    EXPECT_EQ(frames[0]["arrays"]["von Mises stress [Pa]"][i].size(), 1U);
  }
}

TEST_F(RunCommand, AnUnstableRunKeepsWhatItHasAndEndsWith1) {
  // Ten times the stable step: it must blow up within some steps.
  const auto outcome = run(plate, "--set method.time_step=2.7e-3 --set scene.end_time=1 --json -");
  EXPECT_EQ(outcome.code, 1) << outcome.error;
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["status"], "unstable");
  const json& failure = summary["failure"];
  for (const char* key : {"time", "step", "cause", "particle", "quantity"})
    EXPECT_TRUE(failure.contains(key)) << key;
  const std::vector<std::string> causes{"non-finite", "inverted", "energy-growth", "time-step-collapse",
                                        "hourglass"};
  EXPECT_NE(std::find(causes.begin(), causes.end(), failure["cause"]), causes.end());
  const auto rows = numbers_of(content_of(out() / "series.csv"));
  ASSERT_GE(rows.size(), 2U);
  EXPECT_EQ(rows.back()[0], summary["steps"].get<double>()) << "the last good state is recorded";
  EXPECT_EQ(read_particles().size(), rows.size());
}

TEST_F(RunCommand, OneAndTwoThreadsGiveTheSameBits) {
  ASSERT_EQ(run(plate, "--threads 1").code, 0);
  const std::string one = content_of(out() / "series.csv");
  ASSERT_EQ(run(plate, "--threads 2").code, 0);
  EXPECT_EQ(content_of(out() / "series.csv"), one);
}

TEST_F(RunCommand, BadInputWritesNothing) {
  for (const char* arguments : {"--set method.betta=1", "--set scene.name", "--set body.spacing=1e-6",
                                "--resume", "--json /no/such/folder/x", "--set body.spacing=0.3"}) {
    const auto outcome = run(plate, arguments);
    EXPECT_EQ(outcome.code, 2) << arguments << ": " << outcome.error;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_FALSE(std::filesystem::exists(out())) << arguments;
  }
}

TEST_F(RunCommand, MoreParticlesThanMemoryAreRefusedBeforeItIsTaken) {
  const auto outcome = run(plate, "--set body.spacing=8e-5");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("do not fit into memory"), std::string::npos) << outcome.error;
}

TEST_F(RunCommand, AFolderThatCannotBeMadeIsRefusedBeforeTheRun) {
  std::ofstream(folder_ / "file") << "x";
  const auto outcome = call("run", plate, "--out " + (folder_ / "file/out").string());
  EXPECT_EQ(outcome.code, 2) << outcome.error;
  EXPECT_NE(outcome.error.find("--out"), std::string::npos) << outcome.error;
}

TEST_F(RunCommand, ASignalEndsTheRunInOrder) {
  std::ofstream(folder_ / "scene.toml") << plate;
  const std::string series = (out() / "series.csv").string();
  // The signal is sent once the first row is there, that is, once the run has begun.
  const auto outcome = test::run_shell(
      PLUMB_EXECUTABLE " run " + (folder_ / "scene.toml").string() + " --out " + out().string() +
      " --set scene.end_time=1e5 --json - & run=$!; until [ \"$(cat " + series +
      " 2>/dev/null | wc -l)\" -ge 2 ] || ! kill -0 $run 2>/dev/null; do sleep 0.02; done; " +
      "kill -INT $run; wait $run");
  EXPECT_EQ(outcome.code, 130) << outcome.error;
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["status"], "interrupted");
  EXPECT_EQ(numbers_of(content_of(series)).back()[0], summary["steps"].get<double>());
}

TEST_F(RunCommand, ExplainAgreesWithTheRunAndWritesNothing) {
  const auto outcome = call("explain", plate, "--json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json explained = json::parse(outcome.out);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1)
      << "only the scene is there";
  const json summary = json::parse(run(plate, "--json -").out);
  EXPECT_EQ(explained["particles"], summary["particles"]);
  EXPECT_EQ(explained["neighbours"], summary["neighbours"]);
  EXPECT_EQ(explained["dt"], summary["dt"]["first"]);
  EXPECT_EQ(explained["built"], summary["built"]);
  EXPECT_EQ(explained["left_out"], summary["left_out"]);
  EXPECT_EQ(explained["memory"]["bytes_per_particle"], summary["memory"]["bytes_per_particle"]);
  // The body swings, so steps shrink below the first one now and then.
  EXPECT_NEAR(explained["steps"].get<double>(), summary["steps"].get<double>(), 2);
  double bytes = 0;
  for (const auto& array : explained["arrays"]) bytes += array["bytes"].get<double>();
  EXPECT_EQ(bytes, explained["memory"]["bytes"].get<double>());
}

TEST_F(RunCommand, WhatASceneDoesNotNameIsLeftOut) {
  const json explained = json::parse(call("explain", pulled, "--json -").out);
  const auto has = [](const json& list, const char* name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  EXPECT_TRUE(has(explained["left_out"], "jst"));
  EXPECT_TRUE(has(explained["left_out"], "series"));
  EXPECT_TRUE(has(explained["built"], "boundary"));
  EXPECT_TRUE(has(explained["built"], "vtk"));
  for (const auto& array : explained["arrays"]) EXPECT_NE(array["name"], "jst");
}

}  // namespace
}  // namespace plumb::run_test
