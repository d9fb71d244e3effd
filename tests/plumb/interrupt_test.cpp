// Ctrl-C during a study keeps every finished part, and the next call makes only the others: the numbers are
// those of a study that was never interrupted.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::interrupt_test {
namespace {

using nlohmann::json;
using test::run_shell;
const std::string root = PLUMBLINE_SOURCE_DIR, plumb = PLUMB_EXECUTABLE;

/// Runs the call and ends it by Ctrl-C as soon as it has finished `count` files whose names hold the text.
test::Outcome interrupted_at(const std::string& file, int count, const std::string& call) {
  return run_shell("PLUMB_TEST_INTERRUPT_AT=" + file + " PLUMB_TEST_INTERRUPT_COUNT=" +
                   std::to_string(count) + " LD_PRELOAD=" INTERRUPT_AT " " + call);
}

/// The result without what depends on the clock, the machine and the command line.
void drop_times(json& value) {
  if (value.is_object())
    for (const char* key : {"cpu_s", "cpu_spread_s", "wall_s", "setup_s", "solve_s", "command", "provenance",
                            "front_cpu", "cheapest"})
      value.erase(key);
  for (auto& part : value)
    if (part.is_structured()) drop_times(part);
}

class Interrupt : public testing::TestWithParam<std::pair<const char*, std::string>> {
 protected:
  std::string call(const std::string& more) const {
    return plumb + " " + GetParam().second + " --threads 1 --unfinished " + kept() + " " + more;
  }
  std::string kept() const { return (folder_ / "kept").string(); }
  json result(const std::string& name) const {
    json all = json::parse(test::content_of(folder_ / name));
    drop_times(all);
    return all;
  }
  std::string to(const std::string& name) const { return "--json " + (folder_ / name).string(); }

  test::TemporaryFolder folder_;
};

TEST_P(Interrupt, FinishedPartsAreKeptAndUsed) {
  ASSERT_LE(run_shell(call(to("whole.json"))).code, 1);
  EXPECT_FALSE(std::filesystem::exists(kept())) << "a whole study leaves nothing behind";
  const auto ended = interrupted_at(kept() + "/", 1, call(to("none.json")));
  ASSERT_EQ(ended.code, 130) << ended.error;
  ASSERT_NE(ended.error.find("finished parts are kept in"), std::string::npos) << ended.error;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.json"));
  const auto rest = run_shell(call(to("rest.json")));
  EXPECT_NE(rest.out.find("parts are of an earlier call"), std::string::npos) << rest.out;
  EXPECT_FALSE(std::filesystem::exists(kept()));
  const json whole = result("whole.json"), continued = result("rest.json");
  if (std::string(GetParam().first) == "Bench")
    EXPECT_EQ(continued["rows"].size(), whole["rows"].size());  // speeds are never the same twice
  else
    EXPECT_EQ(continued, whole);
}

const std::string plate = root + "/verification/studies/swinging_plate_finite_strain.toml";
INSTANTIATE_TEST_SUITE_P(
    Study, Interrupt,
    testing::Values(
        std::pair("Levels",
                  "mms " + root + "/verification/studies/swinging_plate.toml --set study.quadrature=nodal"),
        std::pair("TimeSteps", "mms --temporal " + root +
                                   "/verification/studies/time_step_plate.toml --set study.periods=0.5"),
        std::pair("WorkPrecision",
                  "mms --work-precision " + plate +
                      " --vary method.integrator=rk3,verlet --set study.spacings=[0.2,0.1,0.05]"),
        std::pair(
            "Static",
            "static " + root +
                "/verification/studies/static_plate.toml --set "
                "study.spacings=[0.1,0.08,0.0625,0.05,0.04,0.03125,0.025] --set method.gradient=improved"),
        std::pair(
            "Line",
            std::string(
                "oned study --n 40000,80000,160000,320000,640000,1280000 --estimator standard,improved,bond "
                "--radius-over-dx 4")),
        std::pair("Bench", std::string("bench --n 1000,8000 --repeats 1 --seconds 0.1"))),
    [](const auto& test) { return std::string(test.param.first); });

/// A stability study keeps every run for ever: what is finished is never run again.
TEST(InterruptStability, FinishedRunsAreKept) {
  const test::TemporaryFolder folder;
  const std::string cache = (folder / "cache").string();
  const std::string call = plumb + " stability " + root +
                           "/verification/stability/small-motion.toml --threads 1 --cache " + cache +
                           " --json " + (folder / "result.json").string();
  const auto ended = interrupted_at(cache + "/", 5, call);
  ASSERT_EQ(ended.code, 130) << ended.error;
  EXPECT_EQ(json::parse(test::content_of(folder / "result.json"))["status"], "interrupted");
  const auto count = [&] { return std::distance(std::filesystem::directory_iterator(cache), {}); };
  const auto before = count();
  ASSERT_GE(before, 5);
  ASSERT_EQ(run_shell(call).code, 0);
  long runs = 0;
  const json whole = json::parse(test::content_of(folder / "result.json"));
  for (const auto& row : whole["rows"]) runs += row["runs"].get<long>();
  EXPECT_EQ(count(), runs) << "each run was made once, before or after the interruption";
  EXPECT_GT(runs, before);
}

/// A report keeps every finished study in its store.
TEST(InterruptReport, FinishedStudiesAreStored) {
  const test::TemporaryFolder folder;
  const std::string call = plumb + " report --only kernels,gradients,refinement --threads 1 --root " + root +
                           " --out " + (folder / "out").string();
  const auto ended = interrupted_at("/cost.json", 1, call);
  ASSERT_EQ(ended.code, 130) << ended.out;
  EXPECT_NE(ended.error.find("studies are finished and stored"), std::string::npos) << ended.error;
  const auto rest = run_shell(call);
  EXPECT_EQ(rest.code, 0) << rest.error;
  EXPECT_EQ(rest.out.find(" 0 of them stored ones"), std::string::npos) << rest.out;
}

}  // namespace
}  // namespace plumb::interrupt_test
