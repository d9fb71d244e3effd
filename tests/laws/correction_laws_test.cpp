// The corrections keep the conditions (5a), (5b), (9a), (9b) of paper 000 at every particle of every cloud,
// for every kernel of the catalogue in 1D, 2D and 3D; corners included. THEORY (2.1).
#include <gtest/gtest.h>

#include "lib/kernel/correction.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

/// The four sums; each is without dimension: lengths in h.
template <int d>
struct Sums {
  double weight = 0;                       // (5a): 1
  Vec<d> first = Vec<d>::Zero();           // (5b): 0
  Vec<d> gradient = Vec<d>::Zero();        // (9a): 0
  Mat<d> gradient_first = Mat<d>::Zero();  // (9b): I
};

template <int d>
Sums<d> sums(const CorrectedKernel<d>& k, const std::vector<Neighbour<d>>& neighbours, double h) {
  Sums<d> s;
  for (std::size_t j = 0; j < neighbours.size(); ++j) {
    const Vec<d>& X = neighbours[j].separation;
    s.weight += k.weight[j];
    s.first += k.weight[j] * X / h;
    s.gradient += k.gradient[j] * h;
    s.gradient_first += X * k.gradient[j].transpose();
  }
  return s;
}

constexpr double tolerance =
    1e-12;  // some hundred terms of order 1 and a moment matrix of condition up to 1e3

/// The conditions that the pair promises, at the particle X_i.
template <int d>
void expect_conditions(Correction pair, const CorrectedKernel<d>& k,
                       const std::vector<Neighbour<d>>& neighbours, double h) {
  const Sums<d> s = sums(k, neighbours, h);
  EXPECT_NEAR(s.weight, 1, tolerance) << "(5a)";
  EXPECT_LT(s.gradient.norm(), tolerance) << "(9a)";
  if (pair == Correction::W1) {
    EXPECT_LT(s.first.norm(), tolerance) << "(5b)";
  }
  if (pair != Correction::W0raw) {
    EXPECT_LT((s.gradient_first - Mat<d>::Identity()).norm(), tolerance) << "(9b)";
  }
}

template <class Case>
class CorrectionLaws : public ::testing::Test {};
TYPED_TEST_SUITE(CorrectionLaws, test::AllDimensions<KernelCatalogue>, test::Names);

TYPED_TEST(CorrectionLaws, ReproduceConstantAndLinearFieldsAtEveryParticle) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const RadialKernel<d> kernel = radial_kernel<d, K>();
  for (const auto& [name, cloud] : test::all_clouds<d>())
    for (const double reach : {1.8, 3.0}) {  // R over spacing: beta 0.9 and 1.5 of the kernels with support 2
      const double h = reach * cloud.spacing / K::support;
      for (Index i = 0; i < cloud.size(); ++i) {
        const auto neighbours = test::neighbours_of<d>(cloud, cloud.X[i], reach * cloud.spacing);
        for (const Correction pair : {Correction::W0raw, Correction::W0, Correction::W1}) {
          SCOPED_TRACE(name + ", " + std::string(name_of(pair)) + ", particle " + std::to_string(i));
          expect_conditions<d>(pair, correct<d>(pair, kernel, h, neighbours), neighbours, h);
          if (::testing::Test::HasFailure()) return;  // one particle is enough to read
        }
      }
    }
}

/// The largest difference between the gradient and a fourth-order difference of the weights, both times h,
/// when the evaluation point moves.
template <int d>
double gradient_error(Correction pair, const RadialKernel<d>& kernel, const Cloud<d>& cloud,
                      const Vec<d>& point, double h, double step) {
  const double R = kernel.support * h;
  std::vector<Neighbour<d>> all;  // R + 2 step: nothing leaves the list while the point moves
  all = test::neighbours_of<d>(cloud, point, R + 3 * step);
  const auto weights = [&](int k, double shift) {
    std::vector<Neighbour<d>> seen = all;
    for (auto& n : seen) n.separation[k] -= shift;
    return correct<d>(pair, kernel, h, seen).weight;
  };
  const CorrectedKernel<d> exact = correct<d>(pair, kernel, h, all);
  double error = 0;
  for (int k = 0; k < d; ++k) {
    const auto p1 = weights(k, step), m1 = weights(k, -step), p2 = weights(k, 2 * step),
               m2 = weights(k, -2 * step);
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double difference = (8 * (p1[j] - m1[j]) - (p2[j] - m2[j])) / (12 * step);
      error = std::max(error, std::abs(difference - exact.gradient[j][k]) * h);
    }
  }
  return error;
}

/// True if no particle comes near a knot of the kernel (multiples of h/2, 0 included) while the point moves
/// by 2 step.
template <int d>
bool away_from_knots(const Cloud<d>& cloud, const Vec<d>& point, double h, double step) {
  for (const auto& X : cloud.X) {
    const double q = (X - point).norm() / h;
    if (std::abs(q - 0.5 * std::round(2 * q)) < 2.5 * step / h) return false;
  }
  return true;
}

TYPED_TEST(CorrectionLaws, GradientIsTheDerivativeWithRespectToTheEvaluationPoint) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const RadialKernel<d> kernel = radial_kernel<d, K>();
  const Cloud<d> cloud = test::all_clouds<d>()[3].cloud;  // node layout, jittered
  const double h = 2.2 * cloud.spacing / K::support, step = 1e-3 * h;
  test::Numbers numbers(7);
  int checked = 0;
  for (int attempt = 0; attempt < 4000 && checked < 12; ++attempt) {
    const Vec<d> unit =
        0.5 * (numbers.vector<d>() + Vec<d>::Ones());  // anywhere in the box, near corners too
    const Vec<d> point = cloud.box.origin + unit.cwiseProduct(cloud.box.size);
    if (!away_from_knots<d>(cloud, point, h, step)) continue;
    ++checked;
    for (const Correction pair : {Correction::none, Correction::W0raw, Correction::W1})
      // step^4 times a fifth derivative of some thousand at points near corners, and round-off 1e-15/step
      EXPECT_LT(gradient_error<d>(pair, kernel, cloud, point, h, step), 2e-8)
          << name_of(pair) << " at " << point;
  }
  EXPECT_EQ(checked, 12);
}

TYPED_TEST(CorrectionLaws, DoNotDependOnTheUnitOfLength) {
  using K = typename TypeParam::part;
  constexpr int d = TypeParam::d;
  const RadialKernel<d> kernel = radial_kernel<d, K>();
  const Cloud<d> cloud = test::all_clouds<d>()[2].cloud;
  const double h = 1.8 * cloud.spacing / K::support;
  for (const Index i : {Index{0}, cloud.size() / 2, cloud.size() - 1}) {
    const auto metres = test::neighbours_of<d>(cloud, cloud.X[i], kernel.support * h);
    for (const double scale : {1e-6, 1e6}) {
      auto scaled = metres;
      for (auto& n : scaled) n = {n.separation * scale, n.volume * std::pow(scale, d)};
      for (const Correction pair : {Correction::none, Correction::W0raw, Correction::W0, Correction::W1}) {
        const auto a = correct<d>(pair, kernel, h, metres);
        const auto b = correct<d>(pair, kernel, h * scale, scaled);
        for (std::size_t j = 0; j < metres.size(); ++j) {
          EXPECT_NEAR(b.weight[j], a.weight[j], tolerance);
          EXPECT_LT((b.gradient[j] * h * scale - a.gradient[j] * h).norm(), tolerance);
        }
      }
    }
  }
}

}  // namespace
}  // namespace plumb
