#include "mms/norms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb::mms {
namespace {

// u = (X + 2Y, 3X - Y) on [0, 2] x [0, 1]: integrals by hand.
PointValue<2> linear(const Vec<2>& X) {
  PointValue<2> value;
  value.gradient << 1, 2, 3, -1;
  value.u = value.gradient * X;
  value.v = {X[1], 2 * X[0]};
  value.stress << 3 * X[0], 1, -1, X[1];
  return value;
}

Cloud<2> plate(Layout layout) {
  return lattice<2>({{0, 0}, {2, 1}}, {20, 10}, layout);
}

NodalValues<2> sampled(const Cloud<2>& cloud) {
  NodalValues<2> values;
  for (const Vec<2>& X : cloud.X) values.push_back(linear(X));
  return values;
}

const ExactField<2> nothing = [](const Vec<2>&) { return PointValue<2>{}; };

// int (X+2Y)^2 + (3X-Y)^2 = int 10 X^2 - 2 XY + 5 Y^2 = 10 * 8/3 - 2 * 2 * 1/2 + 5 * 2/3 = 28; int |H|^2 = 15
// * 2. W1 interpolates linear fields exactly and Gauss points integrate squares exactly: round-off is left.
TEST(GaussNorms, OfALinearFieldAreItsIntegrals) {
  const Cloud<2> cloud = plate(Layout::node);
  const Interpolation<2> how{kernel_named<2>("cubic"), 0.09, Correction::W1};
  const ErrorNorms norms = gauss_norms<2>(cloud, sampled(cloud), nothing, how);
  EXPECT_NEAR(norms.l2, std::sqrt(28.0), 1e-12);
  EXPECT_NEAR(norms.h1, std::sqrt(30.0), 1e-11);
  // int Y^2 + 4 X^2 = 2/3 + 32/3; int 9 X^2 + 2 + Y^2 = 24 + 4 + 2/3
  EXPECT_NEAR(norms.velocity_l2, std::sqrt(34.0 / 3), 1e-12);
  EXPECT_NEAR(norms.stress_l2, std::sqrt(28 + 2.0 / 3), 1e-12);
  const ErrorNorms size = gauss_size<2>(cloud.box, linear);
  for (const NormName& norm : norm_names)
    EXPECT_NEAR(size.*norm.value / norms.*norm.value, 1, 1e-12) << norm.name;
  const ErrorNorms error = gauss_norms<2>(cloud, sampled(cloud), linear, how);
  EXPECT_LT(error.velocity_l2, 1e-13);
  EXPECT_LT(error.stress_l2, 1e-12);
  EXPECT_LT(error.l2, 1e-13);
  EXPECT_LT(error.h1, 1e-12);
  EXPECT_LT(error.linf, 1e-13);
}

// W0 interpolates constants only, but its corrected gradient is exact for linear fields.
TEST(GaussNorms, UseTheSchemesOwnPair) {
  const Cloud<2> cloud = plate(Layout::node);
  const Interpolation<2> how{kernel_named<2>("cubic"), 0.09, Correction::W0};
  const ErrorNorms error = gauss_norms<2>(cloud, sampled(cloud), linear, how);
  EXPECT_GT(error.l2, 1e-3);
  EXPECT_LT(error.h1, 1e-11);
}

// beta = 0.6, cell layout: the Gauss point nearest to the corner sees one particle.
TEST(GaussNorms, AreRefusedWhereInterpolationIsSingular) {
  const Cloud<2> cloud = plate(Layout::cell);
  const Interpolation<2> how{kernel_named<2>("cubic"), 0.06, Correction::W1};
  try {
    gauss_norms<2>(cloud, sampled(cloud), linear, how);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("node"), std::string::npos) << error.what();
  }
}

// Half volumes at edges make the sum a trapezoidal rule: int X^2 over [0, 2] at 20 cells has the error (2/12)
// d^2 * 2 * 1.
TEST(NodalNorms, SumWithVolumes) {
  const Cloud<2> cloud = plate(Layout::node);
  const ErrorNorms norms = nodal_norms<2>(cloud, sampled(cloud), nothing);
  const double d = 0.1, trapezoidal = 10 * (8.0 / 3 + d * d / 3) - 2 + 5 * 2 * (1.0 / 3 + d * d / 6);
  EXPECT_NEAR(norms.l2, std::sqrt(trapezoidal), 1e-12);
  EXPECT_NEAR(norms.h1, std::sqrt(30.0), 1e-12);
  EXPECT_NEAR(norms.linf, std::hypot(4.0, 5.0), 1e-14);  // at (2, 1)
  EXPECT_NEAR(norms.velocity_l2, std::sqrt(2 * (1.0 / 3 + d * d / 6) + 4 * (8.0 / 3 + d * d / 3)), 1e-12);
  EXPECT_NEAR(norms.stress_l2, std::sqrt(9 * (8.0 / 3 + d * d / 3) + 4 + 2 * (1.0 / 3 + d * d / 6)), 1e-12);
  const ErrorNorms size = nodal_size<2>(cloud, linear);
  for (const NormName& norm : norm_names)
    EXPECT_NEAR(size.*norm.value, norms.*norm.value, 1e-12) << norm.name;
}

// A field that is wrong by a known share in each quantity: the absolute norm is that share of the size.
TEST(NodalNorms, OfEachQuantityAreItsOwn) {
  const Cloud<2> cloud = plate(Layout::node);
  NodalValues<2> values = sampled(cloud);
  for (PointValue<2>& value : values)
    value.u *= 1.1, value.gradient *= 1.2, value.v *= 1.3, value.stress *= 1.4;
  const ErrorNorms error = nodal_norms<2>(cloud, values, linear), size = nodal_size<2>(cloud, linear);
  EXPECT_NEAR(error.l2 / size.l2, 0.1, 1e-12);
  EXPECT_NEAR(error.linf / size.linf, 0.1, 1e-12);
  EXPECT_NEAR(error.h1 / size.h1, 0.2, 1e-12);
  EXPECT_NEAR(error.velocity_l2 / size.velocity_l2, 0.3, 1e-12);
  EXPECT_NEAR(error.stress_l2 / size.stress_l2, 0.4, 1e-12);
}

TEST(NodalNorms, ABrokenFieldIsNotANumber) {
  const Cloud<2> cloud = plate(Layout::node);
  NodalValues<2> values = sampled(cloud);
  values[7].u[0] = std::nan("");
  EXPECT_TRUE(std::isnan(nodal_norms<2>(cloud, values, nothing).l2));
  EXPECT_TRUE(std::isnan(nodal_norms<2>(cloud, values, nothing).linf));
}

/// 1e-11 of the modulus is rounding; a thousandth of a stress, a sign or a number that is not finite is another law.
TEST(SameLaw, RefusesAnotherStress) {
  const NodalValues<2> right = sampled(plate(Layout::node));
  const double modulus = 5;
  NodalValues<2> body = right;
  for (auto& value : body) value.stress *= 1 + 1e-14;
  EXPECT_NO_THROW(require_same_law<2>(body, right, modulus));
  for (const double wrong : {0.999, -1.0, std::nan("")}) {
    body = right;
    body.back().stress *= wrong;
    EXPECT_THROW(require_same_law<2>(body, right, modulus), std::logic_error) << wrong;
  }
}

}  // namespace
}  // namespace plumb::mms
