// Clouds of two spacings: which points there are, what they fill, how far apart they are.
#include "lib/geometry/graded_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace plumb {
namespace {

const Box<2> square{Vec<2>::Zero(), Vec<2>(2, 2)};

bool on_the_right(const Vec<2>& X) {
  return X[0] > 1;
}

TEST(GradedLattice, HasTheCornersOfAllCells) {
  const Cloud<2> cloud = graded_lattice<2>(square, 0.5, on_the_right);
  // 3 coarse columns of 5, the one between with its hanging nodes, 4 fine columns of 9
  EXPECT_EQ(cloud.size(), 2 * 5 + 9 + 4 * 9);
  for (const Vec<2>& X : cloud.X) {
    const double step = X[0] < 1 - 1e-12 ? 0.5 : 0.25;
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(std::remainder(X[k], step), 0, 1e-12) << X.transpose();
  }
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 4, 1e-12);
  const Cloud<3> block = graded_lattice<3>({Vec<3>::Zero(), Vec<3>::Ones()}, 0.5,
                                           [](const Vec<3>& X) { return X.maxCoeff() < 0.5; });
  EXPECT_EQ(block.size(), 27 + (27 - 8));  // one cell of eight is divided
  EXPECT_NEAR(std::accumulate(block.V.begin(), block.V.end(), 0.0), 1, 1e-12);
}

TEST(GradedLattice, WithoutFinerCellsIsTheLattice) {
  const Cloud<2> cloud = graded_lattice<2>(square, 0.5, [](const Vec<2>&) { return false; }),
                 plain = lattice<2>(square, {4, 4}, Layout::node);
  ASSERT_EQ(cloud.size(), plain.size());
  double sum = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    sum += (cloud.X[i] - plain.X[i]).norm() + std::abs(cloud.V[i] - plain.V[i]);
  EXPECT_LT(sum, 1e-12);
}

TEST(GradedLattice, MovesInnerParticlesByTheirOwnSpacing) {
  const Cloud<2> still = graded_lattice<2>(square, 0.5, on_the_right),
                 moved = graded_lattice<2>(square, 0.5, on_the_right, 0.2, 3);
  double coarse = 0, fine = 0;
  for (Index i = 0; i < still.size(); ++i) {
    const Vec<2>& X = still.X[i];
    const double shift = (moved.X[i] - X).cwiseAbs().maxCoeff();
    const bool inner = X.minCoeff() > 1e-12 && X.maxCoeff() < 2 - 1e-12;
    EXPECT_EQ(shift > 0, inner) << X.transpose();
    double& most = X[0] < 1 - 1e-12 ? coarse : fine;
    most = std::max(most, shift);
  }
  EXPECT_LE(coarse, 0.1);
  EXPECT_GT(coarse, 0.05);
  EXPECT_LE(fine, 0.05);
  EXPECT_GT(fine, 0.025);
}

/// A particle has the wider spacing where a coarse cell touches it.
TEST(GradedLattice, KnowsTheSpacingAroundEachParticle) {
  const Cloud<2> cloud = graded_lattice<2>(square, 0.5, on_the_right);
  const std::vector<double> spacings = graded_spacings<2>(cloud, on_the_right);
  for (Index i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(spacings[i], cloud.X[i][0] > 1.2 ? 0.25 : 0.5) << cloud.X[i].transpose();
}

}  // namespace
}  // namespace plumb
