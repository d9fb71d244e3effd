#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(PLUMBLINE_SOURCE_DIR "/verification/scenes"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

TEST(Scenes, EveryOneRunsItsFirstSteps) {
  ASSERT_FALSE(scenes().empty());
  for (const auto& scene : scenes()) {
    const test::TemporaryFolder folder;
    const auto outcome =
        test::run_plumb("run " + scene.string() + " --set scene.max_steps=3 --quiet --json - --out " +
                        (folder / "out").string());
    // a body that looks for rest has not found it after three steps, and the run says so
    const bool relaxes = test::content_of(scene).find("\n[relaxation]") != std::string::npos;
    ASSERT_EQ(outcome.code, relaxes ? 1 : 0) << scene << ": " << outcome.error;
    const auto summary = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(summary["status"], relaxes ? "unstable" : "completed") << scene;
    // an equilibrium may need fewer
    const int least = summary["scheme"] == "implicit" ? 1 : 3;
    EXPECT_GE(summary["steps"], least) << scene;
    EXPECT_LE(summary["steps"], 3) << scene;
  }
}

TEST(Scenes, EveryOneSaysInItsFirstLineWhatItShows) {
  for (const auto& scene : scenes()) EXPECT_EQ(test::content_of(scene).front(), '#') << scene;
}

}  // namespace
}  // namespace plumb
