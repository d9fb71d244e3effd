// The section [mixed], and what the scheme refuses.
#include "lib/schemes/mixed/mixed_options.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "lib/input/section.hpp"
#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

MixedOptions read(const std::string& keys) {
  const TomlValue document = parse_document("[mixed]\n" + keys, "a.toml");
  const Section section(*document.find("mixed"), "mixed");
  const MixedOptions options = MixedOptions::read(section, {});
  section.reject_unknown();
  return options;
}

std::string refusal(const std::string& keys) {
  try {
    read(keys);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MixedOptions, AnEmptySectionHasTheDefaults) {
  const MixedOptions o = read("");
  EXPECT_EQ(o.volumes, "equal");
  EXPECT_EQ(o.kinematics, "tied");
  EXPECT_EQ(o.upwind, "adjoint");
  EXPECT_EQ(o.option, 0);
  EXPECT_EQ(o.update_every, 1);
  EXPECT_FALSE(o.smooth_positions);
  EXPECT_EQ(o.list, 1.75);
  EXPECT_TRUE(o.warnings().empty());
}

TEST(MixedOptions, EveryKeyIsRead) {
  const MixedOptions o = read(
      "volumes = \"tributary\"\nkinematics = \"evolved\"\nupwind = \"constant\"\noption = 4\nupdate_every = "
      "30\n"
      "smooth_positions = true\nlist = 2.1\n");
  EXPECT_EQ(o.volumes, "tributary");
  EXPECT_TRUE(o.evolves_HJ());
  EXPECT_EQ(o.upwind, "constant");
  EXPECT_EQ(o.option, 4);
  EXPECT_EQ(o.update_every, 30);
  EXPECT_TRUE(o.smooth_positions);
  EXPECT_EQ(o.list, 2.1);
  EXPECT_TRUE(contains(o.in_words(), "reference by option 4 every 30 steps"));
}

TEST(MixedOptions, BadValuesAreRefused) {
  EXPECT_TRUE(contains(refusal("option = 5"), "there is no option 5"));
  EXPECT_TRUE(contains(refusal("update_every = 0"), "update_every"));
  EXPECT_TRUE(contains(refusal("list = 1"), "holds no neighbour"));
  EXPECT_TRUE(contains(refusal("upwind = \"adjiont\""), "adjoint"));
  EXPECT_TRUE(contains(refusal("volume = \"equal\""), "volumes"));
}

TEST(MixedOptions, WarningsNameWhatIsKnownToFail) {
  const auto warned = [](const std::string& keys, const std::string& part) {
    for (const std::string& warning : read(keys).warnings())
      if (contains(warning, part)) return true;
    return false;
  };
  EXPECT_TRUE(warned("option = 3", "smooth_positions"));
  EXPECT_FALSE(warned("option = 3\nsmooth_positions = true", "smooth_positions"));
  EXPECT_TRUE(warned("kinematics = \"evolved\"", "gain energy"));
  EXPECT_TRUE(warned("upwind = \"reconstructed\"", "feed energy"));
  EXPECT_TRUE(warned("option = 2", "results of option 0"));
  EXPECT_FALSE(warned("option = 2\nupwind = \"constant\"", "results of option 0"));
}

TEST(MixedScheme, LawsThatAreNotOfFHAndJAreRefusedWhereTheseEvolve) {
  const auto refused = [](const LawChoice& law) {
    try {
      mixed_body(cube<2>(3), mixed_options("none", "evolved"), {}, law);
    } catch (const InputError& error) {
      return contains(error.what(), "not a law of F, H and J");
    }
    return false;
  };
  EXPECT_TRUE(refused(LawChoice("saint-venant-kirchhoff")));
  EXPECT_TRUE(refused(LawChoice("neo-hookean", {}, Plane::stress)));
  EXPECT_FALSE(refused(LawChoice("neo-hookean")));
  EXPECT_FALSE(refused(LawChoice("polyconvex", {{"share", 0.4}})));
  EXPECT_THROW(mixed_body(cube<2>(3), MixedOptions(), {}, LawChoice("nothing")), InputError);
  EXPECT_THROW(mixed_body(cube<2>(3), MixedOptions(), {},
                          LawChoice("j2-logarithmic", {{"yield", 1e6}}, Plane::stress)),
               InputError);
}

TEST(MixedScheme, TheAccountSaysWhatIsChosen) {
  MixedOptions o;
  o.option = 3;
  const auto body = mixed_body(cube<2>(3), o);
  const auto said = body.account();
  ASSERT_EQ(said.size(), 4U);
  EXPECT_TRUE(contains(said[0].text, "equal volumes, H = cof F, J = det F, upwinding adjoint"));
  EXPECT_TRUE(contains(said[1].text, "at most 8 neighbours"));
  EXPECT_EQ(said.back().topic, "reference");
  ASSERT_EQ(body.warnings().size(), 1U);
  EXPECT_TRUE(contains(body.warnings()[0], "smooth_positions"));
}

}  // namespace
}  // namespace plumb::testing
