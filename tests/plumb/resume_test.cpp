// A run that is stopped, killed or out of disk goes on with the same bits, and nothing but the time since the
// last checkpoint is lost.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "lib/run/checkpoint.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::content_of;
using test::run_shell;

/// Verlet keeps its acceleration between steps, and JST makes it depend on the velocity: a run that found it
/// again from the state would differ in the last digits.
constexpr const char* scene_text = R"toml(
[scene]
name = "swinging plate"
dimension = 2
end_time = "15 ms"
[body]
shape = "box"
size = [2, 2]
spacing = 0.1
layout = "node"
[material]
young = "17 MPa"
poisson = 0.495
density = 1100
[method]
momentum = "adjoint"
integrator = "verlet"
cfl = 0.4
[jst]
eta4 = 0.015625
[initial]
velocity = ["-15*sin(pi*X/2)*cos(pi*Y/2)", "15*cos(pi*X/2)*sin(pi*Y/2)"]
[[boundary]]
face = "x-"
kind = "roller"
[[boundary]]
face = "y-"
kind = "clamped"
[output]
every = "1 ms"
checkpoint = "0.7 ms"
vtk = true
series = true
[[output.probe]]
name = "corner"
at = [2, 2]
)toml";

class Resume : public testing::Test {
 protected:
  Resume() { write_scene(15); }

  /// The scene with that end [ms].
  void write_scene(int end) const {
    std::string text = scene_text;
    const std::string as_it_stands = "end_time = \"15 ms\"";
    text.replace(text.find(as_it_stands), as_it_stands.size(),
                 "end_time = \"" + std::to_string(end) + " ms\"");
    std::ofstream(folder_ / "scene.toml") << text;
  }

  std::string call(const std::string& out, const std::string& arguments) const {
    return PLUMB_EXECUTABLE " run " + (folder_ / "scene.toml").string() + " --out " +
           (folder_ / out).string() + " " + arguments;
  }
  /// Runs until a checkpoint is there, then ends it by the signal. On a busy machine the run may be over
  /// before the signal comes: then the scene gets twice the time, for good, and the run begins anew.
  test::Outcome stopped(const std::string& out, const std::string& signal,
                        const std::string& arguments = "") const {
    for (int end = 15;; end *= 2) {
      write_scene(end);
      const auto outcome = run_shell(call(out, arguments) + " & run=$!; until [ -e " + checkpoint(out) +
                                     " ] || ! kill -0 $run 2>/dev/null; do sleep 0.01; done; kill -" +
                                     signal + " $run; wait $run");
      if (outcome.code != 0 || end > 1000) return outcome;
      std::filesystem::remove_all(folder_ / out);
    }
  }
  std::string checkpoint(const std::string& out) const { return (folder_ / out / "checkpoint.h5").string(); }

  /// The summary without what depends on the clock and the command line.
  json summary(const std::string& out) const {
    json all = json::parse(content_of(folder_ / out / "summary.json"));
    for (const char* key : {"timing", "memory", "provenance", "command"}) all.erase(key);
    return all;
  }
  std::string series(const std::string& out) const { return content_of(folder_ / out / "series.csv"); }

  /// The files of two runs have the same bytes.
  void expect_same(const std::string& one, const std::string& other) const {
    EXPECT_EQ(summary(one), summary(other));
    EXPECT_EQ(series(one), series(other));
    for (const auto& file : std::filesystem::directory_iterator(folder_ / one)) {
      const auto name = file.path().filename().string();
      if (name == "summary.json" || name == "checkpoint.h5") continue;
      EXPECT_TRUE(content_of(file.path()) == content_of(folder_ / other / name)) << name;
    }
  }

