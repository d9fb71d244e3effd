// What plumb spectrum writes beside the eigenvalues: the mode of least energy, and the scheme on the infinite
// lattice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::spectrum_test {
namespace {

using nlohmann::json;
using test::run_plumb;
const std::string scenes = PLUMBLINE_SOURCE_DIR "/verification/scenes/";

/// The bar of 1 x 0.2 m under its weight, whose law is linear: its frequencies are those of a cantilever.
TEST(SpectrumCommand, ALoadedStateHasItsFrequencies) {
  const std::string bar = scenes + "weighing-bar.toml";
  const auto outcome = run_plumb("spectrum " + bar + " --modes 3 --json - --at end");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["unstable"], 0);
  EXPECT_EQ(result["time"], 1);
  ASSERT_EQ(result["modes"].size(), 3u);
  // 1.8751^2/(2 pi L^2) sqrt(E I/(rho A)); shear takes some percent of so short a beam
  const double bending =
      std::pow(1.875104, 2) / (2 * 3.14159265358979) * std::sqrt(17e6 / 1100) * 0.2 / std::sqrt(12);
  EXPECT_NEAR(result["modes"][0]["frequency_hz"].get<double>(), bending, 0.06 * bending);
  EXPECT_EQ(run_plumb("spectrum " + bar + " --at end --symbol 4").code, 2);
  const auto missing = run_plumb("spectrum " + bar + " --at nowhere.h5");
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.error.find("nowhere.h5"), std::string::npos) << missing.error;
}

/// The pressure [Pa] under which a column of particles buckles: where the lowest omega^2, which falls in proportion to it, is zero.
double buckling_pressure(const std::string& spacing) {
  const auto lowest = [&](double pressure) {
    const auto outcome = run_plumb(
        "spectrum " + scenes + "euler-column.toml --modes 1 --json - --at end --set body.spacing=" + spacing +
        " --set \"boundary.1.traction=['0', '-" + std::to_string(pressure) + "*t']\"");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return json::parse(outcome.out)["modes"][0]["omega_squared"].get<double>();
  };
  const double stable = lowest(8643), unstable = lowest(10563);
  EXPECT_GT(stable, 0);
  EXPECT_LT(unstable, 0);
  return 8643 + (10563 - 8643) * stable / (stable - unstable);
}

TEST(SpectrumCommand, AColumnOfParticlesBucklesAtEulersLoad) {
  const double euler = M_PI * M_PI * 17e6 / (1 - 0.3 * 0.3) * 0.1 * 0.1 / 12 / (4 * 2 * 2);
  const double coarse = buckling_pressure("0.025"), fine = buckling_pressure("0.0125");
  // shear takes 1.2 p/G = 0.2 % off, which is within what is left at 8 cells across
  EXPECT_NEAR(fine, euler, 0.01 * euler);
  EXPECT_LT(std::abs(fine - euler), 0.4 * std::abs(coarse - euler));  // second order
}

