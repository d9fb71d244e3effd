#include "lib/core/pack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

template <int W>
void check_reciprocal_cube_root() {
  double worst = 0;
  for (int n = -1900; n <= 1900; ++n) {  // 1e-30 to 1e30
    const double x = std::pow(1.0371, n);
    const Pack<W> y = reciprocal_cbrt(Pack<W>(x));
    for (int lane = 0; lane < W; ++lane) worst = std::max(worst, std::abs(y[lane] * std::cbrt(x) - 1));
  }
  EXPECT_LT(
      worst,
      3 * std::numeric_limits<double>::epsilon());  // what the docstring promises, and one for the check
}

TEST(Pack, ReciprocalCubeRoot) {
  check_reciprocal_cube_root<1>();
  check_reciprocal_cube_root<native_width>();
}

TEST(Pack, LogarithmOfEachLane) {
  double values[native_width], logs[native_width];
  for (int lane = 0; lane < native_width; ++lane) values[lane] = std::exp(lane - 2.5);
  log(Pack<native_width>::load(values)).store(logs);
  for (int lane = 0; lane < native_width; ++lane)
    EXPECT_NEAR(logs[lane], lane - 2.5, 4 * std::numeric_limits<double>::epsilon() * 2.5) << lane;
}

TEST(Pack, LanesAreIndependent) {
  double values[native_width], result[native_width];
  for (int i = 0; i < native_width; ++i) values[i] = i - 2.5;
  const auto a = Pack<native_width>::load(values);
  (a * a - Pack<native_width>(1)).store(result);
  for (int i = 0; i < native_width; ++i) EXPECT_EQ(result[i], values[i] * values[i] - 1);
  for (int i = 0; i < native_width; ++i) EXPECT_EQ(not_positive(a)[i], values[i] > 0 ? 0 : 1);
  for (int i = 0; i < native_width; ++i)
    EXPECT_EQ(min(a, Pack<native_width>(0.25))[i], std::min(values[i], 0.25));
}

TEST(Pack, NotANumberIsNotPositive) {
  EXPECT_EQ(not_positive(Pack<native_width>(std::nan("")))[0], 1);
  EXPECT_EQ(not_positive(Pack<1>(std::nan("")))[0], 1);
}

}  // namespace
}  // namespace plumb