  /// What a kill leaves can be read: the checkpoint, and every file that the index names.
  void expect_readable(const std::string& out) const {
    if (std::filesystem::exists(checkpoint(out))) {
      EXPECT_NO_THROW(read_checkpoint(checkpoint(out)));
    }
    if (!std::filesystem::exists(folder_ / out / "particles.pvd")) return;
    const std::string index = content_of(folder_ / out / "particles.pvd");
    EXPECT_NE(index.find("</VTKFile>"), std::string::npos);
    const std::regex file("file=\"([^\"]*)\"");
    for (auto at = std::sregex_iterator(index.begin(), index.end(), file); at != std::sregex_iterator();
         ++at) {
      const std::string content = content_of(folder_ / out / (*at)[1].str());
      EXPECT_EQ(content.substr(content.size() - 11), "</VTKFile>\n");
    }
  }

  void kill_at_random_moments(int kills) const;

  test::TemporaryFolder folder_;
};

TEST_F(Resume, AStoppedRunSaysWhatIsKeptAndHowToGoOn) {
  const auto outcome = stopped("parts", "INT", "--set method.integrator=rk3");
  EXPECT_NE(outcome.out.find("kept: all rows"), std::string::npos) << outcome.out;
  const auto at = outcome.out.find("  to go on: plumb ");
  ASSERT_NE(at, std::string::npos) << outcome.out;
  const auto rest = outcome.out.substr(at + 18, outcome.out.find('\n', at) - at - 18);
  EXPECT_EQ(run_shell(PLUMB_EXECUTABLE " " + rest).code, 0) << rest;
  EXPECT_EQ(summary("parts")["status"], "completed");
}

TEST_F(Resume, AfterASignalTheRunGoesOnWithTheSameBits) {
  for (const std::string arguments : {"", "--set method.integrator=rk3"}) {
    const auto outcome = stopped("parts", "INT", arguments);
    ASSERT_EQ(outcome.code, 130) << outcome.error;
    ASSERT_EQ(run_shell(call("whole", arguments)).code, 0);  // the scene is now as long as that of the parts
    ASSERT_LT(summary("parts")["steps"], summary("whole")["steps"]) << "the run was over before the signal";
    const auto resumed = run_shell(call("parts", "--threads 1 --resume " + arguments));
    ASSERT_EQ(resumed.code, 0) << resumed.error;
    expect_same("whole", "parts");
    for (const char* out : {"parts", "whole"}) std::filesystem::remove_all(folder_ / out);
  }
}

/// Kills at moments drawn evenly from the duration of a run, each time continuing what is there.
void Resume::kill_at_random_moments(int kills) const {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_shell(call("whole", "")).code, 0);
  const double duration = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0, duration);
  // timeout ends before the program that it kills: on a busy machine that one may hold its folder a little longer
  const auto next = [&](const std::string& before) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (true) {
      auto outcome =
          run_shell(before + call("parts", std::filesystem::exists(checkpoint("parts")) ? "--resume" : ""));
      const bool held = outcome.error.find("another run writes into") != std::string::npos;
      if (!held || std::chrono::steady_clock::now() > give_up) return outcome;
    }
  };
  int finished = 0;
  for (int killed = 0; killed < kills;) {
    const double at = moment(random);
    SCOPED_TRACE("killed after " + std::to_string(at) + " s");
    const auto outcome = next("timeout -s KILL " + std::to_string(at) + " ");
    expect_readable("parts");
    if (outcome.code != 137) {  // it was over before: what it made must be right, then begin anew
      ASSERT_EQ(outcome.code, 0) << outcome.error;
      expect_same("whole", "parts");
      std::filesystem::remove_all(folder_ / "parts");
      ++finished;
    } else {
      ++killed;
    }
    ASSERT_FALSE(HasFailure());
  }
  const auto last = next("");
  ASSERT_EQ(last.code, 0) << last.error;
  expect_same("whole", "parts");
  std::cout << kills << " kills within " << duration << " s, " << finished + 1
            << " runs finished with the same bytes\n";
}

TEST_F(Resume, KilledAtFiveRandomMoments) {
  kill_at_random_moments(5);
}

