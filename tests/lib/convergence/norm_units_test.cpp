#include "lib/convergence/norm_units.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

// Square root of an integral over m^d of the square: times m^(d/2).
TEST(NormUnits, AreThoseOfIntegrals) {
  EXPECT_EQ(unit_of_norm("l2", 2), "m^2");
  EXPECT_EQ(unit_of_norm("l2_gauss", 3), "m^2.5");
  EXPECT_EQ(unit_of_norm("h1", 2), "m");
  EXPECT_EQ(unit_of_norm("h1_gauss", 3), "m^1.5");
  EXPECT_EQ(unit_of_norm("linf", 2), "m");
  EXPECT_EQ(unit_of_norm("linf", 3), "m");
  EXPECT_EQ(unit_of_norm("velocity_l2", 2), "m^2/s");
  EXPECT_EQ(unit_of_norm("velocity_l2", 3), "m^2.5/s");
  EXPECT_EQ(unit_of_norm("stress_l2", 2), "Pa m");
  EXPECT_EQ(unit_of_norm("stress_l2", 3), "Pa m^1.5");
  EXPECT_EQ(unit_of_norm("relative_l2", 2), "");
  EXPECT_EQ(unit_of_norm("steps", 2), "");
}

TEST(NormUnits, StandInHeadsOfTables) {
  EXPECT_EQ(with_unit("l2", 2), "l2 [m^2]");
  EXPECT_EQ(with_unit("relative_l2", 2), "relative_l2");
}

}  // namespace
}  // namespace plumb
