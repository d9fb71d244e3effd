// What every law with history must obey: it feels no rotation, its tangent is the derivative of its stress, an increment
// that leads nowhere changes nothing, dissipation is not negative, and small strains are Hooke's.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "lib/material/laws.hpp"

namespace plumb {
namespace {

template <class>
struct Tests;
template <class... Ms>
struct Tests<TypeList<Ms...>> {
  using Types = ::testing::Types<Ms...>;
};

template <class... Ms>
auto history_among(TypeList<Ms...>) {
  return (TypeList<>{} + ... + std::conditional_t<HistoryLaw<Ms>, TypeList<Ms>, TypeList<>>{});
}

/// Every parameter away from nothing: pure numbers at 0.7, stresses at a thousandth of mu, each next one twice as large.
template <class M>
M law_of(const Elastic& elastic) {
  std::map<std::string, double> values;
  double stress = 1e-3 * elastic.shear_modulus();
  for (const LawParameter& about : parameters_of_law(M::name)) {
    const bool number = about.quantity.dimension == Dimension{};
    values[std::string(about.name)] = number ? std::min(0.7, about.most) : stress;
    if (!number) stress *= 2;
  }
  return make_law<M>(elastic, {std::string(M::name), values});
}

template <class M>
std::vector<double> numbers_of(typename M::History history) {
  std::vector<double> all;
  history.fields([&](std::string_view, std::string_view, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>)
      all.push_back(value);
    else
      all.insert(all.end(), value.data(), value.data() + value.size());
  });
  return all;
}

template <class M>
class HistoryLaws : public ::testing::Test {
 protected:
  const Elastic elastic{17e6, 0.3, 1100};
  const M law = law_of<M>(elastic);
  std::mt19937_64 random{7};

