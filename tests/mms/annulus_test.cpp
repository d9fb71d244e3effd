#include "mms/annulus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "plumbline/core/error.hpp"

namespace plumb::mms {
namespace {

constexpr double area = 3.141592653589793 * (1.25 * 1.25 - 0.75 * 0.75);

double total(const Cloud<2>& cloud) {
  return std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0);
}

TEST(PolarCloud, FillsTheAnnulusExactlyAndReachesBothCircles) {
  const Cloud<2> cloud = polar_cloud(0.75, 1.25, 0.05);
  EXPECT_NEAR(total(cloud), area, 1e-13);
  double least = 9, most = 0;
  for (const Vec<2>& X : cloud.X) {
    least = std::min(least, X.norm());
    most = std::max(most, X.norm());
  }
  EXPECT_NEAR(least, 0.75, 1e-15);
  EXPECT_NEAR(most, 1.25, 1e-15);
  EXPECT_EQ(cloud.size(), 11 * 126);  // 2 pi / 0.05 = 125.66
}

// The parts of cells that have no particle are missing: a share of order d of the area.
TEST(ClippedCloud, FillsTheAnnulusUpToTheCutCells) {
  for (double d : {0.1, 0.05, 0.025}) {
    const double sum = total(clipped_cloud(0.75, 1.25, d));
    EXPECT_LT(sum, area);
    EXPECT_GT(sum, area * (1 - 0.8 * d));
  }
}

TEST(Annulus, TooCoarseASpacingIsRefused) {
  EXPECT_THROW(polar_cloud(0.75, 1.25, 0.3), InputError);
  EXPECT_THROW(clipped_cloud(0.75, 0.5, 0.1), InputError);
}

}  // namespace
}  // namespace plumb::mms
