// Law of every reader: a key that nothing knows is refused with its line, in every section of every scene and
// study of the repository.
#include <gtest/gtest.h>

#include <filesystem>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/study.hpp"
#include "places.hpp"
#include "tests/support/strange_keys.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

const std::filesystem::path tree = PLUMBLINE_SOURCE_DIR "/verification";

std::vector<std::filesystem::path> files_in(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(tree / folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

template <class Parse>
void expect_refused(const std::filesystem::path& file, Parse&& parse) {
  for (const auto& strange : test::with_strange_keys(test::content_of(file))) {
    SCOPED_TRACE(file.filename().string() + ": " + strange.section);
    if (strange.section == "[study.parameters]") continue;  // the solution knows which there are
    try {
      parse(strange.text, file.string());
      ADD_FAILURE() << "accepted";
    } catch (const SceneError& error) {
      EXPECT_EQ(error.where().line, strange.line) << error.what();
      EXPECT_TRUE(error.key().ends_with("strange_key")) << error.what();
    }
  }
}

TEST(StrangeKeys, AreRefusedInEverySectionOfAScene) {
  for (const auto& file : files_in("scenes"))
    expect_refused(file, [](const std::string& text, const std::string& name) { parse_scene(text, name); });
}

TEST(StrangeKeys, AreRefusedInEverySectionOfAStudy) {
  for (const auto& file : files_in("studies"))
    expect_refused(file, [](const std::string& text, const std::string& name) { parse_study(text, name); });
}

}  // namespace
}  // namespace plumb
