#include "lib/actions/load_options.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Ramp, GrowsFromNothingToTheWholeWithoutAJumpInItsFirstTwoDerivatives) {
  EXPECT_EQ(ramp_share(std::nullopt, 0), 1);
  const std::optional<double> ramp = 0.2;
  EXPECT_EQ(ramp_share(ramp, -1), 0);
  EXPECT_EQ(ramp_share(ramp, 0), 0);
  EXPECT_DOUBLE_EQ(ramp_share(ramp, 0.1), 0.5);
  EXPECT_DOUBLE_EQ(ramp_share(ramp, 0.05), 10.0 / 64 - 15.0 / 256 + 6.0 / 1024);
  EXPECT_EQ(ramp_share(ramp, 0.2), 1);
  EXPECT_EQ(ramp_share(ramp, 3), 1);
  // 10 s^3 near the ends: a jump in the second derivative would leave s^2
  EXPECT_NEAR(ramp_share(ramp, 0.2e-3), 10e-9, 2e-11);
  EXPECT_NEAR(1 - ramp_share(ramp, 0.2 - 0.2e-3), 10e-9, 2e-11);
}

}  // namespace
}  // namespace plumb
