// Commands on a body in one dimension: what they say, write and find, against what is known of a bar.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "places.hpp"
#include "tests/support/run_scene.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;

const std::string scenes = PLUMBLINE_SOURCE_DIR "/verification/scenes/";
const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";

class Bar : public testing::Test {
 protected:
  Bar() : folder_(test::content_of(scenes + "ringing-bar.toml")) {}
  test::SceneFolder folder_;
};

/// After 5/4 of the period 4 L/c the end passes through zero, at the speed of the amplitude: u = A cos(omega t).
TEST_F(Bar, RingsWithItsPeriodByEveryScheme) {
  const double amplitude = 1e-4, omega = std::numbers::pi / 2 * 1000;  // c/L pi/2 [1/s]
  for (const std::string scheme : {"tlsph", "mixed", "updated", "element"}) {
    const auto ran = folder_.run(scheme, "--quiet --set method.scheme=" + scheme);
    ASSERT_EQ(ran.code, 0) << ran.error;
    const json summary = folder_.summary(scheme), end = summary["probes"]["end"];
    EXPECT_EQ(summary["dimension"], 1);
    EXPECT_EQ(summary["particles"], 51);
    // differences over one or two cells are off by (pi d/(2 L))^2/24 to /6 of the frequency, 1.6e-4 at most; the
    // updated scheme is of first order at its ends: a length that is half a cell of 50 off shifts the phase of 2.5 pi by 0.08
    EXPECT_NEAR(end["displacement"][0].get<double>() / amplitude, 0, scheme == "updated" ? 0.1 : 3e-3)
        << scheme;
    EXPECT_NEAR(end["velocity"][0].get<double>() / (amplitude * omega), -1, scheme == "updated" ? 0.1 : 2e-3)
        << scheme;
  }
}

TEST_F(Bar, WritesItsUnitsAndNoAngularMomentum) {
  const auto ran = folder_.run("out", "--set scene.max_steps=5 --set output.budget=true");
  ASSERT_EQ(ran.code, 0) << ran.error;
  EXPECT_NE(ran.out.find(" J/m^2 = kinetic "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("\"x-\" push with ("), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find(") N/m^2\n"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("  y from"), std::string::npos) << ran.out;
  const auto series = folder_.columns("out", "series.csv");
  for (const char* column :
       {"kinetic energy [J/m^2]", "strain energy [J/m^2]", "total energy [J/m^2]",
        "linear momentum x [kg/(m s)]", "end displacement x [m]", "reaction x- x [N/m^2]"})
    EXPECT_TRUE(series.contains(column)) << column;
  for (const auto& [name, values] : series) EXPECT_EQ(name.find("angular"), std::string::npos) << name;
  // pi^2/16 M A^2/L, from A^2 pi^2/4 M/2 times the mean 1/2 of the cosine's square
  EXPECT_NEAR(series.at("total energy [J/m^2]").front(), std::pow(std::numbers::pi, 2) / 16 * 3e9 * 1e-8,
              1e-3 * 18.5);
  const auto budget = folder_.columns("out", "budget.csv");
  EXPECT_TRUE(budget.contains("internal force: linear momentum x [kg/(m s)]"));
  EXPECT_TRUE(budget.contains("internal force: energy [J/m^2]"));
  for (const double gap : budget.at("gap of linear momentum")) EXPECT_LT(gap, 1e-12);
}

/// VTK reads points and vectors in space, whose other components are zero.
TEST_F(Bar, WritesFramesThatVtkReads) {
  ASSERT_EQ(folder_.run("out", "--quiet --set output.vtk=true --set scene.max_steps=5").code, 0);
  const json frames = folder_.frames("out");
  ASSERT_GE(frames.size(), 2u);
  const json& first = frames[0];
  ASSERT_EQ(first["points"].size(), 51u);
  for (std::size_t i = 0; i < 51; ++i) {
    const double X = static_cast<double>(i) / 50, u = 1e-4 * std::sin(std::numbers::pi / 2 * X);
    const json &at = first["points"][i], &moved = first["arrays"]["displacement [m]"][i];
    ASSERT_EQ(at.size(), 3u);
    EXPECT_NEAR(at[0].get<double>(), X + u, 1e-15);
    EXPECT_EQ(at[1], 0);
    EXPECT_EQ(at[2], 0);
    ASSERT_EQ(moved.size(), 3u);
    EXPECT_NEAR(moved[0].get<double>(), u, 1e-18);
    EXPECT_EQ(moved[1], 0);
  }
}

TEST_F(Bar, IsExplained) {
  for (const std::string scheme : {"tlsph", "mixed", "updated", "element"}) {
    const auto said = run_plumb("explain " + scenes + "ringing-bar.toml --set method.scheme=" + scheme);
    ASSERT_EQ(said.code, 0) << said.error;
    EXPECT_NE(said.out.find("ringing bar (1D) solves"), std::string::npos) << said.out;
    if (scheme != "tlsph") continue;
    EXPECT_NE(said.out.find("in uniaxial strain"), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("alternates"), std::string::npos) << said.out;
  }
}

TEST_F(Bar, HasItsFrequencies) {
  const auto said =
      run_plumb("spectrum " + scenes + "ringing-bar.toml --set hourglass.alpha=2 --json - --quiet");
  ASSERT_EQ(said.code, 0) << said.error;
  const json modes = json::parse(said.out)["modes"];
  for (int n = 1; n <= 3; ++n)  // (2 n - 1) c/(4 L)
    EXPECT_NEAR(modes[n - 1]["hz"].get<double>() / (250.0 * (2 * n - 1)), 1, 5e-4 * n * n)
        << n;  // (k d)^2/6 and less at d = L/50
}

TEST(StandingBar, ConvergesAtOrderTwoByEverySchemeThatIsOfOrderTwo) {
  for (const std::string scheme : {"tlsph", "element"}) {
    const auto said =
        run_plumb("mms " + studies +
                  "standing_bar.toml --quiet --json - --unfinished \"\" --set method.scheme=" + scheme +
                  (scheme == "tlsph" ? "" : " --set study.quadrature=nodal"));
    EXPECT_EQ(said.code, 0) << said.out << said.error;
    EXPECT_EQ(json::parse(said.out)["status"], "pass") << scheme;
  }
}

/// Uniform strain is an equilibrium to round-off.
TEST(StandingBar, AnAffineBarIsMetToRoundOff) {
  const auto said = run_plumb("static " + studies +
                              "affine_patch.toml --set 'body.size=[1]' --quiet --json - --unfinished \"\"");
  const json result = json::parse(said.out);
  ASSERT_EQ(result["levels"].size(), 4u) << said.error;
  for (const json& level : result["levels"]) EXPECT_LT(level["relative_l2"].get<double>(), 1e-12) << said.out;
}

}  // namespace
}  // namespace plumb
