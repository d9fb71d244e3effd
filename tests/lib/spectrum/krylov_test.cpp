#include "lib/spectrum/krylov.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/spectrum/arnoldi.hpp"

namespace plumb {
namespace {

/// With steps of 1, growth at the rate s takes ln(2000 sqrt(n))/s steps to be a thousandfold: here about 600,
/// of the 800 that are made at most.
TEST(Krylov, FindsGrowthThatTakesHundredsOfSteps) {
  constexpr int n = 60;
  const double rate = std::log(2000 * std::sqrt(n)) / 600;
  SparseMatrix S(n, n);
  for (int i = 0; i < n - 1; ++i) S.insert(i, i) = (i + 1.0) / (n - 1);
  S.insert(n - 1, n - 1) = -rate * rate;
  S.makeCompressed();
  const GrowingMotions growing = growing_motions(S, true, 1);
  ASSERT_GE(growing.span.cols(), 1);
  // columns have length 1: one of them is the motion that grows, to some multiples of the accuracy of the
  // iteration, 1e-8
  EXPECT_NEAR(growing.span.row(n - 1).cwiseAbs().maxCoeff(), 1, 1e-6);
}

/// Steps until a start of length 1 in all modes of a diagonal operator has length 1000, by the closed form of
/// each mode: cos(n theta) with 4 sin(theta/2)^2 = value, cosh(n theta) with 4 sinh(theta/2)^2 = -value.
int steps_by_closed_form(const std::vector<double>& values) {
  const Eigen::VectorXd start = broad_start(static_cast<Index>(values.size()));
  for (int n = 1;; ++n) {
    double square = 0;
    for (std::size_t m = 0; m < values.size(); ++m) {
      const double root = std::sqrt(std::abs(values[m])) / 2;
      const double now =
          values[m] < 0 ? std::cosh(2 * n * std::asinh(root)) : std::cos(2 * n * std::asin(root));
      square += std::pow(start[static_cast<Index>(m)] * now, 2);
    }
    if (square >= 1e6) return n;
  }
}

/// What growth is slower than what is sure to be found follows from the steps that were made: here with the
/// largest eigenvalue 1, thus steps of 1.
TEST(Krylov, GrowthIsFollowedForAsManySteps) {
  for (const double rate : {0.02, 0.0213, 0.027, 0.031, 0.043, 0.057, 0.06, 0.083, 0.11, 0.15}) {
    SCOPED_TRACE(rate);
    std::vector<double> values(40);
    for (std::size_t m = 0; m + 1 < values.size(); ++m) values[m] = (static_cast<double>(m) + 1) / 39;
    values.back() = -rate * rate;
    SparseMatrix S(40, 40);
    for (int m = 0; m < 40; ++m) S.insert(m, m) = values[static_cast<std::size_t>(m)];
    S.makeCompressed();
    const GrowingMotions growing = growing_motions(S, true, 1);
    EXPECT_NEAR(std::log(1.3) / growing.resolution, steps_by_closed_form(values), 1e-9);
  }
}

}  // namespace
}  // namespace plumb
