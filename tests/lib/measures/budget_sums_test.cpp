#include "lib/measures/budget_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

BudgetPart part(const std::string& name, const Vec<3>& linear, const Vec<3>& angular, double energy) {
  BudgetPart made{name};
  made.linear = linear;
  made.angular = angular;
  made.energy = energy;
  return made;
}

/// Each gap is what is not explained of its own change, over its own scale; without a scale it is absolute.
TEST(BudgetSums, GapsAreRelativeToTheirOwnScales) {
  const BudgetPart explained = part("", {1, 2, 3}, {4, 5, 6}, 7), change = part("", {1, 2, 7}, {1, 5, 2}, 10);
  BudgetSums step;
  set_gaps(explained, {change, part("", {8, 0, 0}, {10, 0, 0}, 12)}, step);
  EXPECT_DOUBLE_EQ(step.linear_gap, 0.5);
  EXPECT_DOUBLE_EQ(step.angular_gap, 0.5);
  EXPECT_DOUBLE_EQ(step.energy_gap, 0.25);
  set_gaps(explained, {change, {}}, step);
  EXPECT_DOUBLE_EQ(step.linear_gap, 4);
  EXPECT_DOUBLE_EQ(step.angular_gap, 5);
  EXPECT_DOUBLE_EQ(step.energy_gap, 3);
}

/// 2 kg that go from (1, 0, 0) to (1, 2, 0) m turn from (0, 3, 0) to (4, 5, 0) m/s, with (2, 3, 0) m/s meanwhile.
TEST(BudgetSums, AStateChangesByMassTimesWhatItsParticlesDo) {
  StateChange state;
  for (int n = 0; n < 2; ++n) state.add(2, {1, 0, 0}, {1, 2, 0}, {0, 3, 0}, {4, 5, 0}, {2, 3, 0});
  EXPECT_EQ(state.change.linear, Vec<3>(16, 8, 0));
  EXPECT_EQ(state.change.angular, Vec<3>(0, 0, 4 * ((1 * 5 - 2 * 4) - 1 * 3)));
  EXPECT_DOUBLE_EQ(state.change.energy, 2 * (41 - 9));
  EXPECT_DOUBLE_EQ(state.scale.linear[0], 4 * std::sqrt(13.0));
  EXPECT_DOUBLE_EQ(state.scale.angular[0], 4 * std::sqrt(2.0) * std::sqrt(13.0));
  EXPECT_DOUBLE_EQ(state.scale.energy, 2 * 13);
}

TEST(BudgetSums, AnImpulseTurnsAboutTheOrigin) {
  BudgetPart pushed = part("", {1, 0, 0}, {0, 0, 1}, 5);
  push({0, 3, 0}, {2, 0, 0}, pushed);
  EXPECT_EQ(pushed.linear, Vec<3>(1, 3, 0));
  EXPECT_EQ(pushed.angular, Vec<3>(0, 0, 7));
  EXPECT_EQ(pushed.energy, 5);
}

TEST(BudgetSums, StepsAddUpAndTheLargestGapStays) {
  BudgetSums step{{part("a", {1, 2, 3}, {4, 5, 6}, 7), part("b", {1, 0, 0}, {0, 1, 0}, -2)}, 0.1, 0.2, 0.3},
      total{{{"a"}, {"b"}}};
  add_step(step, total);
  step.linear_gap = 0.05;
  step.energy_gap = 0.4;
  add_step(step, total);
  EXPECT_EQ(total.part("a").linear, Vec<3>(2, 4, 6));
  EXPECT_EQ(total.part("a").angular, Vec<3>(8, 10, 12));
  EXPECT_EQ(total.part("b").energy, -4);
  EXPECT_EQ(total.linear_gap, 0.1);
  EXPECT_EQ(total.angular_gap, 0.2);
  EXPECT_EQ(total.energy_gap, 0.4);
  const BudgetPart sum = sum_of(total.parts);
  EXPECT_EQ(sum.linear, Vec<3>(4, 4, 6));
  EXPECT_EQ(sum.energy, 10);
  EXPECT_THROW(total.part("c"), InputError);
}

/// The components that a dimension has, under their names.
TEST(BudgetSums, RowsFillTheirColumns) {
  const BudgetSums total{{part("a", {1, 2, 3}, {4, 5, 6}, 7)}, 0, 0, 0}, step{{}, 0.1, 0.2, 0.3};
  EXPECT_EQ(budget_row<1>(9, 0.5, total, step), (std::vector<double>{9, 0.5, 1, 7, 0.1, 0.2, 0.3}));
  EXPECT_EQ(budget_row<2>(9, 0.5, total, step), (std::vector<double>{9, 0.5, 1, 2, 6, 7, 0.1, 0.2, 0.3}));
  EXPECT_EQ(budget_row<3>(9, 0.5, total, step),
            (std::vector<double>{9, 0.5, 1, 2, 3, 4, 5, 6, 7, 0.1, 0.2, 0.3}));
  EXPECT_EQ(budget_columns<1>(total.parts).size(), 7u);
  const std::vector<std::string> plane = budget_columns<2>(total.parts);
  ASSERT_EQ(plane.size(), 9u);
  EXPECT_TRUE(plane[3].starts_with("a: linear momentum y"));
  EXPECT_TRUE(plane[4].starts_with("a: angular momentum z"));
  EXPECT_EQ(plane[8], "gap of energy");
}

}  // namespace
}  // namespace plumb
