// What a step makes of small disturbances, against closed forms of bars.
#include "lib/spectrum/own_step.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"

namespace plumb {
namespace {

constexpr double young = 1e6, poisson = 0.25, density = 1000, spacing = 0.1;
const double speed = std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density);

/// A free bar, or square, of 8 spacings.
std::string body(int d, const std::string& scheme, const std::string& more) {
  return fmt::format(
             "[scene]\ndimension = {}\nend_time = 1\n[body]\nsize = [{}]\nspacing = {}\nlayout = \"node\"\n"
             "[material]\nyoung = {}\npoisson = {}\ndensity = {}\n[method]\nscheme = \"{}\"\n",
             d, d == 1 ? "0.8" : "0.4, 0.4", spacing, young, poisson, density, scheme) +
         more;
}

template <int d>
StepSpectrum spectrum(const std::string& text) {
  auto simulation = make_simulation<d>(parse_scene(text, "test.toml")).simulation;
  EXPECT_EQ(simulation.spacing, spacing);
  return spectrum_of_step<d>(simulation, {simulation.spacing, speed, density});
}

/// Angles of factors of length 1, ascending, the two of a pair once; 0 of the rigid motion is left out.
std::vector<double> angles_of(const StepSpectrum& s) {
  std::vector<double> angles;
  for (const auto& factor : s.factors) {
    EXPECT_NEAR(std::abs(factor), 1, 1e-4);  // 1e-9 of the differences; its root where two factors meet
    if (std::arg(factor) > 1e-3) angles.push_back(std::arg(factor));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// A free bar of N linear elements with lumped masses has the frequencies (2 c/d) sin(k pi / 2 N); Verlet's rule makes
/// of w the angle 2 asin(w dt/2).
TEST(OwnStep, HasTheFrequenciesOfABarOfElements) {
  const double dt = 0.4 * spacing / speed;
  const StepSpectrum s = spectrum<1>(body(1, "element", fmt::format("time_step = {}\n", dt)));
  const std::vector<double> angles = angles_of(s);
  ASSERT_EQ(angles.size(), 8u);
  for (int k = 1; k <= 8; ++k) {
    const double omega = 2 * speed / spacing * std::sin(k * std::numbers::pi / 16);
    EXPECT_NEAR(angles[k - 1], 2 * std::asin(0.5 * omega * dt), 1e-8) << k;  // differences of the second order: 1e-10
  }
  EXPECT_EQ(s.growing, 0);
  EXPECT_EQ(s.growth, 0);
  EXPECT_NEAR(s.fastest, angles.back() / dt, 1e-9 / dt);
  EXPECT_EQ(s.time_step, dt);
}

/// Beyond w dt = 2 a motion alternates and grows: factor + 1/factor = 2 - (w dt)^2.
TEST(OwnStep, SeesAStepThatIsTooLong) {
  const double dt = 1.02 * spacing / speed;
  const StepSpectrum s = spectrum<1>(body(1, "element", fmt::format("time_step = {}\n", dt)));
  double growth = 0;
  Index growing = 0;
  for (int k = 1; k <= 8; ++k) {
    const double half = 1 - 0.5 * std::pow(2 * 1.02 * std::sin(k * std::numbers::pi / 16), 2);
    if (half >= -1) continue;
    ++growing;
    growth = std::max(growth, std::log(-half + std::sqrt(half * half - 1)) / dt);
  }
  ASSERT_GT(growing, 0);
  EXPECT_EQ(s.growing, growing);
  EXPECT_NEAR(s.growth, growth, 1e-5 * growth);
  EXPECT_EQ(s.growth_aperiodic, 0);
}

/// A damping takes exp(-c dt) of the volume of the phase space for each component.
TEST(OwnStep, SeesADamping) {
  const double dt = 0.3 * spacing / speed, rate = 20;
  for (const std::string scheme : {"element", "mixed"}) {
    const std::string own = scheme == "mixed" ? "[mixed]\nupwind = \"none\"\n" : "";
    const StepSpectrum s =
        spectrum<2>(body(2, scheme, fmt::format("time_step = {}\n{}[damping]\nrate = {}\n", dt, own, rate)));
    double sum = 0;
    for (const auto& factor : s.factors) sum += std::log(std::abs(factor));
    // RK3 damps by (w dt)^4/24 by itself, w dt of at most 1
    EXPECT_NEAR(sum / (50 * rate * dt), -1, scheme == "mixed" ? 0.5 : 1e-5) << scheme;
    EXPECT_LT(sum, -50 * rate * dt * (1 - 1e-5)) << scheme;
    EXPECT_EQ(s.growing, 0) << scheme;
  }
}

/// The state of every scheme that has its own fields is differentiated, and a free square at rest does not grow.
TEST(OwnStep, FreeSquaresAtRestDoNotGrow) {
  for (const std::string scheme : {"mixed", "updated", "eulerian", "element"}) {
    const StepSpectrum s = spectrum<2>(body(2, scheme, ""));
    EXPECT_GE(s.unknowns, 100) << scheme;
    EXPECT_EQ(s.growing, 0) << scheme << ' ' << s.growth * spacing / speed;
    EXPECT_GT(s.fastest * spacing / speed, 0.5) << scheme;
    EXPECT_LT(s.fastest * spacing / speed, 3) << scheme;
    for (const auto& factor : s.factors) EXPECT_LT(std::abs(factor), 1 + 1e-4) << scheme;
  }
}

/// The growth of blocks of the printed force of paper 001 at rest and in tension, [c_p/d]: an independent program has
/// .00646, .00644 and none for xi 0, .5 and 2, and at the stretch of 1.1 along x .27 for xi 0 and no growth without
/// oscillation from .5 on. The fastest oscillation is 1.244, 1.256, 1.293 there.
StepSpectrum block_of_paper_001(int across, double stretch, double xi, double dt, double xi_tension = 0,
                                double narrows = 1) {
  const double E = 1.998447e6, nu = 0.397516,
               c = std::sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / density);
  auto simulation =
      make_simulation<2>(
          parse_scene(fmt::format("[scene]\ndimension = 2\nend_time = 1\n[body]\nsize = [{0}, {0}]\n"
                                  "spacing = {1}\nlayout = \"cell\"\n[material]\nyoung = {2}\n"
                                  "poisson = {3}\ndensity = 1000\n[method]\nscheme = \"eulerian\"\n"
                                  "time_step = {4}\n[eulerian]\nforce = \"printed\"\n"
                                  "damping = \"none\"\nxi = {5}\nxi_tension = {8}\n[initial]\n"
                                  "displacement = [\"{6}*X\", \"{7}*Y\"]\n",
                                  across * spacing, spacing, E, nu, dt * spacing / c, xi, stretch - 1,
                                  std::pow(stretch, -narrows * nu / (1 - nu)) - 1, xi_tension),
                      "test.toml"))
          .simulation;
  StepSpectrum s = spectrum_of_step<2>(simulation, {spacing, c, density});
  for (double* rate : {&s.growth, &s.growth_aperiodic, &s.fastest, &s.resolution}) *rate *= spacing / c;
  return s;
}
TEST(OwnStep, GrowthOfPaper001IsThatOfAnIndependentProgram) {
  struct Row {
    double xi, growth, fastest;
  };
  for (const Row& row : {Row{1e-6, 0.00646, 1.244}, {0.5, 0.00644, 1.256}, {2, 0, 1.293}}) {
    const StepSpectrum s = block_of_paper_001(8, 1, row.xi, 0.05);
    EXPECT_NEAR(s.growth, row.growth, 3e-5)
        << row.xi;  // the program's last digit is 1e-5; the step adds (w dt)^2/6
    EXPECT_NEAR(s.fastest, row.fastest, 1.5e-3) << row.xi;
    EXPECT_EQ(s.growing, row.growth > 0 ? 2 : 0) << row.xi;
  }
}
TEST(OwnStep, TensionLetsBlocksOfPaper001Grow) {
  const StepSpectrum bare = block_of_paper_001(10, 1.1, 1e-6, 0.01),
                     kept = block_of_paper_001(10, 1.1, 0.5, 0.01);
  EXPECT_NEAR(bare.growth, 0.27, 0.005);
  EXPECT_EQ(bare.growth, bare.growth_aperiodic);
  EXPECT_EQ(kept.growth_aperiodic, 0);
  EXPECT_LT(kept.growth, 0.01);
}

/// A number for all states: xi that grows by 42 (s/E)^2 of the tension keeps blocks that are pulled, free sideways or held there,
/// from growing without oscillation. The fixed xi of the plate does not.
TEST(OwnStep, TensionThatStiffensKeepsBlocksOfPaper001) {
  struct Pulled {
    double stretch, narrows;
  };
  for (const Pulled& p : {Pulled{1.1, 1}, {1.1, 0}, {1.3, 1}, {1.3, 0}, {1.45, 1}})
    EXPECT_LT(block_of_paper_001(8, p.stretch, 0.5, 0.01, 42, p.narrows).growth_aperiodic, 0.01)
        << p.stretch << ' ' << p.narrows;
  EXPECT_GT(block_of_paper_001(8, 1.45, 0.5, 0.01, 0, 0).growth_aperiodic, 0.5);
}

TEST(OwnStep, RefusesStatesOfTooManyNumbers) {
  auto simulation = make_simulation<2>(parse_scene(body(2, "eulerian", ""), "test.toml")).simulation;
  EXPECT_THROW(spectrum_of_step<2>(simulation, {spacing, speed, density}, 100), InputError);
}

}  // namespace
}  // namespace plumb
