// What every elastic law of the catalogue must obey, in 1D to 3D, with the parameters that it has by itself
// and with others.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <complex>
#include <random>

#include "lib/core/pack.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/tangent.hpp"
#include "mms/ad/jet.hpp"

namespace plumb::material_laws_test {
namespace {

template <class>
struct Tests;
template <class... Ms>
struct Tests<TypeList<Ms...>> {
  using Types = ::testing::Types<Ms...>;
};

/// The law with each of its parameters away from the default: pure numbers at 0.7, stresses at a tenth of mu.
template <class M>
M unusual(const Elastic& elastic) {
  std::map<std::string, double> values;
  for (const LawParameter& about : parameters_of_law(M::name))
    values[std::string(about.name)] =
        about.quantity.dimension == Dimension{} ? std::min(0.7, about.most) : 0.1 * elastic.shear_modulus();
  return make_law<M>(elastic, {std::string(M::name), values});
}

template <class M>
class MaterialLaws : public ::testing::Test {
 protected:
  const Elastic elastic{17e6, 0.45, 1100};
  M material{elastic};
  std::mt19937_64 random{5};

  double next() { return 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1; }
  template <int d>
  Mat<d> deformation(double size) {
    Mat<d> F = Mat<d>::Identity();
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) F(a, b) += size * next();
    return F;
  }
  std::array<M, 2> laws() const { return {M(elastic), unusual<M>(elastic)}; }
  template <class F>
  void in_every_dimension(F&& check) {
    for (const M& law : laws()) {
      material = law;
      check(std::integral_constant<int, 1>{});
      check(std::integral_constant<int, 2>{});
      check(std::integral_constant<int, 3>{});
    }
  }
};
struct Name {  ///< "neo_hookean": not the place in the catalogue, which moves with every new material
  template <class M>
  static std::string GetName(int) {
    std::string name(M::name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};
TYPED_TEST_SUITE(MaterialLaws, typename Tests<ElasticLaws>::Types, Name);

TYPED_TEST(MaterialLaws, NoEnergyAndNoStressAtRest) {
  this->in_every_dimension([&]<int d>(std::integral_constant<int, d>) {
    const Mat<d> I = Mat<d>::Identity();
    const double rounding = 1e-15 * this->elastic.bulk_modulus() * 10;
    EXPECT_NEAR(this->material.energy(I), 0, rounding);
    EXPECT_LT((this->material.first_piola(I)).norm(), rounding);
  });
}

TYPED_TEST(MaterialLaws, StressIsTheDerivativeOfTheEnergyByComplexStep) {
  this->in_every_dimension([&]<int d>(std::integral_constant<int, d>) {
    for (int n = 0; n < 20; ++n) {
      const Mat<d> F = this->template deformation<d>(0.3);
      const Mat<d> P = this->material.first_piola(F);
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) {
          Mat<d, std::complex<double>> Fc = F.template cast<std::complex<double>>();
          Fc(a, b) += std::complex<double>(0, 1e-100);
          const double expected = this->material.energy(Fc).imag() / 1e-100;
          EXPECT_NEAR(P(a, b), expected,
                      1e-12 * (P.norm() + 17e6));  // both sums round at 1e-16 of kappa = 57 MPa
        }
    }
  });
}

// A law that is not objective says so in its type, and is then seen not to be.
TYPED_TEST(MaterialLaws, ObjectivityAndSymmetryOfTheKirchhoffStress) {
  const auto differences = [&](const auto& law, double& turned, double& skew) {
    const Mat<3> F = this->template deformation<3>(0.4);
    const Mat<3> Q = Eigen::Quaterniond(this->next(), this->next(), this->next(), this->next())
                         .normalized()
                         .toRotationMatrix();
    const Mat<3> P = law.first_piola(F), tau = P * F.transpose();
    turned = (law.first_piola(Mat<3>(Q * F)) - Q * P).norm() / (P.norm() + 17e6);
    skew = (tau - tau.transpose()).norm() / (tau.norm() + 17e6);
  };
  for (const TypeParam& law : this->laws())
    for (int n = 0; n < 20; ++n) {
      double turned = 0, skew = 0;
      differences(law, turned, skew);
      if (is_objective<TypeParam>) {
        EXPECT_LT(turned, 1e-12);
        EXPECT_LT(skew, 1e-13);
      } else {
        EXPECT_GT(turned, 1e-2);
        EXPECT_GT(skew, 1e-3);
      }
    }
}

TYPED_TEST(MaterialLaws,
           TangentIsTheSecondDerivativeOfTheEnergy) {  // W in jets of second order; P is not asked
  this->in_every_dimension([&]<int d>(std::integral_constant<int, d>) {
    using Jet = mms::Jet<d * d>;
    for (int n = 0; n < 10; ++n) {
      const Mat<d> F = this->template deformation<d>(0.3);
      Mat<d, Jet> Fj;
      for (int k = 0; k < d * d; ++k) Fj(k / d, k % d) = Jet::variable(F(k / d, k % d), k);
      const Jet W = this->material.energy(Fj);
      const Mat<d* d> A = tangent_of<d>(this->material, F);
      for (int a = 0; a < d * d; ++a)
        for (int b = 0; b < d * d; ++b)
          EXPECT_NEAR(A(a, b), W.second(a, b), 1e-13 * (A.norm() + 17e6)) << a << ' ' << b;
    }
  });
}

TYPED_TEST(MaterialLaws, SmallStrainLimitGivesTheElasticConstants) {
  this->in_every_dimension([&]<int d>(std::integral_constant<int, d>) {
    Mat<d> G;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) G(a, b) = this->next();
    const double size = 1e-7;  // the next term is of relative size 1e-7, rounding 1e-16/1e-7
    const Mat<d> P = this->material.first_piola(Mat<d>(Mat<d>::Identity() + size * G)) / size;
    const Mat<d> strain = 0.5 * (G + G.transpose());
    const Mat<d> expected = this->elastic.lame() * strain.trace() * Mat<d>::Identity() +
                            2 * this->elastic.shear_modulus() * strain;
    EXPECT_LT((P - expected).norm(), 1e-5 * expected.norm());
  });
}

TYPED_TEST(MaterialLaws, PlaneStrainIsTheThreeDimensionalStressWithoutTheThirdDirection) {
  for (const TypeParam& law : this->laws())
    for (int n = 0; n < 10; ++n) {
      const Mat<2> F = this->template deformation<2>(0.3);
      Mat<3> G = Mat<3>::Identity();
      G.topLeftCorner<2, 2>() = F;
      EXPECT_NEAR(law.energy(F), law.energy(G), 1e-14 * 17e6 * 10);
      const Mat<3> P = law.first_piola(G);
      EXPECT_LT((law.first_piola(F) - P.topLeftCorner<2, 2>()).norm(), 1e-14 * (P.norm() + 17e6) * 10);
    }
}

TYPED_TEST(MaterialLaws, PacksGiveWhatDoublesGive) {
  using Real = Pack<native_width>;
  const Mat<3> F = this->template deformation<3>(0.3);
  Mat<3, Real> lanes;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) lanes(a, b) = Real(F(a, b));
  for (const TypeParam& law : this->laws()) {
    const Mat<3> P = law.first_piola(F);
    const Mat<3, Real> Q = law.first_piola(lanes);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        EXPECT_NEAR(Q(a, b)[native_width - 1], P(a, b), 1e-14 * (P.norm() + 17e6) * 10);
  }
}

}  // namespace
}  // namespace plumb::material_laws_test
