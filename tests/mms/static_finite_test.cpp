// Equilibria of finite strains against manufactured fields.
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

TEST(FiniteStatics, RefuseSolutionsAtRest) {
  EXPECT_THROW(finite_study("lame_ring.toml", {}), InputError);
}

}  // namespace
}  // namespace plumb::mms
