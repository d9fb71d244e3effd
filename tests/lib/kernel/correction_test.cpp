// Known values of the corrections and refusals.
#include "lib/kernel/correction.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "tests/support/clouds.hpp"

namespace plumb {
namespace {

std::vector<Neighbour<2>> corner(double spacing, Layout layout, std::vector<Vec<2>>* points = nullptr) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), {1.2, 1.2}}, {6, 6}, layout);
  std::vector<Index> numbers;
  auto found = test::neighbours_of<2>(cloud, cloud.X[0], 1.8 * spacing, &numbers);
  if (points != nullptr)
    for (const Index n : numbers) points->push_back(cloud.X[n]);
  return found;
}

// Values of an independent calculation, 12 digits: relative tolerance 1e-11.
TEST(W1, CornerOfACellLattice) {
  std::vector<Vec<2>> points;
  const auto neighbours = corner(0.2, Layout::cell, &points);
  const auto k = correct<2>(Correction::W1, kernel_named<2>("cubic"), 0.18, neighbours);
  EXPECT_NEAR(k.alpha, 1.75308788617, 1e-11);
  EXPECT_NEAR(k.beta[0], 4.54200761276, 1e-11);
  EXPECT_NEAR(k.beta[1], 4.54200761276, 1e-11);
  int found = 0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double W1 = k.weight[j] / neighbours[j].volume;
    const auto expect_at = [&](double x, double y, double value, double tolerance) {
      if ((points[j] - Vec<2>(x, y)).norm() > 1e-9) return;
      EXPECT_NEAR(W1, value, tolerance);
      ++found;
    };
    expect_at(0.1, 0.1, 24.6042859575, 1e-9);
    expect_at(0.3, 0.1, 0.395714042455, 1e-11);
    expect_at(0.3, 0.3, -0.395714042455, 1e-11);
  }
  EXPECT_EQ(found, 3);
}

TEST(W1, CornerOfANodeLattice) {
  const auto k = correct<2>(Correction::W1, kernel_named<2>("cubic"), 0.18, corner(0.2, Layout::node));
  EXPECT_NEAR(k.alpha, 6.75770368155, 1e-11);
  EXPECT_NEAR(k.beta[0], 4.22583913803, 1e-11);
}

// Continuum limit at a wall: alpha = 75/13, beta = 1.4/h (moments of the half kernel: 1/2, 7/30 h, 1/6 h^2).
TEST(W1, HalfLineContinuumAtAWall) {
  const double h = 1;
  std::vector<Neighbour<1>> half;
  const int n = 4000;
  half.reserve(n);
  for (int j = 0; j < n; ++j) half.push_back({Vec<1>((j + 0.5) * 2 * h / n), 2 * h / n});
  const auto k = correct<1>(Correction::W1, kernel_named<1>("cubic"), h, half);
  // the midpoint rule is second order: (2/4000)^2 times a constant of order 10
  EXPECT_NEAR(k.alpha, 75.0 / 13, 1e-5);
  EXPECT_NEAR(k.beta[0], 1.4, 1e-5);
}

TEST(Uncorrected, LosesHalfOfTheWeightAtABoundary) {
  std::vector<Neighbour<1>> half;
  half.reserve(4);
  for (int j = 0; j < 4; ++j) half.push_back({Vec<1>(j * 0.5), j == 0 ? 0.25 : 0.5});
  const auto k = correct<1>(Correction::none, kernel_named<1>("cubic"), 1, half);
  double sum = 0;
  for (const double w : k.weight) sum += w;
  EXPECT_NEAR(sum, 0.5, 1e-12);  // splines sum to one on lattices that divide h: round-off
}

// (12) as printed, L = M^-1, does not meet (9b) at the corner of a node layout; its transpose does.
TEST(W0, NeedsTheTransposeThatThePrintLacks) {
  const Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), {1.2, 1.2}}, {6, 6}, Layout::node);
  const double h = 0.9 * cloud.spacing;
  double worst = 0;
  for (const auto& X : cloud.X) {
    const auto neighbours = test::neighbours_of<2>(cloud, X, 2 * h);
    const auto raw = correct<2>(Correction::W0raw, kernel_named<2>("cubic"), h, neighbours);
    Mat<2> M = Mat<2>::Zero();
    for (std::size_t j = 0; j < neighbours.size(); ++j)
      M += neighbours[j].separation * raw.gradient[j].transpose();
    Mat<2> printed = Mat<2>::Zero();
    for (std::size_t j = 0; j < neighbours.size(); ++j)
      printed += neighbours[j].separation * (M.inverse() * raw.gradient[j]).transpose();
    worst = std::max(worst, (printed - Mat<2>::Identity()).norm());
  }
  EXPECT_GT(worst, 2e-3);  // an independent program found 2e-3 to 2e-2
  EXPECT_LT(worst, 5e-2);
}

template <int d>
void expect_refusal(const std::vector<Neighbour<d>>& neighbours, double h, const std::string& part) {
  for (const Correction pair : {Correction::W0, Correction::W1}) {
    try {
      correct<d>(pair, kernel_named<d>("cubic"), h, neighbours);
      FAIL() << "a singular neighbourhood was accepted, pair " << name_of(pair);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

TEST(SingularNeighbourhood, IsRefusedWithTheNumberOfNeighbours) {
  expect_refusal<1>({{Vec<1>(0), 1}}, 1, "0 neighbours span 0 of 1");
  expect_refusal<2>({{Vec<2>(0, 0), 1}}, 1, "0 neighbours span 0 of 2");
  expect_refusal<2>({{Vec<2>(0, 0), 1}, {Vec<2>(1, 1), 1}, {Vec<2>(-1, -1), 1}, {Vec<2>(0.5, 0.5), 1}}, 1,
                    "3 neighbours span 1 of 2");
  expect_refusal<3>({{Vec<3>(0, 0, 0), 1}, {Vec<3>(1, 0, 0), 1}, {Vec<3>(0, 1, 0), 1}, {Vec<3>(1, 1, 0), 1}},
                    1, "3 neighbours span 2 of 3");
}

// R slightly above the spacing: the weights of the neighbours are tiny, the neighbourhood is still regular,
// and the gradient is still exact. No absolute threshold may refuse it.
TEST(SingularNeighbourhood, TinyWeightsAreNotSingular) {
  for (const double excess : {1e-3, 1e-6, 1e-9}) {
    const double h = (1 + excess) / 2;  // R = 1 + excess, spacing 1
    const std::vector<Neighbour<1>> three = {{Vec<1>(-1), 1}, {Vec<1>(0), 1}, {Vec<1>(1), 1}};
    const auto k = correct<1>(Correction::W1, kernel_named<1>("cubic"), h, three);
    EXPECT_NEAR(k.gradient[2][0] - k.gradient[0][0], 1, 1e-6)
        << excess;  // w'/w ~ 3/excess, rounding of R: 1e-16/excess
  }
}

}  // namespace
}  // namespace plumb
