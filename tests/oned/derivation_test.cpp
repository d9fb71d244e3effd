// Every kernel, pair and estimator of oned/ against the second derivation in long double.
#include <gtest/gtest.h>

#include <map>

#include "oned/explorer.hpp"
#include "oned/gradient.hpp"
#include "tests/oned/second_derivation.hpp"

namespace {

using namespace plumb;
using namespace plumb::oned;
using Real = long double;

struct Case {
  std::string kernel;
  second::Kernel second;
  Real support;
};
const std::vector<Case> kernels = {{"cubic", second::Kernel::cubic, 2},
                                   {"quintic", second::Kernel::quintic, 3},
                                   {"wendland-c2", second::Kernel::wendland, 2},
                                   {"quadratic", second::Kernel::quadratic, 2}};

std::vector<Discretisation> clouds() {
  std::vector<Discretisation> all;
  for (const Layout layout : {Layout::cell, Layout::node})
    for (const double jitter : {0.0, 0.3})
      for (const double radius : {1.8, 4.0, 7.5}) {
        Discretisation d;
        d.length = 2;
        d.n = 24;
        d.layout = layout;
        d.jitter = jitter;
        d.seed = 11;
        d.radius.value = radius;
        all.push_back(d);
      }
  return all;
}

second::Cloud<Real> copy_of(const Cloud<1>& cloud) {
  second::Cloud<Real> copy;
  for (const auto& X : cloud.X) copy.X.push_back(X[0]);
  copy.V.assign(cloud.V.begin(), cloud.V.end());
  return copy;
}

TEST(Derivation, KernelsAndGradientsAtAnyPoint) {
  for (const auto& k : kernels)
    for (Discretisation d : clouds()) {
      d.kernel = k.kernel;
      const auto copy = copy_of(make_cloud(d));
      const Real h = static_cast<Real>(d.support()) / k.support;
      for (const double x : {0.0, 0.017, 1.0, 1.93}) {
        const KernelView view = explore(d, x);
        const auto plain = second::weights<Real>(copy, x, k.second, h, -1);
        const auto shepard = second::weights<Real>(copy, x, k.second, h, 0);
        const auto first = second::weights<Real>(copy, x, k.second, h, 1);
        auto L0 = shepard, L = plain;
        second::normalise(L0, copy, Real(x));
        second::normalise(L, copy, Real(x));
        EXPECT_NEAR(view.alpha, static_cast<double>(first.alpha), 1e-11 * std::abs(view.alpha));
        for (const KernelRow& row : view.rows) {
          const auto j =
              static_cast<std::size_t>(std::find(copy.X.begin(), copy.X.end(), Real(row.x)) - copy.X.begin());
          ASSERT_LT(j, copy.X.size());
          const Real V = copy.V[j];
          // W1 divides by the variance of the weights: with one neighbour at the rim of the support it costs
          // digits
          const double scale = 1e-10 * (1 + std::abs(view.alpha)) / d.dx(), slope = scale / d.dx();
          EXPECT_NEAR(row.W, static_cast<double>(plain.w[j] / V), scale);
          EXPECT_NEAR(row.W0, static_cast<double>(shepard.w[j] / V), scale);
          EXPECT_NEAR(row.W1, static_cast<double>(first.w[j] / V), scale);
          EXPECT_NEAR(row.gradW, static_cast<double>(plain.g[j] / V), slope);
          EXPECT_NEAR(row.LgradW, static_cast<double>(L.g[j] / V), slope);
          EXPECT_NEAR(row.gradW0, static_cast<double>(shepard.g[j] / V), slope);
          EXPECT_NEAR(row.LgradW0, static_cast<double>(L0.g[j] / V), slope);
          EXPECT_NEAR(row.gradW1, static_cast<double>(first.g[j] / V), slope);
        }
      }
    }
}

/// (33), (34)+(35), (34)+(36) in long double for one pair.
std::map<std::string, Real> estimates(const second::Cloud<Real>& cloud, std::size_t i,
                                      const std::vector<Real>& x, const Case& k, Real h, Correction pair) {
  auto w = second::weights<Real>(cloud, cloud.X[i], k.second, h,
                                 pair == Correction::none ? -1
                                 : pair == Correction::W1 ? 1
                                                          : 0);
  if (pair == Correction::W0) second::normalise(w, cloud, cloud.X[i]);
  return {{"standard", second::standard(w, x)},
          {"bond", second::bond(w, cloud, i, x)},
          {"improved", second::improved(w, cloud, i, x)}};
}

TEST(Derivation, EstimatesByThePrintedSums) {
  const TestField field = parse_field("tanh:2,0.7");
  for (const auto& k : kernels)
    for (Discretisation d : clouds()) {
      d.kernel = k.kernel;
      const Cloud<1> cloud = make_cloud(d);
      const auto copy = copy_of(cloud);
      const auto x = values(field, cloud.X);
      const std::vector<Real> long_x(x.begin(), x.end());
      const Real h = static_cast<Real>(d.support()) / k.support;
      for (const Correction pair : {Correction::none, Correction::W0raw, Correction::W0, Correction::W1})
        for (const char* estimator : {"standard", "bond", "improved"}) {
          const auto F = estimate(cloud, kernel_named<1>(k.kernel), d.support(), {estimator, pair}, x);
          for (std::size_t i = 0; i < F.size(); ++i) {
            const auto expected = static_cast<double>(estimates(copy, i, long_x, k, h, pair)[estimator]);
            // x is of size 1 and the sums of size 1/dx = 12; jittered ends lose up to three digits in W1's
            // variance
            EXPECT_NEAR(F[i], expected, 1e-11)
                << k.kernel << " " << estimator << " " << name_of(pair) << " particle " << i << " R/dx "
                << d.radius.value << " jitter " << d.jitter;
          }
        }
    }
}

TEST(Derivation, DifferenceFormWithoutCorrection) {
  Discretisation d;
  d.n = 20;
  const Cloud<1> cloud = make_cloud(d);
  const std::vector<double> constant(cloud.X.size(), 3.0);
  const auto kernel = kernel_named<1>("cubic");
  const auto difference =
      estimate(cloud, kernel, 1.0, {"standard", Correction::none, Form::difference}, constant);
  const auto printed = estimate(cloud, kernel, 1.0, {"standard", Correction::none, Form::printed}, constant);
  EXPECT_EQ(difference.front(), 0);
  // half the kernel is missing at the first particle: the printed sum sees a slope of 3 times sum V grad W
  const auto w = second::weights<Real>(copy_of(cloud), cloud.X[0][0], second::Kernel::cubic, 0.5L, -1);
  Real sum = 0;
  for (const Real g : w.g) sum += g;
  EXPECT_GT(std::abs(static_cast<double>(sum)), 1);
  EXPECT_NEAR(printed.front(), static_cast<double>(3 * sum), 1e-13 * 10);
}

TEST(Derivation, DifferenceFormKeepsItsDigitsUnderALargeOffset) {
  Discretisation d;  // dx = 1/8: all positions and values are exact
  const auto rows = gradient_rows(d, {parse_field("poly:1e8,1")},
                                  {{"standard", Correction::W1}, {"improved", Correction::W1}});
  for (const auto& row : rows) EXPECT_NEAR(row.value, 1, 1e-14);  // the printed sum keeps seven digits
}

TEST(Derivation, SupportMuchLargerThanTheBodyLosesNoDigits) {
  Discretisation d;
  d.radius = {5e8, true};
  const auto rows = gradient_rows(d, {parse_field("poly:1,1")},
                                  {{"standard", Correction::W1}, {"improved", Correction::W1}});
  for (const auto& row : rows) EXPECT_NEAR(row.value, 1, 1e-12);
}

TEST(Derivation, SupportSlightlyLargerThanTheSpacing) {
  Discretisation d;
  d.radius.value = 1 + 1e-9;  // W of the neighbours is of size 1e-27: no absolute threshold may see that
  const auto rows = gradient_rows(d, {parse_field("poly:1,1")},
                                  {{"standard", Correction::W1}, {"improved", Correction::W1}});
  for (const auto& row : rows)
    EXPECT_NEAR(row.value, 1, 1e-6);  // 1 + 1e-9 is known to 7 digits as a distance from 1
}

}  // namespace
