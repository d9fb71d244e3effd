// No key of a study is passed over in silence: what a command does not look at is refused with its place, or
// listed.
#include <gtest/gtest.h>

#include <algorithm>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/scene/unused_keys.hpp"

namespace plumb {
namespace {

/// A study with every key that some command does not look at, each on a line of its own.
const std::string head = R"toml([study]
solution = "swinging-plate"
spacings = [0.5]
periods = 1
)toml",
                  body = R"toml([body]
size = [2, 2]
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
)toml";

std::string study(const std::string& of_study, const std::string& behind = "") {
  return head + of_study + "\n" + body + behind;
}

std::string refusal(const std::string& text, StudyOf use, const std::vector<std::string>& overrides = {}) {
  try {
    parse_study(text, "study.toml", overrides, {}, use);
  } catch (const SceneError& error) {
    return text_of(error.where()) + " " + error.key();
  }
  return "taken";
}

TEST(UnusedKeys, OfATimeStepAreRefusedInTheFile) {
  const auto refused = [](const std::string& text) { return refusal(text, StudyOf::time); };
  EXPECT_EQ(refused(study("quadrature = \"gauss\"")), "study.toml:5 study.quadrature");
  EXPECT_EQ(refused(study("", "[expect]\nl2 = 2\nreason = \"so\"\n")), "study.toml:12 expect");
  EXPECT_EQ(refused(study("", "[method]\nintegrator = \"rk3\"\n")), "study.toml:13 method.integrator");
  EXPECT_EQ(refused(study("", "[method]\nwave_speed = \"stretch\"\n")), "study.toml:13 method.wave_speed");
  std::string several = study("", "[method]\ncfl = 0.2\nbeta = 1.2\n");
  EXPECT_EQ(refused(several), "taken");
  several.replace(several.find("[0.5]"), 5, "[0.5, 0.25]");
  EXPECT_EQ(refused(several), "study.toml:3 study.spacings");
  EXPECT_EQ(refusal(several, StudyOf::space), "taken");
}

TEST(UnusedKeys, OfTheCallAreRefusedByEveryUse) {
  const std::string plain = study("");
  const auto refused = [&](StudyOf use, const std::string& set) {
    return refusal(plain, use, {set, "expect.reason=so"});
  };
  using enum StudyOf;
  for (const StudyOf use : {equilibrium, operators}) {
    for (const char* set :
         {"study.quadrature=nodal", "study.held_band=0.1", "study.force=none", "method.integrator=rk3",
          "method.cfl=0.1", "method.time_step=1e-6", "method.wave_speed=stretch", "damping.rate=3"}) {
      const std::string change = set;
      EXPECT_EQ(refusal(plain, use, {change}), "--set " + change.substr(0, change.find('='))) << set;
      EXPECT_EQ(refusal(plain, space, {change}), "taken") << set;
    }
  }
  EXPECT_EQ(refused(cost, "expect.l2=2"), "--set expect.l2");
  EXPECT_EQ(refused(operators, "expect.l2=2"), "--set expect.l2");
  EXPECT_EQ(refused(time, "expect.l2=2"), "--set expect.l2");
  EXPECT_EQ(refused(equilibrium, "expect.l2=2"), "taken");
  EXPECT_EQ(refused(equilibrium, "expect.velocity_l2=2"), "--set expect.velocity_l2");
  EXPECT_EQ(refusal(plain, cost, {"study.quadrature=nodal"}), "--set study.quadrature");
  EXPECT_EQ(refusal(plain, equilibrium, {"jst.eta2=1"}), "--set jst.eta2");
  EXPECT_EQ(refusal(plain, operators, {"jst.eta4=1"}), "--set jst.eta4");
  EXPECT_EQ(refusal(plain, operators, {"jst.laplacian_factor=1"}), "taken");
}

// An order that is declared and never judged is refused in a file too; what only describes the run is listed.
TEST(UnusedKeys, OfAFileAreListedOrRefused) {
  const std::string steps = study("", "[method]\nintegrator = \"rk3\"\ncfl = 0.2\n");
  EXPECT_TRUE(parse_study(steps, "study.toml").unused.empty());
  const auto listed = parse_study(steps, "study.toml", {}, {}, StudyOf::equilibrium).unused;
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[0], "method.integrator is not used by this command: nothing is stepped in time");
  EXPECT_EQ(listed[1], "method.cfl is not used by this command: nothing is stepped in time");
  const std::string declared = study("", "[expect]\nvelocity_l2 = 2\nreason = \"so\"\n");
  EXPECT_EQ(refusal(declared, StudyOf::equilibrium), "study.toml:13 expect.velocity_l2");
  const auto orders = parse_study(declared, "study.toml", {}, {}, StudyOf::operators).unused;
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].substr(0, 30), "[expect] is not used by this c");
}

/// A scene goes from one scheme to another by --set: what Newton's method does not use is said, and not refused.
TEST(UnusedKeys, OfNewtonsMethodAreListed) {
  const std::string text = R"toml([scene]
dimension = 2
end_time = 1
[body]
size = [2, 2]
spacing = 0.5
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = "tlsph"
cfl = 0.3
integrator = "rk3"
wave_speed = "stretch"
[damping]
rate = 3
)toml";
  EXPECT_TRUE(parse_scene(text, "scene.toml").method.unused.empty());
  const Scene scene = parse_scene(text, "scene.toml", {"method.scheme=implicit"});
  const std::vector<std::string> said{
      "method.cfl is not used by scheme = \"implicit\": Newton's method has no stability limit",
      "method.wave_speed is not used by scheme = \"implicit\": Newton's method has no stability limit",
      "method.integrator is not used by scheme = \"implicit\": [implicit] says how steps are made",
      "[damping] is not used by scheme = \"implicit\": a damping has no energy"};
  EXPECT_EQ(scene.method.unused, said);
  const auto warnings = make_simulation<2>(scene).simulation.warnings;
  for (const std::string& sentence : said)
    EXPECT_NE(std::find(warnings.begin(), warnings.end(), sentence), warnings.end()) << sentence;
}

}  // namespace
}  // namespace plumb
