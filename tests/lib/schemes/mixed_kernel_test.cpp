// The kernel sums of paper 003 against values that a second program found, and the algebra of its tensors.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "lib/core/error.hpp"
#include "lib/schemes/tensors.hpp"
#include "lib/schemes/tlsph/bonds/each_bond.hpp"
#include "tests/support/mixed.hpp"

namespace plumb::testing {
namespace {

constexpr double digits = 2e-14;  // some units in the last place of numbers below 1, after a 3 x 3 inverse

struct SeenBond {
  Vec<3> g = Vec<3>::Zero();
  double weight = 0;
};

/// What the particle at X sees of the one at X + r.
SeenBond seen(const Cloud<3>& cloud, const MixedBonds<3>& bonds, const Vec<3>& X, const Vec<3>& r) {
  SeenBond found;
  const BondTable<3>& t = bonds.table;
  for (Index p = 0; p < cloud.size(); ++p) {
    if ((cloud.X[p] - X).norm() > 1e-9) continue;
    for_each_bond(t, t.slots.of(p), [&](const BondEntry<3>& bond, const Vec<3>& separation) {
      if ((separation - r).norm() < 1e-9) found = {bond.vector(t.stencil), bond.value(bonds.smoothing)};
    });
  }
  return found;
}

double own_weight(const Cloud<3>& cloud, const MixedBonds<3>& bonds, const Vec<3>& X, double* h) {
  const BondTable<3>& t = bonds.table;
  for (Index p = 0; p < cloud.size(); ++p)
    if ((cloud.X[p] - X).norm() < 1e-9) {
      const Index i = t.slots.of(p);
      *h = 1 / bonds.inverse_h[0][i];
      return bonds.own_smoothing[t.row[i / t.width] * t.width + i % t.width];
    }
  return 0;
}

class KernelSumsOfPaper003 : public ::testing::Test {
 protected:
  KernelSumsOfPaper003() : cloud(nodes<3>(Vec<3>::Zero(), Vec<3>::Constant(4), {4, 4, 4})) {
    MixedOptions options;
    options.volumes = "tributary";
    options.smooth_positions = true;
    bonds = make_mixed_bonds<3>(cloud, options, 1);
  }
  Cloud<3> cloud;
  MixedBonds<3> bonds;
};

TEST_F(KernelSumsOfPaper003, AtACorner) {
  double h = 0;
  EXPECT_NEAR(own_weight(cloud, bonds, Vec<3>::Zero(), &h), 0.697843977011322, digits);
  EXPECT_NEAR(h, 1.03923048454133, digits);
  const SeenBond bond = seen(cloud, bonds, Vec<3>::Zero(), Vec<3>::UnitX());
  EXPECT_NEAR(bond.weight, 0.166955088198771, digits);
  EXPECT_NEAR(bond.g[0], 0.405987452972653, digits);
  EXPECT_NEAR(bond.g[1], -0.128473327082508, digits);
  EXPECT_NEAR(bond.g[2], -0.128473327082508, digits);
}

TEST_F(KernelSumsOfPaper003, InTheMiddle) {
  double h = 0;
  const Vec<3> middle = Vec<3>::Constant(2);
  EXPECT_NEAR(own_weight(cloud, bonds, middle, &h), 0.246109479432111, digits);
  EXPECT_NEAR(seen(cloud, bonds, middle, {1, 0, 0}).g[0], 0.143517850371166, digits);
  EXPECT_NEAR(seen(cloud, bonds, middle, {1, 1, 0}).g[0], 0.0625052301340590, digits);
  EXPECT_NEAR(seen(cloud, bonds, middle, {1, 1, 1}).g[0], 0.0266153072731494, digits);
}

// Both corrections, with h of the neighbour, on a cloud where h differs from particle to particle.
template <int d>
void reproduces_linear_fields(Cloud<d> cloud, const std::string& volumes) {
  MixedOptions options;
  options.volumes = volumes;
  options.smooth_positions = true;
  const MixedBonds<d> bonds = make_mixed_bonds<d>(cloud, options, 1);
  const BondTable<d>& t = bonds.table;
  for (Index p = 0; p < cloud.size(); ++p) {
    const Index i = t.slots.of(p);
    double sum = bonds.own_smoothing[t.row[i / t.width] * t.width + i % t.width];
    Vec<d> first = Vec<d>::Zero();
    for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>& X) {
      sum += bond.value(bonds.smoothing);
      first += bond.value(bonds.smoothing) * X;
    });
    EXPECT_NEAR(sum, 1, 1e-13);  // sums of at most 60 weights
    EXPECT_LT(first.norm(), 1e-13 * cloud.spacing);
    EXPECT_LT((estimated_identity(t, i) - Mat<d>::Identity()).norm(), 1e-13);
  }
}

