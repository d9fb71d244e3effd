// The largest steps of paper 002's printed forms by the spectrum of a step, against runs that blow up.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/spectrum/own_step.hpp"

namespace plumb::testing {
namespace {

/// By how much a step of cfl h/c_0 of a free square of 8 x 8 at rest multiplies its fastest growing motion.
double largest_factor(const std::string& form, double nu, double cfl, const std::string& more) {
  const double E = 17e6, rho = 1100, c0 = std::sqrt(E / (3 * (1 - 2 * nu)) / rho), d = 0.125;
  auto simulation =
      make_simulation<2>(
          parse_scene(
              fmt::format(
                  "[scene]\ndimension = 2\nend_time = 1\n[body]\nsize = [1, 1]\nspacing = {}\nlayout = "
                  "\"cell\"\n[material]\nmodel = \"linear-elastic\"\nyoung = {}\npoisson = {}\ndensity "
                  "= {}\n[method]\nscheme = \"updated\"\npaper = \"002\"\ntime_step = "
                  "{:.17g}\n[updated]\nform = \"{}\"\ngeometry = \"step\"\n{}",
                  d, E, nu, rho, cfl * 1.3 * d / c0, form, more),
              "test.toml"))
          .simulation;
  const StepSpectrum s = spectrum_of_step<2>(simulation, {d, Elastic{E, nu, rho}.wave_speed(), rho});
  return std::exp(s.growth * s.time_step);
}

struct Edge {
  const char* form;
  double nu, cfl;  ///< where a factor passes 1
  const char* more = "";
};
class LargestSteps : public ::testing::TestWithParam<Edge> {};

/// A motion that alternates passes the factor -1 at the edge: 2 % below it nothing grows by more than what grows at any
/// step (printed sums are no adjoint pair), 2 % above it a motion is doubled within some dozens of steps.
TEST_P(LargestSteps, AreWhereAFactorPassesOne) {
  const auto& [form, nu, cfl, more] = GetParam();
  EXPECT_LT(largest_factor(form, nu, 0.98 * cfl, more), 1.003);
  EXPECT_GT(largest_factor(form, nu, 1.02 * cfl, more), 1.01);
}
INSTANTIATE_TEST_SUITE_P(Paper002, LargestSteps,
                         ::testing::Values(Edge{"og", 0, 0.78}, Edge{"og", 0.45, 1.03}, Edge{"eno", 0, 0.35},
                                           Edge{"eno", 0.3, 0.55}, Edge{"gno", 0, 0.56},
                                           Edge{"gno", 0.3, 0.77},
                                           Edge{"gno", 0, 0.40, "penalty = \"vector\"\nxi = 4\n"}));

}  // namespace
}  // namespace plumb::testing
