// `plumb list` against what the readers of scenes accept.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "lib/core/error.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/read_scene.hpp"
#include "mms/manufactured.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;

/// A scene in which the key can stand.
const std::string scene = R"([scene]
dimension = 3
end_time = "1 ms"
[body]
size = [1, 1, 1]
spacing = 0.5
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[jst]
[[boundary]]
face = "x-"
kind = "clamped"
)";

std::vector<std::string> changes_for(const std::string& key, const std::string& name) {
  std::vector<std::string> changes{key + "=\"" + name + "\""};
  if (key.starts_with("compatible.")) changes.insert(changes.begin(), "method.gradient=compatible");
  return changes;
}

/// What the reader says to the name; empty if it has no objection to it as a name.
std::string objection(const std::string& key, const std::string& name) {
  try {
    parse_scene(scene, "a.toml", changes_for(key, name));
  } catch (const InputError& error) {
    if (error.problem().find("unknown ") != std::string::npos) return error.why();
  }
  return "";
}

std::set<std::string> listed(const json& list, const std::string& key) {
  std::set<std::string> names;
  for (const auto& part : list["parts"])
    if (part["key"] == key) names.insert(part["name"]);
  return names;
}

json list() {
  const auto outcome = test::run_plumb("list --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return json::parse(outcome.out);
}

TEST(List, NamesWhatTheReadersAcceptAndNothingElse) {
  const json shown = list();
  for (const auto& choice : scene_choices()) {
    SCOPED_TRACE(choice.key);
    EXPECT_EQ(listed(shown, choice.key), std::set(choice.names.begin(), choice.names.end()));
    for (const auto& name : choice.names) EXPECT_EQ(objection(choice.key, name), "") << name;
    // a name that is none: the reader tells all that are
    EXPECT_EQ(objection(choice.key, "zzz"), "valid: " + join(choice.names));
  }
}

/// A reader that lets a new key choose from names must tell it here.
TEST(List, KnowsEveryKeyThatChoosesFromNames) {
  std::set<std::string> keys, known;
  for (const char* file : {"scene/read_scene", "scene/read_body", "scene/read_parts", "scene/read_method",
                           "scene/read_material", "schemes/tlsph/parts/jst_options"}) {
    std::ifstream in(std::string(PLUMBLINE_SOURCE_DIR "/lib/") + file + ".cpp");
    ASSERT_TRUE(in) << file;
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    const std::regex call(R"x(choice_or\(\s*\{?"([a-z_]+)")x");
    for (std::sregex_iterator match(text.begin(), text.end(), call), end; match != end; ++match)
      keys.insert((*match)[1]);
  }
  for (const auto& choice : scene_choices()) known.insert(choice.key.substr(choice.key.rfind('.') + 1));
  EXPECT_EQ(keys, known);
}

TEST(List, NamesSolutionsEstimatorsAndUnits) {
  const json shown = list();
  std::set<std::string> solutions;
  for (const auto& entry : mms::solution_list()) solutions.insert(entry.name);
  EXPECT_EQ(listed(shown, "study.solution"), solutions);
  EXPECT_TRUE(listed(shown, "--estimator of plumb oned").contains("bond"));
  EXPECT_TRUE(listed(shown, "any quantity").contains("rpm"));
  for (const char* key : {"kernels", "gradients", "momenta", "integrators", "materials", "pairs", "shapes",
                          "clouds", "layouts", "boundary_kinds", "wave_speeds", "solutions", "units"})
    EXPECT_FALSE(shown[key].empty()) << key;
}

TEST(List, SaysOfEveryNameWhatItMeans) {
  const json parts = list()["parts"];  // a copy: a part of a temporary would be gone in the loop
  ASSERT_GT(parts.size(), 80u);
  for (const auto& part : parts) EXPECT_NE(part["meaning"], "") << part;
}

TEST(List, ShowsTheScenesWithWhatTheyShow) {
  const json listed = json::parse(test::run_plumb("list --json -").out);
  const std::string text = test::run_plumb("list").out;
  ASSERT_GT(listed["scenes"].size(), 5u);
  for (const json& one : listed["scenes"]) {
    const std::string name = one["name"], shows = one["shows"];
    EXPECT_NE(text.find("\n  " + name + "\n      "), std::string::npos) << name;
    EXPECT_NE(text.find(shows.substr(0, shows.find(' ', 10))), std::string::npos) << shows;
  }
}

TEST(List, FitsATerminalOf80Columns) {
  for (const char* command : {"list", "claims", "faults",
                              "explain " PLUMBLINE_SOURCE_DIR "/verification/scenes/bending-column.toml"}) {
    std::istringstream lines(test::run_plumb(std::string(command) + " --threads 1").out);
    for (std::string line; std::getline(lines, line);) {
      const auto characters =
          std::count_if(line.begin(), line.end(), [](char c) { return (c & '\xc0') != '\x80'; });
      const bool one_word = line.find_first_of(' ', line.find_first_not_of(' ')) == std::string::npos;
      EXPECT_TRUE(characters <= 80 || one_word) << command << ": " << line;
    }
  }
}

}  // namespace
}  // namespace plumb
