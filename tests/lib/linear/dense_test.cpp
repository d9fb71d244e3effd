#include "lib/linear/dense.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rounding of a matrix of this size and norm, with some room.
constexpr double rounding = 1e-13;

/// Second differences of a row that is held at both ends: eigenvalues 4 sin^2(k pi / (2 n + 2)).
MatrixXd second_differences(Eigen::Index n) {
  MatrixXd A = 2 * MatrixXd::Identity(n, n);
  for (Eigen::Index k = 0; k + 1 < n; ++k) A(k, k + 1) = A(k + 1, k) = -1;
  return A;
}

TEST(Dense, SymmetricPairsOfSecondDifferences) {
  constexpr Eigen::Index n = 7;
  const MatrixXd A = second_differences(n);
  const SymmetricPairs pairs = symmetric_pairs(A);
  const VectorXd values = symmetric_values(A);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double exact =
        4 * std::pow(std::sin(static_cast<double>(k + 1) * std::numbers::pi / (2.0 * n + 2)), 2);
    EXPECT_NEAR(pairs.values[k], exact, rounding);
    EXPECT_NEAR(values[k], exact, rounding);
  }
  EXPECT_LT((A * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(), rounding);
  EXPECT_LT((pairs.vectors.transpose() * pairs.vectors - MatrixXd::Identity(n, n)).norm(), rounding);
}

TEST(Dense, OnlyTheLowerHalfOfASymmetricMatrixIsRead) {
  MatrixXd A = second_differences(5);
  const VectorXd values = symmetric_values(A);
  A.triangularView<Eigen::StrictlyUpper>().setConstant(99);
  EXPECT_EQ(values, symmetric_values(A));
}

TEST(Dense, ComplexPairsOfATurnInAPlane) {
  MatrixXd A = MatrixXd::Zero(3, 3);
  A << 1, -2, 5, 2, 1, 7, 0, 0, -3;  // 1 +- 2i and -3
  const ComplexPairs pairs = complex_pairs(A);
  std::vector<std::complex<double>> found(pairs.values.begin(), pairs.values.end());
  for (const std::complex<double> exact : {std::complex<double>(1, 2), {1, -2}, {-3, 0}})
    EXPECT_EQ(
        std::count_if(found.begin(), found.end(), [&](auto v) { return std::abs(v - exact) < rounding; }), 1);
  EXPECT_LT((A * pairs.vectors - pairs.vectors * pairs.values.asDiagonal()).norm(), rounding);
  for (Eigen::Index k = 0; k < 3; ++k) EXPECT_NEAR(pairs.vectors.col(k).norm(), 1, rounding);
  EXPECT_LT((complex_values(A) - pairs.values).norm(), rounding);
}

TEST(Dense, BasisLeavesOutWhatIsInTheSpanAlready) {
  MatrixXd columns(4, 3);
  columns.col(0) << 3, 0, 4, 0;
  columns.col(1) << 0, 1, 0, 0;
  columns.col(2) = 2 * columns.col(0) + columns.col(1);
  columns(3, 2) = 1e-7;
  const MatrixXd two = orthonormal_basis(columns, 1e-6), three = orthonormal_basis(columns, 1e-9);
  ASSERT_EQ(two.cols(), 2);
  ASSERT_EQ(three.cols(), 3);
  EXPECT_LT((two.transpose() * two - MatrixXd::Identity(2, 2)).norm(), rounding);
  EXPECT_LT((columns.leftCols(2) - two * (two.transpose() * columns.leftCols(2))).norm(), 1e-6);
  EXPECT_LT((columns - three * (three.transpose() * columns)).norm(), rounding);
  EXPECT_EQ(orthonormal_basis(MatrixXd::Zero(4, 2), 0).cols(), 0);
  EXPECT_EQ(orthonormal_basis(MatrixXd(4, 0), 0).rows(), 4);
}

TEST(Dense, NoRowsHaveNoPairsAndNumbersThatAreNotFiniteAreRefused) {
  EXPECT_EQ(symmetric_pairs(MatrixXd(0, 0)).values.size(), 0);
  EXPECT_EQ(complex_pairs(MatrixXd(0, 0)).values.size(), 0);
  MatrixXd A = second_differences(3);
  A(2, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(symmetric_pairs(A), InputError);
  EXPECT_THROW(complex_values(A), InputError);
  EXPECT_THROW(orthonormal_basis(A, 0), InputError);
}

}  // namespace
}  // namespace plumb
