// The section [dissipation] of a scene, and [projection] of the scheme of paper 003.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb::testing {
namespace {

/// A scene of a square with these lines.
std::string upwind_scene(const std::string& more) {
  return "[scene]\ndimension = 2\nmax_steps = 1\n[body]\nsize = [1, 1]\nspacing = 0.25\n[material]\nyoung = "
         "17e6\npoisson = 0.3\ndensity = 1100\n" +
         more;
}

TEST(DissipationScene, ASceneHasItOnlyWhereItAsks) {
  const auto without = make_tlsph<2>(parse_scene(upwind_scene(""), "a.toml", {}));
  const auto with = make_tlsph<2>(parse_scene(upwind_scene("[dissipation]\n"), "a.toml", {}));
  const auto has = [](const auto& body) {
    return std::any_of(body.solid.terms.begin(), body.solid.terms.end(),
                       [](const auto& term) { return term.name == "dissipation"; });
  };
  EXPECT_FALSE(has(without));
  ASSERT_TRUE(has(with));
  EXPECT_LT(with.solid.step_limit, 1);
  EXPECT_EQ(without.solid.step_limit, std::numeric_limits<double>::max());
  for (const auto& entry : arrays_of(with)) {
    if (entry.name == "dissipation") {
      EXPECT_GT(entry.bytes, 0U);
    }
  }
}

/// What is said against these lines; empty if nothing.
std::string dissipation_refusal(const std::string& more) {
  try {
    parse_scene(upwind_scene(more), "a.toml", {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DissipationScene, RefusesWhatItWouldContradict) {
  const auto refused = [](const std::string& more, const std::string& part) {
    return dissipation_refusal(more).find(part) != std::string::npos;
  };
  EXPECT_EQ(dissipation_refusal("[dissipation]\nkind = \"upwind\"\n"), "");
  EXPECT_EQ(dissipation_refusal("[dissipation]\n[jst]\n"), "");
  EXPECT_TRUE(refused("[dissipation]\nkind = \"jst\"\n", "upwind"));
  EXPECT_TRUE(refused("[dissipation]\n[method]\nmomentum = \"symmetrised\"\n", "contradicts momentum"));
  EXPECT_TRUE(refused("[dissipation]\n[method]\nscheme = \"mixed\"\n", "[mixed] upwind"));
  EXPECT_TRUE(refused("[dissipation]\n[method]\nscheme = \"updated\"\n", "part of scheme"));
  EXPECT_EQ(dissipation_refusal("[projection]\n[method]\nscheme = \"mixed\"\n"), "");
  EXPECT_TRUE(refused("[projection]\n[method]\nscheme = \"mixed\"\n[mixed]\nsmooth_positions = true\n",
                      "contradicts [mixed] smooth_positions"));
}

}  // namespace
}  // namespace plumb::testing
