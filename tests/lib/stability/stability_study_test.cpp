#include "lib/stability/stability_study.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lib/core/error.hpp"
#include "lib/input/scene_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

class StabilityStudyFile : public testing::Test {
 protected:
  StabilityStudyFile() {
    write(
        "scene.toml",
        "[scene]\ndimension = 2\nend_time = 1\n[body]\nsize = [1, 1]\nspacing = 0.5\n[material]\nyoung = 1\n"
        "poisson = 0.3\ndensity = 1\n");
    write("schemes.toml",
          "[[variant]]\nname = \"standard\"\nset = [\"method.gradient=standard\"]\n[[variant]]\nname = \"as "
          "written\"\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  StabilityStudy study(const std::string& more) const {
    write("study.toml",
          "[stability]\nscene = \"scene.toml\"\nparameter = \"cfl\"\nfrom = 0.1\nto = 1\n" + more);
    return read_stability_study((folder_ / "study.toml").string());
  }
  test::TemporaryFolder folder_;
};

TEST_F(StabilityStudyFile, SchemesOfAnotherFileFollowItsOwn) {
  const auto one =
      study("schemes = \"schemes.toml\"\n[[variant]]\nname = \"own\"\nset = [\"method.beta=1.2\"]\n");
  ASSERT_EQ(one.variants.size(), 3u);
  EXPECT_EQ(one.variants[0].name, "own");
  EXPECT_EQ(one.variants[1].name, "standard");
  EXPECT_EQ(one.variants[1].set, std::vector<std::string>{"method.gradient=standard"});
  EXPECT_EQ(varied_scene(one, overrides_of(one, one.variants[1], "", 0.5), 0.5).method.gradient, "standard");
}

TEST_F(StabilityStudyFile, WithoutSchemesItIsTheSceneAsWritten) {
  const auto one = study("");
  ASSERT_EQ(one.variants.size(), 1u);
  EXPECT_TRUE(one.variants[0].set.empty());
}

TEST_F(StabilityStudyFile, WhatCannotBeUsedIsToldBeforeTheFirstRun) {
  EXPECT_THROW(study("schemes = \"none.toml\"\n"), InputError);
  write("schemes.toml", "[[variant]]\nname = \"wrong\"\nset = [\"method.gradient=unheard-of\"]\n");
  EXPECT_THROW(study("schemes = \"schemes.toml\"\n"), InputError);
  write("schemes.toml", "[variants]\nname = \"misspelt\"\n");
  EXPECT_THROW(study("schemes = \"schemes.toml\"\n"), InputError);
}

/// In the study and in the list of schemes that it shares with others.
TEST_F(StabilityStudyFile, KeysThatNothingKnowsAreRefusedInEverySection) {
  const std::string own = "[[variant]]\nname = \"own\"\nset = [\"method.beta=1.2\"]\n";
  const auto refusal_of = [&](const std::string& more) -> std::string {
    try {
      study("schemes = \"schemes.toml\"\n" + more);
    } catch (const SceneError& error) {
      return std::filesystem::path(text_of(error.where())).filename().string() + " " + error.key();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal_of(own), "accepted");
  EXPECT_EQ(refusal_of("strange = 1\n" + own), "study.toml:7 stability.strange");
  EXPECT_EQ(refusal_of(own + "strange = 1\n"), "study.toml:10 variant.0.strange");
  EXPECT_EQ(refusal_of(own + "[strange]\n"), "study.toml:10 strange");
  write("schemes.toml", "[[variant]]\nname = \"standard\"\nstrange = 1\n");
  EXPECT_EQ(refusal_of(own), "schemes.toml:3 variant.0.strange");
}

}  // namespace
}  // namespace plumb
