// What every material of the catalogue must obey, in 1D to 3D.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <complex>
#include <random>

#include "plumbline/core/pack.hpp"
#include "plumbline/material/catalogue.hpp"

namespace plumb {
namespace {

template <class>
struct Tests;
template <class... Ms>
struct Tests<TypeList<Ms...>> {
  using Types = ::testing::Types<Ms...>;
};

template <class M>
class MaterialLaws : public ::testing::Test {
 protected:
  const Elastic elastic{17e6, 0.45, 1100};
  const M material{elastic};
  std::mt19937_64 random{5};

  double next() { return 2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1; }
  template <int d>
  Mat<d> deformation(double size) {
    Mat<d> F = Mat<d>::Identity();
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) F(a, b) += size * next();
    return F;
  }
  template <class F>
  void in_every_dimension(F&& check) {
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
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
TYPED_TEST_SUITE(MaterialLaws, typename Tests<MaterialCatalogue>::Types, Name);

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

TYPED_TEST(MaterialLaws, ObjectivityAndSymmetryOfTheKirchhoffStress) {
  for (int n = 0; n < 20; ++n) {
    const Mat<3> F = this->template deformation<3>(0.4);
    const Mat<3> Q = Eigen::Quaterniond(this->next(), this->next(), this->next(), this->next())
                         .normalized()
                         .toRotationMatrix();
    const Mat<3> P = this->material.first_piola(F);
    EXPECT_LT((this->material.first_piola(Mat<3>(Q * F)) - Q * P).norm(), 1e-13 * (P.norm() + 17e6) * 10);
    const Mat<3> tau = P * F.transpose();
    EXPECT_LT((tau - tau.transpose()).norm(), 1e-13 * (tau.norm() + 17e6));
  }
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
  for (int n = 0; n < 10; ++n) {
    const Mat<2> F = this->template deformation<2>(0.3);
    Mat<3> G = Mat<3>::Identity();
    G.topLeftCorner<2, 2>() = F;
    EXPECT_NEAR(this->material.energy(F), this->material.energy(G), 1e-14 * 17e6 * 10);
    const Mat<3> P = this->material.first_piola(G);
    EXPECT_LT((this->material.first_piola(F) - P.topLeftCorner<2, 2>()).norm(),
              1e-14 * (P.norm() + 17e6) * 10);
  }
}

TYPED_TEST(MaterialLaws, PacksGiveWhatDoublesGive) {
  using Real = Pack<native_width>;
  const Mat<3> F = this->template deformation<3>(0.3);
  Mat<3, Real> lanes;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) lanes(a, b) = Real(F(a, b));
  const Mat<3> P = this->material.first_piola(F);
  const Mat<3, Real> Q = this->material.first_piola(lanes);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(Q(a, b)[native_width - 1], P(a, b), 1e-14 * (P.norm() + 17e6) * 10);
}

}  // namespace
}  // namespace plumb
