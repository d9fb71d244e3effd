// The folder of a run: one run at a time, nothing of an earlier one, and no state is thrown away unasked.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/run/checkpoint.hpp"
#include "tests/support/run_scene.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::content_of;
using test::run_shell;

constexpr const char* swinging = R"toml(
[scene]
name = "swinging"
dimension = 2
end_time = "4 ms"
[body]
size = [2, 2]
spacing = 0.2
layout = "node"
[material]
young = "17 MPa"
poisson = 0.4
density = 1100
[method]
integrator = "verlet"
[initial]
velocity = ["-15*sin(pi*X/2)*cos(pi*Y/2)", "15*cos(pi*X/2)*sin(pi*Y/2)"]
[output]
every = "0.5 ms"
series = true
vtk = true
)toml";

class RunFolder : public testing::Test {
 protected:
  /// Runs without end, and does `then` when there are rows; `$run` is its process.
  test::Outcome endless_until(const std::string& then, const std::string& before = "") const {
    const std::string series = scene_.file("out", "series.csv").string();
    return run_shell(before + scene_.call("out", "--quiet --set scene.end_time=1e5") +
                     " & run=$!; until [ \"$(cat " + series +
                     " 2>/dev/null | wc -l)\" -ge 3 ] || ! kill -0 $run 2>/dev/null; do sleep 0.02; done; " +
                     then);
  }
  bool has(const std::string& name) const { return std::filesystem::exists(scene_.file("out", name)); }

  test::SceneFolder scene_{swinging};
};

TEST_F(RunFolder, ASecondRunIsRefusedUntilTheFirstOneDies) {
  const auto outcome =
      endless_until(scene_.call("out", "--overwrite") + "; second=$?; kill -KILL $run; wait $run; " +
                    scene_.call("out", "--quiet") + "; exit $((10 * second + $?))");
  EXPECT_EQ(outcome.code, 20) << outcome.error;
  EXPECT_NE(outcome.error.find("another run writes into \"" + scene_.file("out", "").parent_path().string()),
            std::string::npos)
      << outcome.error;
  EXPECT_EQ(scene_.summary("out")["status"], "completed");
  EXPECT_EQ(scene_.columns("out", "series.csv")["time [s]"].size(), 9U);
  EXPECT_FALSE(has(".lock"));
}

TEST_F(RunFolder, EverySignalEndsARunInOrderWithItsCode) {
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 129)}) {
    const auto outcome = endless_until(std::string("kill -") + signal + " $run; wait $run");
    EXPECT_EQ(outcome.code, code) << signal << ": " << outcome.error;
    EXPECT_EQ(scene_.summary("out")["status"], "interrupted") << signal;
    EXPECT_GT(read_checkpoint(scene_.file("out", "checkpoint.h5")).state.now.step, 0) << signal;
    std::filesystem::remove_all(scene_.file("out", ""));
  }
}

TEST_F(RunFolder, ARunThatShallOutliveItsTerminalDoes) {
  const auto outcome =
      endless_until("kill -HUP $run; sleep 0.3; kill -TERM $run; wait $run", "trap '' HUP; ");
  EXPECT_EQ(outcome.code, 143) << outcome.error;
}

TEST_F(RunFolder, ARerunRemovesWhatTheOneBeforeLeftAndNothingElse) {
  ASSERT_EQ(scene_.run("out").code, 0);
  ASSERT_TRUE(has("particles_000008.vtp"));
  for (const char* name :
       {"particles_000004.vtp.123.tmp", "series.csv.9.tmp", "summary.json.77.tmp", "budget.csv", "notes.txt",
        "notes.txt.9.tmp", "particles_mine.vtp", "other_000008.vtp"})
    std::ofstream(scene_.file("out", name)) << "x";
  ASSERT_EQ(scene_.run("out", "--set scene.end_time=\"1 ms\"").code, 0);
  EXPECT_EQ(scene_.frames("out").size(), 3U);
  EXPECT_TRUE(has("particles_000002.vtp"));
  for (const char* gone : {"particles_000003.vtp", "particles_000008.vtp", "particles_000004.vtp.123.tmp",
                           "series.csv.9.tmp", "summary.json.77.tmp", "budget.csv"})
    EXPECT_FALSE(has(gone)) << gone;
  for (const char* kept : {"notes.txt", "notes.txt.9.tmp", "particles_mine.vtp", "other_000008.vtp"})
    EXPECT_TRUE(has(kept)) << kept;
}

