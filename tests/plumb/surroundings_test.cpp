// What surrounds a call: a missing temporary folder, a full device, the current folder.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/support/program.hpp"

namespace plumb::surroundings_test {
namespace {

using test::run_shell;
const std::string plumb = PLUMB_EXECUTABLE, root = PLUMBLINE_SOURCE_DIR;
const std::string scene = root + "/verification/scenes/swinging-plate.toml --set scene.max_steps=2",
                  plate = root +
                          "/verification/studies/swinging_plate.toml --set study.spacings=[0.5,0.25] "
                          "--set study.periods=0.1 --set study.quadrature=nodal";

/// A call of every command that says something; none of them needs a temporary file.
const std::vector<std::string> calls{
    "",
    "--help",
    "--version",
    "run --help",
    "oned",
    "list",
    "faults " + root + "/verification/faults/score.json",
    "claims",
    "manual",
    "completion bash",
    "explain " + scene,
    "run " + scene + " --out OUT",
    "extrapolate --spacings 4,2,1 --values 1,1.1,1.15",
    "mms --list",
    "mms --check swinging-plate --points 10",
    "mms " + plate,
    "oned kernels --at 0.1",
    "oned correction --points 5",
    "oned function --n 8",
    "oned gradient --field sin:5 --n 10",
    "oned study --n 20,40,80,160",
    "oned response",
    "operators " + root + "/verification/studies/operators.toml --set study.spacings=[0.1,0.05]",
    "spectrum " + root + "/verification/scenes/swinging-plate.toml --set body.spacing=0.5",
};

std::string with_folder(std::string call, const test::TemporaryFolder& folder) {
  if (const auto at = call.find("OUT"); at != std::string::npos)
    call.replace(at, 3, (folder / "out").string());
  return "cd " + folder.path().string() + "; HOME=" + folder.path().string() + " " + plumb + " " + call;
}

TEST(Surroundings, AMissingTemporaryFolderHurtsNothing) {
  for (const auto& call : calls) {
    const test::TemporaryFolder folder;
    const std::string line = with_folder(call, folder);
    const auto with = run_shell(line), without = run_shell("export TMPDIR=/nonexistent; " + line);
    EXPECT_EQ(without.code, with.code) << call << ": " << without.error;
    EXPECT_EQ(without.error.find("temp"), std::string::npos) << call << ": " << without.error;
  }
}

TEST(Surroundings, TextThatAFullDeviceLosesIsAnError) {
  for (const auto& call : calls) {
    const test::TemporaryFolder folder;
    const auto outcome = run_shell("(" + with_folder(call, folder) + " > /dev/full)");
    EXPECT_EQ(outcome.code, 1) << call;
    EXPECT_NE(outcome.error.find("cannot write to standard output"), std::string::npos)
        << call << ": " << outcome.error;
  }
}

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

TEST(Surroundings, StudiesLeaveNothingInTheCurrentFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "here");
  const std::string study = root + "/verification/stability/small-motion.toml";
  const std::string in = "cd " + (folder / "here").string() + "; export HOME=" + (folder / "home").string() +
                         "; unset XDG_CACHE_HOME; " + plumb;
  ASSERT_LE(run_shell(in + " mms " + plate).code, 1);
  ASSERT_LE(run_shell(in + " oned study --n 20,40,80,160").code, 1);
  const auto stability = run_shell(in + " stability " + study + " --threads 1");
  ASSERT_EQ(stability.code, 0) << stability.error;
  EXPECT_TRUE(files_in(folder / "here").empty());
  const auto kept = folder / "home/.cache/plumb/stability";
  EXPECT_FALSE(files_in(kept).empty());
  EXPECT_NE(stability.out.find("kept in " + kept.string()), std::string::npos) << stability.out;
}

TEST(Surroundings, AnInterruptedStudyWaitsInTheCacheOfItsUserAndSaysSo) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder / "here");
  const std::string kept = (folder / "cache/plumb/unfinished-studies").string();
  for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 129)}) {
    const auto ended = run_shell(
        "cd " + (folder / "here").string() + "; export XDG_CACHE_HOME=" + (folder / "cache").string() + "; " +
        plumb +
        " oned study --n 40000,80000,160000,320000,640000,1280000,2560000 "
        "--radius-over-dx 4 --threads 1 & run=$!; until ls " +
        kept + "/*.kept >/dev/null 2>&1 || ! kill -0 $run 2>/dev/null; do sleep 0.01; done; kill -" + signal +
        " $run; wait $run");
    EXPECT_EQ(ended.code, code) << ended.error;
    EXPECT_NE(ended.error.find("kept in " + kept), std::string::npos) << ended.error;
    std::filesystem::remove_all(folder / "cache");  // the next call must be seen to have begun
  }
  EXPECT_TRUE(files_in(folder / "here").empty());
}

TEST(Surroundings, NoCommandKeepsResultsWhereAllUsersDo) {
  // without a home there is no place that belongs to this user
  const auto outcome = run_shell("unset HOME XDG_CACHE_HOME; " + plumb + " claims --check");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("--store"), std::string::npos) << outcome.error;
  EXPECT_EQ(run_shell(plumb + " claims --help").out.find("/tmp"), std::string::npos);
}

TEST(Surroundings, AFileWithoutANameIsNotMade) {
  const test::TemporaryFolder folder;
  for (const char* name : {"''", "sub/", ".", "..", ".toml"})
    for (const char* kind : {"scene", "study"}) {
      const auto outcome = run_shell("cd " + folder.path().string() + "; mkdir -p sub; " + plumb + " new " +
                                     kind + " " + name);
      EXPECT_EQ(outcome.code, 2) << name;
      EXPECT_NE(outcome.error.find("names no file"), std::string::npos) << outcome.error;
    }
  EXPECT_EQ(files_in(folder.path()), std::set<std::string>{"sub"});
  EXPECT_TRUE(files_in(folder / "sub").empty());
}

TEST(Surroundings, ThreadsThatWaitSleepUnlessTheUserSaysOtherwise) {
  const auto turns = [](const std::string& setting) {  // in a loop, before they sleep: GNU's runtime shows it
    return run_shell(setting + "; export OMP_DISPLAY_ENV=verbose; " + plumb +
                     " oned kernels --at 0.1 --threads 2 2>&1 "
                     "| grep GOMP_SPINCOUNT | tail -1")
        .out;
  };
  const std::string chosen = turns("export OMP_WAIT_POLICY=active");
  if (chosen.empty() || run_shell("[ $(nproc) -gt 1 ]").code != 0)
    GTEST_SKIP() << "another runtime, or one core";
  EXPECT_NE(turns("unset OMP_WAIT_POLICY GOMP_SPINCOUNT").find("'0'"), std::string::npos);
  EXPECT_EQ(chosen.find("'0'"), std::string::npos);
}

}  // namespace
}  // namespace plumb::surroundings_test
