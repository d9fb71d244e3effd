// Known values of the kernels, worked out by hand from the printed polynomials.
#include "lib/kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace plumb {
namespace {

constexpr double pi = std::numbers::pi;

TEST(CubicSpline, ValuesAtTheKnots) {
  EXPECT_DOUBLE_EQ(CubicSpline::w<1>(0), 2.0 / 3);
  EXPECT_DOUBLE_EQ(CubicSpline::w<1>(1), 1.0 / 6);
  EXPECT_DOUBLE_EQ(CubicSpline::dw<1>(1), -0.5);
  EXPECT_DOUBLE_EQ(CubicSpline::w<2>(0), 10 / (7 * pi));
  EXPECT_DOUBLE_EQ(CubicSpline::w<3>(1), 1 / (4 * pi));
}

TEST(QuinticSpline, ValuesAtTheKnots) {
  EXPECT_DOUBLE_EQ(QuinticSpline::w<1>(0), 66.0 / 120);
  EXPECT_DOUBLE_EQ(QuinticSpline::w<1>(1), 26.0 / 120);
  EXPECT_DOUBLE_EQ(QuinticSpline::w<1>(2), 1.0 / 120);
}

TEST(WendlandC2, HasItsOwnPolynomialIn1D) {
  EXPECT_DOUBLE_EQ(WendlandC2::w<1>(1), 5.0 / 8 / 8 * 2.5);
  EXPECT_DOUBLE_EQ(WendlandC2::w<2>(1), 7 / (4 * pi) / 16 * 3);
  EXPECT_DOUBLE_EQ(WendlandC2::w<3>(1), 21 / (16 * pi) / 16 * 3);
}

TEST(Quadratic, Values) {
  EXPECT_DOUBLE_EQ(Quadratic::w<1>(1), 0.75 / 4);
  EXPECT_DOUBLE_EQ(Quadratic::dw<1>(0), -0.75);
}

TEST(KernelNamed, NamesTheNearestForAMisspeltOne) {
  try {
    kernel_named<2>("wendland");
    FAIL() << "an unknown kernel was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"wendland\""), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Did you mean \"wendland-c2\"?"), std::string::npos);
  }
}

}  // namespace
}  // namespace plumb
