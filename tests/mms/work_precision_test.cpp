#include "mms/work_precision.hpp"
#include "places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb::mms::work_precision_test {
namespace {

TEST(WorkPrecision, ThePointsThatNothingBeatsAreTheFront) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto front = pareto_front({{1, 1}, {2, 0.5}, {2, 0.6}, {3, 0.5}, {0.5, 2}, {0.1, nan}, {4, 0.1}});
  EXPECT_EQ(front, (std::vector<bool>{true, true, false, false, true, false, true}));
}

TEST(WorkPrecision, EqualPointsAreBothOnTheFront) {
  EXPECT_EQ(pareto_front({{1, 1}, {1, 1}}), (std::vector<bool>{true, true}));
}

Study plate(const std::string& integrator) {
  return read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/swinging_plate_finite_strain.toml",
                    {"study.spacings=[0.5,0.25]", "study.periods=0.05", "study.quadrature=nodal",
                     "method.integrator=" + integrator});
}

TEST(WorkPrecision, WorkIsCountedAndTheCheapestIsFound) {
  const WorkPrecision result =
      work_precision({{"verlet", plate("verlet")}, {"rk3", plate("rk3")}}, 1, {1, 1e-30});
  ASSERT_EQ(result.points.size(), 4u);
  for (const auto& point : result.points) {
    EXPECT_GT(point.error, 0);
    EXPECT_LT(point.error, 1);
    EXPECT_GT(point.cpu_s, 0);
    EXPECT_FALSE(point.failure.has_value());
  }
  // three evaluations a step instead of one (and one at the start)
  EXPECT_NEAR(static_cast<double>(result.points[3].pair_evaluations) /
                  static_cast<double>(result.points[1].pair_evaluations),
              3, 0.3);
  // an error of 1 is reached by every level: the coarsest of Verlet does least; 1e-30 by none
  ASSERT_EQ(result.cheapest.size(), 2u);
  EXPECT_EQ(result.cheapest[1].measure, "pair_evaluations");
  EXPECT_EQ(result.cheapest[1].variant, 0u);
  EXPECT_EQ(result.cheapest[1].cost, static_cast<double>(result.points[0].pair_evaluations));
}

TEST(WorkPrecision, WhatCannotBeBuiltIsAPointWithoutError) {
  Study refused = plate("verlet");
  refused.method.gradient = "compatible";
  refused.method.beta = 0.55;
  refused.body.jitter = 0.3;
  const WorkPrecision result = work_precision({{"none", refused}, {"verlet", plate("verlet")}}, 1, {1});
  ASSERT_EQ(result.points.size(), 4u);
  for (const auto& point : result.points) {
    EXPECT_EQ(point.refused, point.variant == 0);
    EXPECT_EQ(std::isnan(point.error), point.refused);
    EXPECT_EQ(point.failure.has_value(), point.refused);
    if (point.refused) {
      EXPECT_EQ(point.failure->back(), '.') << *point.failure;  // sentences
    }
    EXPECT_FALSE(point.refused && (point.front_cpu || point.front_work));
  }
  for (const auto& cheapest : result.cheapest) EXPECT_EQ(cheapest.variant, 1u);
  EXPECT_THROW(work_precision({{"none", refused}}, 1, {1}), InputError);
}

}  // namespace
}  // namespace plumb::mms::work_precision_test