TEST_F(Resume, LongKilledAtAHundredRandomMoments) {
  kill_at_random_moments(100);
}

TEST_F(Resume, AnotherSceneIsRefusedWithTheDifference) {
  ASSERT_EQ(stopped("out", "INT").code, 130);
  const std::string before = content_of(checkpoint("out")), rows = series("out");
  const auto outcome = run_shell(call("out", "--resume --set material.poisson=0.4"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("material.poisson is 0.40000000000000002 here and 0.495"), std::string::npos)
      << outcome.error;
  EXPECT_EQ(content_of(checkpoint("out")), before);
  EXPECT_EQ(series("out"), rows) << "nothing was written";
}

TEST_F(Resume, AnotherVersionIsRefused) {
  ASSERT_EQ(stopped("out", "INT").code, 130);
  Checkpoint c = read_checkpoint(checkpoint("out"));
  c.program = "plumb 9.9.9";
  write_checkpoint(checkpoint("out"), c);
  const auto outcome = run_shell(call("out", "--resume"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("another version. Plumb 9.9.9; this is plumb 0."), std::string::npos)
      << outcome.error;
}

TEST_F(Resume, ADamagedCheckpointOrSeriesIsRefused) {
  ASSERT_EQ(stopped("out", "INT").code, 130);
  const std::string rows = series("out");
  std::ofstream(folder_ / "out" / "series.csv") << rows.substr(0, rows.find('\n') + 5);
  auto outcome = run_shell(call("out", "--resume"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("series.csv cannot be continued"), std::string::npos) << outcome.error;
  std::filesystem::resize_file(checkpoint("out"), 10000);
  outcome = run_shell(call("out", "--resume"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("cut off"), std::string::npos) << outcome.error;
  std::filesystem::remove(checkpoint("out"));
  // a summary that says nothing of the scene is none of a run that came to its end
  std::ofstream(folder_ / "out" / "summary.json") << R"({"status": "completed"})";
  outcome = run_shell(call("out", "--resume"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("there is no checkpoint"), std::string::npos) << outcome.error;
}

TEST_F(Resume, AFullDiskLeavesTheLastGoodCheckpoint) {
  // A limit on the size of files fails as a full disk does; the checkpoint is the only large file here.
  const std::string only = "--set output.vtk=false --set output.series=false ";
  ASSERT_EQ(stopped("out", "INT", only).code, 130);
  ASSERT_EQ(run_shell(call("whole", only)).code, 0);
  const std::string before = content_of(checkpoint("out"));
  const auto outcome = run_shell("ulimit -f 10; " + call("out", only + "--resume"));
  EXPECT_EQ(outcome.code, 1) << outcome.error;
  EXPECT_NE(outcome.error.find("checkpoint before it is intact"), std::string::npos) << outcome.error;
  EXPECT_TRUE(content_of(checkpoint("out")) == before);
  const auto files = std::filesystem::directory_iterator(folder_ / "out");
  EXPECT_EQ(std::distance(begin(files), end(files)), 2) << "a part of a file was left behind";
  ASSERT_EQ(run_shell(call("out", only + "--resume")).code, 0);
  EXPECT_EQ(summary("out"), summary("whole"));
}

TEST_F(Resume, AnUnstableRunKeepsItsLastGoodState) {
  const auto outcome = run_shell(call("out", "--set method.time_step=8e-4"));
  EXPECT_EQ(outcome.code, 1) << outcome.error;
  const json failed = summary("out");
  EXPECT_EQ(failed["status"], "unstable");
  EXPECT_TRUE(failed["failure"].contains("cause"));
  const Checkpoint last = read_checkpoint(checkpoint("out"));
  EXPECT_LE(last.state.now.step, failed["steps"].get<long>());
  EXPECT_GT(last.state.now.step, 0);
}

}  // namespace
}  // namespace plumb