TEST_F(RunFolder, ACheckpointIsThrownAwayOnlyIfAskedTo) {
  ASSERT_EQ(endless_until("kill -INT $run; wait $run").code, 130);
  const std::string before = content_of(scene_.file("out", "checkpoint.h5"));
  const auto refused = scene_.run("out");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.error.find("--overwrite"), std::string::npos) << refused.error;
  EXPECT_EQ(content_of(scene_.file("out", "checkpoint.h5")), before);
  EXPECT_EQ(scene_.summary("out")["status"], "interrupted");
  ASSERT_EQ(scene_.run("out", "--overwrite").code, 0);
  EXPECT_FALSE(has("checkpoint.h5")) << "a complete run has nothing to go on with";
  EXPECT_EQ(scene_.summary("out")["status"], "completed");
}

TEST_F(RunFolder, ResumingACompleteRunSaysSo) {
  ASSERT_EQ(scene_.run("out", "--set output.checkpoint=\"1 ms\"").code, 0);
  const json before = scene_.summary("out");
  const auto again = scene_.run("out", "--set output.checkpoint=\"1 ms\" --resume");
  EXPECT_EQ(again.code, 0) << again.error;
  EXPECT_NE(again.out.find("this run is complete"), std::string::npos) << again.out;
  const json told = json::parse(scene_.run("out", "--set output.checkpoint=\"1 ms\" --resume --json -").out);
  EXPECT_EQ(told["energy"], before["energy"]);
  EXPECT_EQ(scene_.summary("out"), before);
  const auto other =
      scene_.run("out", "--set output.checkpoint=\"1 ms\" --set material.poisson=0.3 --resume");
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.error.find("material.poisson"), std::string::npos) << other.error;
}

TEST_F(RunFolder, RowsAndFramesFallOnTheStatedTimesWhateverTheStep) {
  std::vector<double> edge;
  for (const std::string cfl : {"0.5", "0.25", "0.125"}) {
    ASSERT_EQ(scene_.run("out", "--set method.cfl=" + cfl).code, 0);
    auto rows = scene_.columns("out", "series.csv");
    const json frames = scene_.frames("out"), s = scene_.summary("out");
    ASSERT_EQ(rows["time [s]"].size(), 9U);
    ASSERT_EQ(frames.size(), 9U);
    for (int k = 0; k < 9; ++k) {
      EXPECT_EQ(rows["time [s]"][k], k < 8 ? k * 0.5e-3 : 4e-3);
      EXPECT_EQ(frames[k]["time"].get<double>(), rows["time [s]"][k]);
    }
    // steps that are cut are no steps that stability asks for
    EXPECT_GT(s["dt"]["min"].get<double>(), 0.85 * s["dt"]["first"].get<double>());
    edge.push_back(frames[5]["arrays"]["displacement [m]"][40][0].get<double>());
  }
  // velocity Verlet is of second order, with some steps shorter than others too
  EXPECT_NEAR((edge[0] - edge[1]) / (edge[1] - edge[2]), 4, 1);
}

// A continued run judges its energy by that of its very first state, as a run in one piece does.
TEST_F(RunFolder, TheBoundOfAContinuedRunIsThatOfItsFirstState) {
  ASSERT_EQ(endless_until("kill -INT $run; wait $run").code, 130);
  Checkpoint c = read_checkpoint(scene_.file("out", "checkpoint.h5"));
  const double energy = c.record.initial_energy.value();
  c.record.initial_energy.value() *= 0.25;  // the bound is twice the first energy
  c.record.initial_momentum.linear = {10, 0, 0};
  c.record.initial_momentum.linear_scale = 40;
  c.record.initial_momentum.angular = {0, 0, 3};
  c.record.initial_momentum.angular_scale = 12;
  // soon over, so that a run that overlooks the bound ends too
  const std::string end = fmt::format("{:.17g}", c.state.now.time + 60 * c.record.dt.last);
  ASSERT_TRUE(c.scene.contains("scene.end_time"));
  c.scene["scene.end_time"] = end;
  write_checkpoint(scene_.file("out", "checkpoint.h5"), c);
  EXPECT_EQ(scene_.run("out", "--set scene.end_time=" + end + " --resume").code, 1);
  const json s = scene_.summary("out");
  EXPECT_EQ(s["status"], "unstable");
  EXPECT_EQ(s["failure"]["cause"], "energy-growth");
  EXPECT_LE(s["failure"]["step"].get<long>(), c.state.now.step + 20)
      << "the energy is looked at every twenty steps";
  EXPECT_NEAR(s["energy"]["initial"].get<double>(), 0.25 * energy, 1e-9 * energy);
  const json &p = s["linear_momentum"], &L = s["angular_momentum"];
  EXPECT_NEAR(s["linear_drift"].get<double>(), std::hypot(p[0].get<double>() - 10, p[1].get<double>()) / 40,
              1e-12);
  EXPECT_NEAR(s["angular_drift"].get<double>(), std::abs(L[2].get<double>() - 3) / 12, 1e-12);
}

}  // namespace
}  // namespace plumb
