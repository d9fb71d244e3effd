#include "plumbline/spectrum/krylov.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace plumb
