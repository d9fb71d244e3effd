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
    ASSERT_EQ(outcome.code, 0) << scene << ": " << outcome.error;
    const auto summary = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(summary["status"], "completed") << scene;
    EXPECT_EQ(summary["steps"], 3) << scene;
  }
}

TEST(Scenes, EveryOneSaysInItsFirstLineWhatItShows) {
  for (const auto& scene : scenes()) EXPECT_EQ(test::content_of(scene).front(), '#') << scene;
}

}  // namespace
}  // namespace plumb
