// Large bodies get the ends of their spectrum by iteration. On bodies that are small enough for all
// eigenvalues, both ways must say the same.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <iostream>

#include "lib/scene/tlsph.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb {
namespace {

/// A body by what matters here; `n` particles along each edge.
struct Body {
  int dimension, n;
  const char *momentum, *gradient, *pair;
  double beta, poisson, jitter, eta4;
  bool clamped;
};

Scene scene_of(const Body& body) {
  Scene scene;
  scene.name = "body";
  scene.dimension = body.dimension;
  scene.end_time = 1;
  scene.body.size.assign(static_cast<std::size_t>(body.dimension), 1.0);
  scene.body.layout = body.clamped ? Layout::node : Layout::cell;
  scene.body.spacing = 1.0 / (body.clamped ? body.n - 1 : body.n);
  scene.body.jitter = body.jitter;
  scene.material = {"neo-hookean", 17e6, body.poisson, 1100};
  scene.method.momentum = body.momentum;
  scene.method.gradient = body.gradient;
  scene.method.pair = body.pair;
  scene.method.beta = body.beta;
  if (body.eta4 > 0) scene.method.jst = JstOptions{0, body.eta4};
  if (body.clamped) {
    Boundary base;
    base.face = Face{0, -1};
    scene.boundaries.push_back(base);
  }
  return scene;
}

template <int d>
LinearOperator<d> operator_of(const Body& body) {
  const TlsphBody<d> simulation = make_tlsph<d>(scene_of(body));
  return {simulation.solid, simulation.supports};
}

constexpr Index never_dense = 10;

/// All eigenvalues, and by iteration.
template <int d>
std::pair<Spectrum, Spectrum> both_ways(const Body& body) {
  auto op = operator_of<d>(body);
  return {spectrum_of(op, {.dense_limit = 4000}), spectrum_of(op, {.dense_limit = never_dense})};
}

/// Dimension, n; momentum, gradient, pair; beta, nu, jitter, eta4; clamped.
const std::vector<Body> bodies{{2, 10, "symmetrised", "standard", "W1", 0.9, 0.4, 0, 0, false},
                               {2, 10, "symmetrised", "improved", "W1", 1.2, 0.3, 0.2, 0, false},
                               {2, 9, "symmetrised", "standard", "W0", 0.9, 0.495, 0.3, 0, true},
                               {2, 11, "symmetrised", "improved", "W1", 0.9, 0.45, 0.2, 1.0 / 64, false},
                               {2, 10, "adjoint", "standard", "W1", 1.2, 0.3, 0, 0, false},
                               {3, 4, "symmetrised", "standard", "W1", 0.9, 0.495, 0, 0, false},
                               {3, 4, "symmetrised", "standard", "W1", 0.9, 0.495, 0, 1.0 / 64, false},
                               {3, 4, "symmetrised", "standard", "W1", 0.9, 0.495, 0, 1.0 / 8, false},
                               {3, 5, "symmetrised", "improved", "W1", 1.0, 0.45, 0.2, 0, true},
                               {3, 4, "adjoint", "improved", "W1", 0.9, 0.495, 0.2, 0, false}};

void expect_the_same_growth(const Spectrum& all, const Spectrum& some) {
  ASSERT_TRUE(all.complete);
  ASSERT_FALSE(some.complete);
  // three digits are promised, of what is faster than the resolution
  const auto expect_near = [](const Growth& by_iteration, const Growth& right) {
    const bool slow = right.rate < by_iteration.resolution;
    EXPECT_NEAR(by_iteration.rate, right.rate, slow ? by_iteration.resolution : 5e-4 * right.rate);
  };
  expect_near(some.growth, all.growth);
  expect_near(some.growth_undamped, all.growth_undamped);
  EXPECT_NEAR(some.largest, all.largest, 1e-7 * all.largest);  // 1e-10 is asked of the iteration
  ASSERT_TRUE(some.lowest_nonrigid());
  EXPECT_NEAR(*some.lowest_nonrigid(), *all.lowest_nonrigid(), 1e-6 * all.largest);
  EXPECT_LE(some.complex_pairs.found, all.complex_pairs.found);
  EXPECT_LE(some.negative.found, all.negative.found);
}

/// Of so many of the bodies; returns how many of them grow.
int expect_growth_of(std::size_t first, std::size_t last) {
  int growing = 0;
  for (std::size_t n = first; n < last; ++n) {
    SCOPED_TRACE("body " + std::to_string(n));
    const auto [all, some] = bodies[n].dimension == 2 ? both_ways<2>(bodies[n]) : both_ways<3>(bodies[n]);
    std::cout << n << ": growth " << all.growth.rate << ' ' << some.growth.rate << ", undamped "
              << all.growth_undamped.rate << ' ' << some.growth_undamped.rate << ", resolution "
              << some.growth.resolution << ", pairs " << all.complex_pairs.found << ' '
              << some.complex_pairs.found << ", negative " << all.negative.found << ' ' << some.negative.found
              << ", lowest " << *all.lowest_nonrigid() << ' ' << some.lowest_nonrigid().value_or(NAN) << '\n';
    expect_the_same_growth(all, some);
    growing += all.growth.rate > 2 * some.growth.resolution;
  }
  return growing;
}

TEST(Iteration, FindsTheGrowthOfThreeBodies) {
  EXPECT_GE(expect_growth_of(0, 3), 2) << "bodies without growth show little";
}

TEST(IterationLong, FindsTheGrowthOfTheOtherSeven) {
  ASSERT_EQ(bodies.size(), 10u);
  EXPECT_GE(expect_growth_of(3, 10), 4) << "bodies without growth show little";
}

/// The lowest eigenvalue is negative here: another one is nearer to zero.
TEST(Iteration, FindsTheAlgebraicallyLowestEigenvalue) {
  const auto [all, some] = both_ways<3>({3, 6, "symmetrised", "standard", "W1", 0.9, 0.495, 0, 0, false});
  ASSERT_TRUE(some.lowest_nonrigid());
  // published digits of all eigenvalues by another program
  EXPECT_NEAR(*all.lowest_nonrigid(), -0.006816, 5e-7);
  EXPECT_NEAR(*some.lowest_nonrigid(), -0.006816, 5e-7);
  EXPECT_NEAR(some.growth.rate, 0.08256, 5e-6);
  EXPECT_EQ(all.negative, (Count{1, false}));
  EXPECT_EQ(some.negative, (Count{1, true}));
  EXPECT_EQ(all.complex_pairs, (Count{65, false}));
  EXPECT_GT(some.complex_pairs.found, 0);
  EXPECT_LE(some.complex_pairs.found, 65);
  EXPECT_TRUE(some.complex_pairs.at_least);
}

/// Every eigenvalue off the real line belongs to one pair: counted another way, by those that are real.
TEST(Iteration, CountsEveryComplexPairOnce) {
  auto op = operator_of<2>({2, 10, "symmetrised", "standard", "W1", 1.2, 0.4, 0.2, 0, false});
  const Spectrum s = spectrum_of(op);
  const Eigen::VectorXcd values =
      Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(op.stiffness_matrix()), false).eigenvalues();
  Index real = 0;
  for (const auto& value : values) real += std::abs(value.imag()) < 1e-10 * s.largest;
  ASSERT_GT(s.complex_pairs.found, 0);
  EXPECT_EQ(2 * s.complex_pairs.found, op.size() - real);
}

/// Every one of the lowest modes is spurious: what was not found is not a number.
TEST(Iteration, ASmoothModeThatWasNotFoundIsNotZero) {
  Scene scene = scene_of({2, 5, "adjoint", "standard", "W1", 2.828, 0.4, 0, 0, true});
  scene.body.size = {0.35, 0.02};
  scene.body.spacing = 0.005;
  scene.method.kernel = "wendland-c2";
  const TlsphBody<2> simulation = make_tlsph<2>(scene);
  LinearOperator<2> op(simulation.solid, simulation.supports);
  const Spectrum some = spectrum_of(op, {.dense_limit = 500});
  EXPECT_FALSE(some.low.lowest_smooth);
  EXPECT_FALSE(some.low.near_zero_not_rigid);
  EXPECT_EQ(some.low.spurious_below_smooth, (Count{24, true}));
  const Spectrum all = spectrum_of(op);
  ASSERT_TRUE(all.low.lowest_smooth);
  EXPECT_EQ(all.low.spurious_below_smooth, (Count{626, false}));
  EXPECT_EQ(all.low.near_zero_not_rigid, (Count{505, false}));
  EXPECT_GT(*all.low.lowest_smooth, 0);
}

}  // namespace
}  // namespace plumb
