#include "lib/stability/stability_study.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "lib/core/error.hpp"
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

}  // namespace
}  // namespace plumb