  double next() { return 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1; }
  Mat<3> deformation(double size) {
    Mat<3> F = Mat<3>::Identity();
    for (int n = 0; n < 9; ++n) F(n / 3, n % 3) += size * next();
    return F;
  }
  /// The history after a path of ten increments to larger and larger strains.
  typename M::History loaded() {
    typename M::History history;
    const Mat<3> H = deformation(0.05) - Mat<3>::Identity();
    for (int n = 1; n <= 10; ++n) law.stress(Mat<3>::Identity() + 0.1 * n * H, history);
    return history;
  }
};
struct Name {
  template <class M>
  static std::string GetName(int) {
    std::string name(M::name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};
TYPED_TEST_SUITE(HistoryLaws, typename Tests<decltype(history_among(MaterialCatalogue{}))>::Types, Name);

TYPED_TEST(HistoryLaws, SmallStrainsAreHookes) {
  const double size = 1e-7, lambda = this->elastic.bulk_modulus() - 2.0 / 3 * this->elastic.shear_modulus();
  const Mat<3> F = this->deformation(size), e = 0.5 * (F + F.transpose()) - Mat<3>::Identity();
  typename TypeParam::History history;
  const Mat<3> hooke = lambda * e.trace() * Mat<3>::Identity() + 2 * this->elastic.shear_modulus() * e;
  // the next order is the strain times this; a history that grows with the energy starts as slowly
  EXPECT_LT((this->law.stress(F, history).P - hooke).norm(), 20 * size * hooke.norm());
}

TYPED_TEST(HistoryLaws, RotationsTurnTheStressAndLeaveTheHistoryAlone) {
  const Mat<3> Q = Eigen::AngleAxisd(1.1, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix();
  const auto start = this->loaded();
  for (const double size : {1e-4, 0.02, 0.2}) {
    const Mat<3> F = this->deformation(size);
    auto one = start, other = start;
    const Response plain = this->law.stress(F, one), turned = this->law.stress(Q * F, other);
    EXPECT_LT((turned.P - Q * plain.P).norm(), 1e-12 * this->elastic.shear_modulus());
    const auto a = numbers_of<TypeParam>(one), b = numbers_of<TypeParam>(other);
    for (std::size_t n = 0; n < a.size(); ++n) EXPECT_NEAR(a[n], b[n], 1e-12 * (1 + std::abs(a[n])));
    EXPECT_NEAR(this->law.energy(Q * F, other), this->law.energy(F, one),
                1e-12 * this->elastic.shear_modulus());
  }
}

TYPED_TEST(HistoryLaws, AnIncrementThatLeadsNowhereChangesNothing) {
  auto history = this->loaded();
  for (const double size : {1e-4, 0.02, 0.2}) {
    const Mat<3> F = this->deformation(size);
    const Response there = this->law.stress(F, history);
    const auto before = numbers_of<TypeParam>(history);
    const Response still = this->law.stress(F, history);
    // the return mapping ends within 1e-15 of the trial stress, and a second one may take that up
    EXPECT_LT((still.P - there.P).norm(), 1e-12 * this->elastic.shear_modulus());
    EXPECT_LT(std::abs(still.plastic_work), 1e-12 * this->elastic.shear_modulus());
    const auto after = numbers_of<TypeParam>(history);
    for (std::size_t n = 0; n < before.size(); ++n)
      EXPECT_NEAR(after[n], before[n], 1e-12 * (1 + std::abs(before[n])));
  }
}

TYPED_TEST(HistoryLaws, TangentIsTheDerivativeOfTheIncrement) {
  const auto start = this->loaded();
  for (const double size : {1e-4, 0.02, 0.2}) {
    const Mat<3> F = this->deformation(size);
    const Mat<9> tangent = this->law.tangent(F, start);
    for (int n = 0; n < 9; ++n) {
      const double e = 1e-6;
      Mat<3> ahead = F, behind = F;
      ahead(n / 3, n % 3) += e;
      behind(n / 3, n % 3) -= e;
      auto one = start, other = start;
      const Mat<3> slope = (this->law.stress(ahead, one).P - this->law.stress(behind, other).P) / (2 * e);
      for (int m = 0; m < 9; ++m)  // e^2 times third derivatives, and rounding over e
        EXPECT_NEAR(tangent(m, n), slope(m / 3, m % 3), 1e-5 * this->elastic.shear_modulus())
            << size << m << n;
    }
  }
}

/// What Newton's method lowers: its slope is the stress that the increment ends with, where the law flows and where it does not.
TYPED_TEST(HistoryLaws, StressIsTheDerivativeOfThePotentialOfTheIncrement) {
  const auto start = this->loaded();
  for (const double size : {1e-4, 0.02, 0.2}) {
    const Mat<3> F = this->deformation(size);
    auto end = start;
    const Mat<3> P = this->law.stress(F, end).P;
    for (int n = 0; n < 9; ++n) {
      const double e = 1e-5;
      Mat<3> ahead = F, behind = F;
      ahead(n / 3, n % 3) += e;
      behind(n / 3, n % 3) -= e;
      const double slope = (this->law.potential(ahead, start) - this->law.potential(behind, start)) / (2 * e);
      // e^2 times the derivatives of the tangent, and rounding over e
      EXPECT_NEAR(slope, P(n / 3, n % 3), 1e-7 * this->elastic.shear_modulus()) << size << n;
    }
  }
}

TYPED_TEST(HistoryLaws, DissipationIsNotNegativeAndClosesTheBalance) {
  typename TypeParam::History history;
  Mat<3> F = Mat<3>::Identity();
  Response last = this->law.stress(F, history);
  double work = 0, dissipated = 0;
  for (const double size : {0.05, 0.15, 0.0, 0.1}) {
    const Mat<3> end = this->deformation(size), from = F;
    const int increments = 4000;
    for (int n = 1; n <= increments; ++n) {
      const Mat<3> to = from + (end - from) * (static_cast<double>(n) / increments);
      const Response now = this->law.stress(to, history);
      EXPECT_GE(now.plastic_work, -1e-14 * this->elastic.shear_modulus());
      dissipated += now.plastic_work;
      work += (0.5 * (last.P + now.P)).cwiseProduct(to - F).sum();
      F = to, last = now;
    }
  }
  const double stored = this->law.energy(F, history);
  EXPECT_GT(dissipated, 1e-2 * work);
  // increments of 4e-5: backward increments are of first order in them
  EXPECT_NEAR(work, stored + dissipated, 2e-3 * work);
}

}  // namespace
}  // namespace plumb