TEST(SpectrumCommand, TheWorstModeIsTheLowestOne) {
  const auto outcome = run_plumb(
      "spectrum " + scenes + "free_plate.toml --set method.gradient=standard --set method.beta=1.2 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json result = json::parse(outcome.out), worst = result["worst"];
  EXPECT_EQ(worst["value"], result["lowest_nonrigid"]);
  EXPECT_EQ(worst["value"], result["modes"][0]["value"]);
  EXPECT_TRUE(worst["spurious"].get<bool>()) << "modes of nearly no energy appear for beta 1.2";
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

/// A slender cantilever of length 1 m and height h = 0.05 m without lateral contraction.
constexpr const char* cantilever = R"toml(
[scene]
name = "cantilever"
dimension = 2
end_time = "1 ms"
[body]
size = [1, 0.05]
spacing = 0.0125
layout = "node"
[material]
young = "1 MPa"
poisson = 0
density = 1000
[method]
integrator = "verlet"
[[boundary]]
face = "x-"
kind = "clamped"
)toml";

class SpectrumFiles : public testing::Test {
 protected:
  test::Outcome spectrum(const std::string& scene, const std::string& arguments) const {
    std::ofstream(folder_ / "scene.toml") << scene;
    return run_plumb("spectrum " + (folder_ / "scene.toml").string() + " " + arguments);
  }
  json result(const std::string& scene, const std::string& arguments = "") const {
    const auto outcome = spectrum(scene, arguments + " --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return json::parse(outcome.out);
  }
  test::TemporaryFolder folder_;
};

/// Frequencies of the smooth modes [Hz], ascending. Of the cantilever the first three bend it: the first one
/// along its length has 7.9 Hz.
std::vector<double> smooth_ones(const json& modes) {
  std::vector<double> hz;
  for (const auto& mode : modes)
    if (mode["kind"] == "smooth") hz.push_back(mode["hz"]);
  std::sort(hz.begin(), hz.end());
  return hz;
}

/// Euler and Bernoulli's beam, and what a beam of finite height has less (Timoshenko, Phil. Mag. 41, 1921):
/// to the first order in r^2 = h^2/12 a frequency is lower by r^2/2 (1 + E/(kappa G)) times the mean square
/// slope of the mode, with kappa = 5/6 and E/G = 2.
TEST_F(SpectrumFiles, FrequenciesOfACantileverAreThoseOfABeam) {
  const std::vector<double> roots{1.8751, 4.6941, 7.8548};   // of cos k cosh k = -1
  const std::vector<double> slopes{4.6478, 32.417, 77.299};  // integral of w'^2 over that of w^2
  const auto coarse = smooth_ones(result(cantilever)["modes"]);
  const auto fine = smooth_ones(result(cantilever, "--set body.spacing=0.00625 --modes 8")["modes"]);
  ASSERT_GE(coarse.size(), 3u);
  ASSERT_GE(fine.size(), 3u);
  for (std::size_t n = 0; n < roots.size(); ++n) {
    const double beam = roots[n] * roots[n] / (2 * M_PI) * std::sqrt(1e6 * 0.05 * 0.05 / (12 * 1000));
    const double lower = 0.5 * 0.05 * 0.05 / 12 * 3.4 * slopes[n];
    const double limit = fine[n] + (fine[n] - coarse[n]) / 3;  // order 2 in the spacing
    std::cout << n << ": " << beam << " Hz, measured " << coarse[n] << ", " << fine[n] << ", limit " << limit
              << '\n';
    // what is left of the extrapolated error, and (lower)^2
    EXPECT_NEAR(limit / beam, 1 - lower, 0.01);
  }
  // frequencies go as one over the root of the density; to the rounding of eigenvalues far below the largest
  // one
  const auto heavy = smooth_ones(result(cantilever, "--set material.density=4000")["modes"]);
  for (std::size_t n = 0; n < roots.size(); ++n) EXPECT_NEAR(2 * heavy[n] / coarse[n], 1, 1e-8);
}

/// All of the lowest modes of this one are spurious.
TEST_F(SpectrumFiles, NothingReadsAsCleanWhereNoSmoothModeWasSeen) {
  std::string scene = cantilever;
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"size = [1, 0.05]", "size = [0.35, 0.02]"},
        {"spacing = 0.0125", "spacing = 0.005"},
        {"poisson = 0", "poisson = 0.4"},
        {"integrator = \"verlet\"", "kernel = \"wendland-c2\"\nbeta = 2.828\ngradient = \"standard\""}})
    scene.replace(scene.find(from), from.size(), to);
  const json s = result(scene, "--dense 500");
  EXPECT_TRUE(s["lowest_smooth"].is_null());
  EXPECT_TRUE(s["near_zero_not_rigid"].is_null());
  EXPECT_EQ(s["spurious_below_smooth"], 24);
  EXPECT_EQ(s["at_least"], true);
  const auto text = spectrum(scene, "--dense 500").out;
  EXPECT_NE(text.find("At least 24 spurious; lowest smooth: not among those looked at"), std::string::npos)
      << text;
  EXPECT_EQ(text.find(" 0 spurious"), std::string::npos) << text;
  EXPECT_EQ(text.find("smooth one"), std::string::npos) << text;
  EXPECT_EQ(result(scene)["at_least"], false);
}

TEST_F(SpectrumFiles, ModesAreATableAndFrames) {
  const auto free = run_plumb("spectrum " + scenes + "free_plate.toml --modes 4 --json -");
  const json modes = json::parse(free.out)["modes"];
  ASSERT_EQ(modes.size(), 7u) << "four, and three rigid motions after them";
  for (std::size_t n = 0; n < modes.size(); ++n) {
    EXPECT_EQ(modes[n]["kind"] == "rigid", n >= 4) << n;
    EXPECT_EQ(modes[n]["period_s"].is_null(), n >= 4) << n;
    if (n >= 4) continue;
    EXPECT_DOUBLE_EQ(modes[n]["hz"].get<double>() * modes[n]["period_s"].get<double>(), 1);
    EXPECT_EQ(modes[n]["kind"] == "spurious", modes[n]["unexplained"].get<double>() > 0.5);
  }
  const auto text =
      run_plumb("spectrum " + scenes + "free_plate.toml --modes 4 --vtk " + (folder_ / "vtk").string());
  for (const char* heading : {"frequency [Hz]", "period [s]", "unexplained share", "kind"})
    EXPECT_NE(text.out.find(heading), std::string::npos) << text.out;
  const std::string index = test::content_of(folder_ / "vtk" / "modes.pvd");
  EXPECT_NE(index.find("modes_000006.vtp"), std::string::npos) << index;
  const std::string frame = test::content_of(folder_ / "vtk" / "modes_000000.vtp");
  EXPECT_NE(frame.find("displacement [m]"), std::string::npos);
  EXPECT_NE(frame.find("frequency [Hz]"), std::string::npos);
  EXPECT_EQ(run_plumb("spectrum " + scenes + "free_plate.toml --over method.beta=0.9,1 --vtk " +
                      (folder_ / "other").string())
                .code,
            2);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other"));
}

TEST(SpectrumCommand, APictureNeedsOneBody) {
  const test::TemporaryFolder folder;
  const std::string plot = " --plot " + (folder / "mode.svg").string();
  EXPECT_EQ(run_plumb("spectrum " + scenes + "free_plate.toml" + plot).code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "mode.svg"));
  EXPECT_EQ(run_plumb("spectrum " + scenes + "free_plate.toml --symbol 4" + plot).code, 2);
}

}  // namespace
}  // namespace plumb::spectrum_test
