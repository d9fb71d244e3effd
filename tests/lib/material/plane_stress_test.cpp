// Plane stress: F_33 from P_33 = 0, for every elastic law of the catalogue.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "lib/material/laws.hpp"
#include "lib/material/tangent.hpp"

namespace plumb {
namespace {

const Elastic rubber{17e6, 0.45, 1100};

/// Calls check(law in 3D, law under plane stress).
template <class Check>
void for_elastic_laws(Check&& check) {
  for_each_type(ElasticLaws{}, [&]<class M>(Type<M>) {
    const M law(rubber);
    check(law, PlaneStress<M>(law));
  });
}

const double samples[][4] = {
    {1.2, 0.1, -0.05, 0.95}, {0.8, 0.3, 0.0, 1.1}, {1, 0, 0, 1}, {1.02, -0.4, 0.4, 1.05}};

Mat<2> sample(const double (&f)[4]) {
  return (Mat<2>() << f[0], f[1], f[2], f[3]).finished();
}

TEST(PlaneStress, TheThirdNormalStressIsZeroToRoundOff) {
  for_elastic_laws([](const auto& law, const auto& flat) {
    for (const auto& f : samples) {
      const Mat<2> F = sample(f);
      const double t = flat.thickness(F);
      const Mat<3> P = law.first_piola(flat.with_thickness(F, t));
      // F_33 is found to two units in its last place, 4e-16, each of which is 64 MPa = lambda + 2 mu in P_33;
      // the sums that make P_33 round as much
      EXPECT_NEAR(P(2, 2), 0, 1e-15 * 64e6) << flat.name;
      EXPECT_LT((flat.first_piola(F) - P.topLeftCorner<2, 2>()).norm(), 1e-15 * (P.norm() + 64e6))
          << flat.name;
    }
  });
}

TEST(PlaneStress, StressIsTheDerivativeOfTheEnergy) {
  for_elastic_laws([](const auto&, const auto& flat) {
    for (const auto& f : samples) {
      const Mat<2> F = sample(f), P = flat.first_piola(F);
      for (int n = 0; n < 4; ++n) {
        Mat<2, std::complex<double>> Fc = F.template cast<std::complex<double>>();
        Fc(n / 2, n % 2) += std::complex<double>(0, 1e-100);
        EXPECT_NEAR(P(n / 2, n % 2), flat.energy(Fc).imag() / 1e-100, 1e-14 * (P.norm() + 64e6)) << flat.name;
      }
    }
  });
}

TEST(PlaneStress,
     TheTangentIsTheCondensedOne) {  // A - a (x) b / A_3333, from the tangent in
                                     // three dimensions
  for_elastic_laws([](const auto& law, const auto& flat) {
    for (const auto& f : samples) {
      const Mat<2> F = sample(f);
      const Mat<4> found = tangent_of<2>(flat, F);
      const Mat<9> A = tangent_of<3>(law, flat.with_thickness(F, flat.thickness(F)));
      for (int m = 0; m < 4; ++m)
        for (int n = 0; n < 4; ++n) {
          const int M = 3 * (m / 2) + m % 2, N = 3 * (n / 2) + n % 2;
          EXPECT_NEAR(found(m, n), A(M, N) - A(M, 8) * A(8, N) / A(8, 8), 1e-14 * A.norm()) << flat.name;
        }
    }
  });
}

TEST(PlaneStress, PacksGiveWhatDoublesGive) {
  using Real = Pack<native_width>;
  for_elastic_laws([](const auto&, const auto& flat) {
    Mat<2, Real> lanes;
    for (int n = 0; n < 4; ++n) {
      double values[native_width];
      for (int lane = 0; lane < native_width; ++lane) values[lane] = samples[lane % 4][n];
      lanes(n / 2, n % 2) = Real::load(values);
    }
    const Mat<2, Real> P = flat.first_piola(lanes);
    for (int lane = 0; lane < native_width; ++lane) {
      const Mat<2> expected = flat.first_piola(sample(samples[lane % 4]));
      for (int n = 0; n < 4; ++n)
        EXPECT_NEAR(P(n / 2, n % 2)[lane], expected(n / 2, n % 2), 1e-14 * (expected.norm() + 64e6))
            << flat.name;
    }
  });
}

TEST(PlaneStress, SmallStrainsSeeTheConstantsOfPlaneStress) {
  const double E = rubber.young, nu = rubber.poisson;
  const Elastic flat = in_dimension(2, rubber, Plane::stress);
  EXPECT_NEAR(flat.shear_modulus(), rubber.shear_modulus(), 1e-15 * E);
  EXPECT_NEAR(flat.lame(), E * nu / (1 - nu * nu),
              1e-14 * E);  // the plate's own formula
  EXPECT_NEAR(flat.wave_speed(), std::sqrt(E / (rubber.density * (1 - nu * nu))), 1e-12);
  for_elastic_laws([&](const auto&, const auto& law) {
    const Mat<4> A = tangent_of<2>(law, Mat<2>(Mat<2>::Identity()));
    EXPECT_NEAR(A(0, 0), E / (1 - nu * nu), 1e-13 * E) << law.name;
    EXPECT_NEAR(A(0, 3), nu * E / (1 - nu * nu), 1e-13 * E) << law.name;
    EXPECT_NEAR(A(1, 2), E / (2 * (1 + nu)), 1e-13 * E) << law.name;
  });
}

TEST(PlaneStress, WhereThereIsNoThicknessTheResultIsNotANumber) {
  const PlaneStress<SaintVenantKirchhoff> kirchhoff{SaintVenantKirchhoff(rubber)};
  EXPECT_TRUE(std::isnan(kirchhoff.thickness(Mat<2>(1.5 * Mat<2>::Identity()))));  // F_33^2 would be negative
  const PlaneStress<NeoHookean> inverted{NeoHookean(rubber)};
  EXPECT_TRUE(std::isnan(inverted.thickness(sample({-1, 0, 0, 1}))));
}

TEST(PlaneStress,
     NeoHookeanSheetPulledFarThins) {  // kappa/mu = 1e4: F_33 -> 1/(F_11 F_22)
  const PlaneStress<NeoHookean> sheet{NeoHookean({17e6, 0.49995, 1100})};
  for (const double stretch : {0.5, 3.0, 20.0})  // J - 1 is of the size of mu/kappa times the largest
                                                 // stretch squared
    EXPECT_NEAR(sheet.thickness(Mat<2>(stretch * Mat<2>::Identity())) * stretch * stretch, 1,
                2e-4 * std::pow(std::max(stretch, 1 / (stretch * stretch)), 2));
}

}  // namespace
}  // namespace plumb