TEST(MixedBonds, ReproduceLinearFieldsOnAnyCloud) {
  for (const char* volumes : {"equal", "tributary"}) {
    reproduces_linear_fields<1>(cube<1>(9), volumes);
    reproduces_linear_fields<2>(cube<2>(7), volumes);
    reproduces_linear_fields<3>(cube<3>(4), volumes);
    reproduces_linear_fields<2>(jittered<2>(cube<2>(7), 0.2, 3, Layout::node), volumes);
    reproduces_linear_fields<3>(jittered<3>(cube<3>(4), 0.2, 3, Layout::node), volumes);
  }
}

// The kernel is that of the neighbour: beside 1.8 stand 1 and 3, with h = .6 and .72.
TEST(MixedBonds, KernelsAreThoseOfTheNeighbour) {
  Cloud<1> chain = cube<1>(4);
  const double X[] = {0, 1, 1.8, 3, 4};
  for (Index p = 0; p < 5; ++p) chain.X[p][0] = X[p];
  chain.spacing = 1;
  chain.line = 0;
  const MixedBonds<1> bonds = make_mixed_bonds<1>(chain, MixedOptions(), 1);
  const double before = (1 - 0.8 / 1.2) / (0.6 * 0.6), after = (1 - 1.2 / 1.44) / (0.72 * 0.72);
  const double moment = 0.8 * before + 1.2 * after;
  int seen = 0;
  for_each_bond(bonds.table, 2, [&](const BondEntry<1>& bond, const Vec<1>& separation) {
    ++seen;
    EXPECT_NEAR(bond.vector(bonds.table.stencil)[0], (separation[0] < 0 ? -before : after) / moment, 1e-14);
  });
  EXPECT_EQ(seen, 2);
}

// |C^Skew| of a chain: g = 1/(2d) inside, so that V_a g_ab - V_b g_ba is 1 per area.
TEST(MixedBonds, ImpedanceOfAChain) {
  Cloud<1> chain = cube<1>(8);
  const MixedBonds<1> bonds = make_mixed_bonds<1>(chain, MixedOptions(), 1100);
  for_each_bond(bonds.table, bonds.table.slots.of(4), [&](const BondEntry<1>& bond, const Vec<1>&) {
    EXPECT_NEAR(bond.value(bonds.impedance), 0.5 * 1100 / chain.spacing, 1e-9);
  });
}

TEST(MixedBonds, ASingularNeighbourhoodIsRefusedWithItsParticle) {
  Cloud<2> line = nodes<2>(Vec<2>::Zero(), {4, 1}, {4, 1});
  for (Vec<2>& X : line.X) X[1] *= 5;  // two lines that do not see each other
  try {
    make_mixed_bonds<2>(line, MixedOptions(), 1);
    FAIL() << "made bonds of a line in the plane";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("particle 0"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("span 1 of 2"), std::string::npos) << error.what();
  }
}

TEST(TensorCross, ValuesOfAnExample) {
  Mat<3> A, B, C;
  A << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  B << 2, 0, 1, -1, 3, 2, 0, 1, 1;
  C << 13, 20, -25, 9, 14, -17, -10, -13, 15;
  EXPECT_EQ(tensor_cross<double>(A, B), C);
  EXPECT_EQ((0.5 * tensor_cross<double>(A, A)).eval(), (cofactor<3, double>(A)));
}

TEST(LeastStretch, IsTheLeastSingularValue) {
  Noise noise;
  const auto least = [](const Mat<3>& F) {
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Mat<3>>(F.transpose() * F).eigenvalues()[0]);
  };
  for (int n = 0; n < 200; ++n) {
    Mat<3> F = Mat<3>::Identity();
    for (int k = 0; k < 9; ++k) F(k / 3, k % 3) += 0.4 * noise();
    if (F.determinant() < 0.05) continue;
    EXPECT_NEAR((least_stretch<3, double>(F)), least(F), 1e-7);  // the series ends at 1e-9
    Mat<2> G = F.topLeftCorner<2, 2>();
    if (G.determinant() > 0.05) {
      EXPECT_NEAR((least_stretch<2, double>(G)), least(in_3d<2, double>(G, 1)), 1e-14);
    }
  }
  EXPECT_DOUBLE_EQ((least_stretch<3, double>(Mat<3>::Identity())), 1);
  EXPECT_NEAR((least_stretch<3, double>(Vec<3>(2, 2, 0.5).asDiagonal())), 0.5, 1e-7);
  EXPECT_NEAR((least_stretch<3, double>(Vec<3>(2, 0.5, 0.5).asDiagonal())), 0.5, 1e-7);
  EXPECT_EQ((least_stretch<1, double>(Mat<1>(2.0))), 1);  // the 3 x 3 tensor keeps the other two
}

}  // namespace
}  // namespace plumb::testing
