// Equilibria of finite strains against manufactured fields.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/scene/study.hpp"
#include "mms/static_study.hpp"
#include "places.hpp"

namespace plumb::mms {
namespace {

StaticResult finite_study(const std::string& file, std::vector<std::string> set) {
  set.insert(set.begin(), "method.scheme=implicit");
  return run_static_study(read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/" + file, set));
}

const StudyFit& fit_named(const StaticResult& result, const std::string& norm) {
  for (const StudyFit& fit : result.fits)
    if (fit.norm == norm) return fit;
  throw InputError("no norm " + norm, "", "");
}

/// A stretch of 0.2, a shear and a turn by 0.5 are in equilibrium on every cloud: to what Newton's method leaves.
TEST(FiniteStatics, AnAffineMapIsInEquilibrium) {
  for (const char* cloud : {"body.jitter=0", "body.jitter=0.2"}) {
    const auto result = finite_study("affine_patch.toml", {cloud, "study.spacings=[0.2, 0.1]"});
    for (const StaticLevel& level : result.levels) {
      EXPECT_LT(level.relative(&ErrorNorms::l2), 1e-8) << cloud << level.spacing;
      EXPECT_LT(level.relative(&ErrorNorms::stress_l2), 1e-7) << cloud << level.spacing;
      EXPECT_GT(level.exact.h1, 0.1);
    }
  }
}

/// Strains of 0.3: the compatible table is of order 2; the linear answer to the same field is off by the square of the strain.
TEST(FiniteStatics, ConvergeWhereLinearOnesStall) {
  const std::vector<std::string> large = {"study.parameters.amplitude=0.2",
                                          "study.spacings=[0.25, 0.125, 0.0625]"};
  const auto finite = finite_study("static_plate_finite.toml", large);
  for (const char* norm : {"l2", "stress_l2"})
    EXPECT_NEAR(fit_named(finite, norm).fit.order, 2, 0.15) << norm;  // 2.03 and 2.02 on four levels
  std::vector<std::string> linear = large;
  linear.push_back("body.jitter=0");
  const auto stalled =
      run_static_study(read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/static_plate.toml", linear));
  EXPECT_GT(stalled.levels.back().relative(&ErrorNorms::l2),
            5 * finite.levels.back().relative(&ErrorNorms::l2));
}

/// Small fields are those of the linear study: the difference is relative to the amplitude.
TEST(FiniteStatics, SmallFieldsAreTheLinearOnes) {
  const std::vector<std::string> small = {"study.parameters.amplitude=1e-6", "study.spacings=[0.25]",
                                          "body.jitter=0"};
  const auto finite = finite_study("static_plate.toml", small);
  const auto linear =
      run_static_study(read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/static_plate.toml", small));
  const auto relative = [](const StaticResult& of) { return of.levels[0].relative(&ErrorNorms::l2); };
  EXPECT_NEAR(relative(finite) / relative(linear), 1, 1e-3);
  EXPECT_TRUE(linear.levels[0].frequency_error);
  EXPECT_FALSE(finite.levels[0].frequency_error);
}

/// A hole's surface is displaced like the faces: an affine map leaves nothing but what Newton's method does.
TEST(FiniteStatics, ABodyWithAHoleIsDisplacedAllAround) {
  for (const int d : {2, 3}) {
    const std::string size = d == 2 ? "[1, 1]" : "[1, 1, 1]",
                      middle = d == 2 ? "[0.5, 0.5]" : "[0.5, 0.5, 0.5]";
    const auto study = parse_study(fmt::format(R"([study]
solution = "affine-patch"
spacings = [0.125]
periods = 0.125
quadrature = "nodal"
[body]
size = {}
[[body.hole]]
shape = "ball"
centre = {}
radius = 0.25
[material]
young = "17 MPa"
poisson = 0.3
density = 1100
[method]
scheme = "implicit"
gradient = "compatible"
)",
                                               size, middle),
                                   "hole.toml");
    const StaticLevel level = run_static_study(study).levels.at(0);
    // residuals of 1e-10 of the forces, over volumes that a hole leaves small
    EXPECT_LT(level.relative(&ErrorNorms::l2), 1e-6) << d;
    EXPECT_GT(level.exact.h1, 0.1) << d;
    Study linear = study;
    linear.method.scheme = "tlsph";
    linear.material.model = "linear-elastic";
    EXPECT_LT(run_static_study(linear).levels.at(0).relative(&ErrorNorms::l2), 1e-12) << d;  // round-off
  }
}

/// A solution at rest is a field like others: its circles are displaced, none is pulled.
TEST(FiniteStatics, ARingIsDisplacedOnBothCircles) {
  const auto result = finite_study("static_ring_finite.toml", {"study.spacings=[0.25, 0.125, 0.0625]"});
  EXPECT_NEAR(fit_named(result, "l2").fit.order, 2, 0.3);
  EXPECT_LT(result.levels.back().relative(&ErrorNorms::l2), 2e-3);
}

/// Cells of two sizes, small strain and large: order 2, as on one size.
TEST(FiniteStatics, GradedCloudsConverge) {
  const std::vector<std::string> levels{"study.spacings=[0.2, 0.1]"};
  const auto small = run_static_study(
      read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/static_plate_graded.toml", levels));
  auto set = levels;
  set.push_back("study.parameters.amplitude=0.2");
  const auto large = finite_study("static_plate_graded.toml", set);
  for (const auto* result : {&small, &large})  // 2.22 and 1.70; to 1/15 m pairs from 1.68 to 2.34
    EXPECT_NEAR(
        std::log2(result->levels[0].relative(&ErrorNorms::l2) / result->levels[1].relative(&ErrorNorms::l2)),
        2, 0.35);
  EXPECT_EQ(small.levels[0].n, 5 * 11 + 11 * 21);
}

}  // namespace
}  // namespace plumb::mms
