// What plumb spectrum writes beside the eigenvalues: the mode of least energy, and the scheme on the infinite
// lattice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_plumb;
const std::string scenes = PLUMBLINE_SOURCE_DIR "/verification/scenes/";

TEST(SpectrumCommand, TheWorstModeIsTheLowestOne) {
  const auto outcome = run_plumb(
      "spectrum " + scenes + "free_plate.toml --set method.gradient=standard --set method.beta=1.2 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json result = json::parse(outcome.out), worst = result["worst"];
  EXPECT_EQ(worst["value"], result["lowest_nonrigid"]);
  EXPECT_EQ(worst["value"], result["modes"][0]["value"]);
  EXPECT_TRUE(worst["spurious"].get<bool>()) << "method.md: modes of nearly no energy appear for beta 1.2";
  ASSERT_EQ(worst["u"].size(), 100u);
  double largest = 0, sum = 0;
  for (const auto& u : worst["u"])
    largest = std::max({largest, std::abs(u[0].get<double>()), std::abs(u[1].get<double>())});
  for (const auto& u : worst["u"]) sum += u[0].get<double>();
  EXPECT_DOUBLE_EQ(largest, 1);
  EXPECT_NEAR(sum, 0, 1e-9) << "it is orthogonal to the rigid motions; equal masses";
}

TEST(SpectrumCommand, OnTheLatticeTheEigenvaluesFollowFromTheGradient) {
  for (const char* scene : {"free_plate.toml", "free_cube.toml"}) {
    const auto outcome =
        run_plumb("spectrum " + scenes + scene + " --symbol 8 --set method.momentum=adjoint --json -");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const json rows = json::parse(outcome.out)["rows"];
    const double nu = std::string(scene) == "free_plate.toml" ? 0.3 : 0.495;
    const double shear = (1 - 2 * nu) / (2 - 2 * nu);  // (C_s/C_p)^2
    ASSERT_EQ(rows.size(), std::string(scene) == "free_plate.toml" ? 16u : 24u);
    for (const auto& row : rows) {
      const std::string direction = row["direction"];
      const auto axes = static_cast<double>(std::count(direction.begin(), direction.end(), '1'));
      const double theta = row["theta"], g2 = axes * std::pow(row["gradient"].get<double>() * theta, 2);
      // THEORY (9.5): |g|^2 once and (C_s/C_p)^2 |g|^2 otherwise; rounding of sums of some ten terms
      EXPECT_NEAR(row["largest"].get<double>(), g2, 1e-13);
      EXPECT_NEAR(row["lowest"].get<double>(), shear * g2, 1e-13);
      if (theta > 3.14) {
        EXPECT_NEAR(row["gradient"].get<double>(), 0, 1e-14) << "an alternating motion is not seen";
      }
      if (theta < 0.4) {
        EXPECT_NEAR(row["gradient"].get<double>(), 1, axes * theta * theta) << "second order";
      }
    }
  }
}

TEST(SpectrumCommand, APictureNeedsOneBody) {
  const test::TemporaryFolder folder;
  const std::string plot = " --plot " + (folder / "mode.svg").string();
  EXPECT_EQ(run_plumb("spectrum " + scenes + "free_plate.toml" + plot).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "mode.svg"));
  EXPECT_EQ(run_plumb("spectrum " + scenes + "free_plate.toml --symbol 4" + plot).code, 2);
}

}  // namespace
}  // namespace plumb
