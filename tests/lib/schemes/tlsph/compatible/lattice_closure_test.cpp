// Compatible bonds of node lattices in closed form: interior weights, exact identities, every weight against
// matrices that are multiplied out, shared rows. THEORY (11.9)-(11.12), (11.15).
#include "lib/schemes/tlsph/compatible/lattice_closure.hpp"

#include <gtest/gtest.h>

#include "lib/material/models/neo_hookean.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/compatible.hpp"
#include "tests/support/typed.hpp"

namespace plumb::lattice_closure_test {
namespace {

template <int d>
Cloud<d> node_lattice(const std::array<Index, d>& cells, double spacing = 0.2) {
  Box<d> box;
  for (int k = 0; k < d; ++k) {
    box.origin[k] = -0.7 + 0.9 * k;
    box.size[k] = static_cast<double>(cells[k]) * spacing;
  }
  return lattice<d>(box, cells, Layout::node);
}

/// Bodies of unequal sides: with and without an inside.
template <int d>
std::vector<Cloud<d>> bodies() {
  if constexpr (d == 2)
    return {node_lattice<2>({7, 5}), node_lattice<2>({1, 6}), node_lattice<2>({2, 1})};
  else
    return {node_lattice<3>({5, 4, 6}), node_lattice<3>({1, 4, 2}), node_lattice<3>({1, 1, 1})};
}

template <int d>
BondOptions<d> closed_options(const Cloud<d>& cloud, const testing::Scheme& scheme = {}) {
  BondOptions<d> options = testing::options<d>(scheme, cloud.spacing);
  close_on_lattice<d>(options, cloud);
  return options;
}

/// Place of a particle along every axis.
template <int d>
std::array<Index, d> place_of(const Cloud<d>& cloud, Index i) {
  std::array<Index, d> place;
  for (int k = 0; k < d; ++k) place[k] = i / cloud.stride[k] % cloud.count[k];
  return place;
}

/// The outward area of the box nearest to a node [m^(d-1)].
template <int d>
Vec<d> share_of_surface(const Cloud<d>& cloud, Index i) {
  Vec<d> B = Vec<d>::Zero();
  const auto place = place_of(cloud, i);
  for (int k = 0; k < d; ++k) {
    B[k] = place[k] == 0 ? -1 : place[k] == cloud.count[k] - 1 ? 1 : 0;
    for (int m = 0; m < d; ++m)
      if (m != k) B[k] *= cloud.spacing * (place[m] == 0 || place[m] == cloud.count[m] - 1 ? 0.5 : 1);
  }
  return B;
}

template <class Case>
class LatticeClosureLaws : public ::testing::Test {};
using Kinds = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(LatticeClosureLaws, Kinds, test::Names);

struct InteriorWeights {
  const char* estimator;
  Correction pair;
  double beta, once, twice;
};

// Verified: an independent evaluation of kernel, correction and estimator, to the digits that are given.
TEST(LatticeClosure, HasTheInteriorWeightsOfItsStartTable) {
  const auto expect = [](auto dimension, const std::vector<InteriorWeights>& all) {
    constexpr int d = dimension;
    const Cloud<d> cloud = bodies<d>()[0];
    for (const auto& w : all) {
      const auto closure = lattice_closure<d>(
          cloud,
          testing::options<d>({.estimator = w.estimator, .pair = w.pair, .beta = w.beta}, cloud.spacing));
      for (int k = 0; k < d; ++k) {
        EXPECT_NEAR(closure.step[k], cloud.spacing, 1e-15);
        for (int m = 0; m < d; ++m)
          if (m != k) {
            EXPECT_NEAR(averaging(closure, k, m), w.once, 1e-12) << w.estimator << w.beta;
          }
        EXPECT_NEAR(closure.weight[k][0][1][1], w.twice, 1e-12) << w.estimator << w.beta;
      }
    }
  };
  expect(std::integral_constant<int, 2>{}, {{"standard", Correction::W1, 0.9, 0.123179562064, 0},
                                            {"standard", Correction::W0, 0.9, 0.123741474095, 0},
                                            {"improved", Correction::W1, 0.9, 0.107224742977, 0},
                                            {"improved", Correction::W0, 0.9, 0.107663442559, 0},
                                            {"standard", Correction::W1, 0.75, 0.015689725875, 0},
                                            {"standard", Correction::W0, 0.75, 0.019983361629, 0},
                                            {"standard", Correction::W1, 1.0, 0.163607888294, 0},
                                            {"standard", Correction::W0, 1.0, 0.163363448386, 0},
                                            {"standard", Correction::W1, 0.6, 0, 0}});
  expect(std::integral_constant<int, 3>{}, {{"standard", Correction::W1, 0.9, 0.102244164302, 0.002410289216},
                                            {"standard", Correction::W0, 0.9, 0.103180982930, 0.002487521344},
                                            {"improved", Correction::W1, 0.9, 0.091699918376, 0.001988916133},
                                            {"standard", Correction::W1, 0.6, 0, 0}});
}

// A bar: of the two layers that a support of 2.6 spacings sees, with the kernel (a + b r) W that reproduces linear fields. At a
// particle of a lattice a = 1/sum W, b = 0 and, since sum r^2 b' W - a sum r W' = 1 as well, b' = (1 + a sum r W')/sum r^2 W.
TEST(LatticeClosure, HasTheWeightsOfABar) {
  constexpr double beta = 1.3;
  Box<1> box;
  box.origin[0] = -0.7;
  box.size[0] = 1.6;
  const Cloud<1> cloud = lattice<1>(box, {8}, Layout::node);
  const auto closure =
      lattice_closure<1>(cloud, testing::options<1>({.estimator = "standard", .beta = beta}, cloud.spacing));
  const auto kernel = kernel_named<1>("cubic");
  const auto W = [&](double r) { return kernel.w(r / beta); };
  const auto slope = [&](double r) { return kernel.dw(r / beta) / beta; };
  const double a = 1 / (W(0) + 2 * W(1) + 2 * W(2));
  const double b = (1 + a * (2 * slope(1) + 4 * slope(2))) / (2 * W(1) + 8 * W(2));
  for (const int m : {1, 2})
    EXPECT_NEAR(closure.weight[0][static_cast<std::size_t>(m - 1)][0][0],
                2 * m * (b * m * W(m) - a * slope(m)), 1e-14);
  EXPECT_GT(closure.weight[0][1][0][0], 0.1);
}

// The same sums in another order: the stencil inside is that of the start table.
TYPED_TEST(LatticeClosureLaws, LeavesTheInsideAsItIs) {
  constexpr int d = TypeParam::d;
  for (const char* estimator : {"standard", "improved"})
    for (const double beta : {0.75, 0.9, 1.0, 1.2, 1.4}) {
      const Cloud<d> cloud = testing::block<d>(9, Layout::node, 0);
      const testing::Scheme scheme{.estimator = estimator, .beta = beta};
      const auto closed = testing::all_bonds<d>(cloud, closed_options<d>(cloud, scheme)),
                 start = testing::all_bonds<d>(cloud, testing::options<d>(scheme, cloud.spacing));
      Index inside = 0;
      for (Index i = 0; i < cloud.size(); ++i) {
        const auto place = place_of(cloud, i);
        bool near = false;                     // a neighbour of a face has a neighbour with another volume
        const Index whole = beta > 1 ? 3 : 2;  // layers from the face to a particle like those far inside
        for (int k = 0; k < d; ++k) near = near || place[k] < whole || place[k] >= cloud.count[k] - whole;
        if (near) continue;
        ++inside;
        for (std::size_t n = 0; n < closed[i].size(); ++n)
          EXPECT_LT((closed[i][n].stencil - start[i][n].stencil).norm() * cloud.spacing, 1e-13);
      }
      EXPECT_GT(inside, 0);
    }
}

// Affine maps are exact, and a uniform stress leaves the boundary's area and nothing else.
TYPED_TEST(LatticeClosureLaws, IsExactAndClosed) {
  constexpr int d = TypeParam::d;
  for (const auto& cloud : bodies<d>())
    for (const char* estimator : {"standard", "improved"})
      for (const double beta : {0.6, 0.75, 0.9, 1.0, 1.2, 1.49}) {
        SCOPED_TRACE(std::string(estimator) + ", beta " + std::to_string(beta));
        const testing::Scheme scheme{.estimator = estimator, .beta = beta};
        const auto bonds = testing::all_bonds<d>(cloud, closed_options<d>(cloud, scheme));
        std::vector<Vec<d>> closed(cloud.size(), Vec<d>::Zero());
        for (Index i = 0; i < cloud.size(); ++i) {
          Mat<d> exact = -Mat<d>::Identity();
          for (const auto& ij : bonds[i]) {
            exact += ij.separation * ij.stencil.transpose();
            closed[i] -= cloud.V[i] * ij.stencil;
            closed[ij.other] += cloud.V[i] * ij.stencil;
          }
          EXPECT_LT(exact.norm(), 1e-14) << i;  // some ten terms of order 1
        }
        const double area = std::pow(cloud.spacing, d - 1);
        for (Index i = 0; i < cloud.size(); ++i)
          EXPECT_LT((closed[i] - share_of_surface(cloud, i)).norm(), 1e-14 * area) << i;
      }
}

using Dense = Eigen::MatrixXd;

/// (11.9), (11.15) for n particles, as matrices: D_1, D_2 and N_0, N_1, N_2.
struct Line {
  std::array<Dense, closure_reach> difference;
  std::array<Dense, closure_reach + 1> neighbours;
};
Line line_of(Index n, double step) {
  Dense Q = Dense::Zero(n, n), H = Dense::Zero(n, n), second = Q, shift = Q;
  for (Index i = 0; i + 1 < n; ++i) {  // sum of the parts of all cells
    Q.block<2, 2>(i, i) += (Eigen::Matrix2d() << -0.5, 0.5, -0.5, 0.5).finished();
    H.block<2, 2>(i, i) += 0.5 * step * Eigen::Matrix2d::Identity();
    shift(i, i + 1) = 1;
  }
  for (Index i = 1; i + 1 < n; ++i) second.block<1, 3>(i, i - 1) << 1, -2, 1;
  Line line;
  line.difference[0] = H.inverse() * Q;
  line.difference[1] = H.inverse() * (Q + 0.25 * (shift - shift.transpose()) * second);
  line.neighbours[0] = Dense::Identity(n, n);
  for (Index p = 1; p <= closure_reach; ++p) {
    Dense pairs = Dense::Zero(n, n);
    for (Index i = 0; i + p < n; ++i) {
      pairs(i, i) -= 1;
      pairs(i + p, i + p) -= 1;
      pairs(i, i + p) = pairs(i + p, i) = 1;
    }
    line.neighbours[p] = 2 * Dense::Identity(n, n) + step * H.inverse() * pairs;
  }
  return line;
}

// Every weight against products of matrices that are put together cell by cell and pair by pair.
TYPED_TEST(LatticeClosureLaws, EqualsProductsOfDifferencesAndAverages) {
  constexpr int d = TypeParam::d;
  for (const auto& cloud : bodies<d>())
    for (const double beta : {0.9, 1.2, 1.4}) {
      const auto scheme = testing::Scheme{.estimator = "standard", .beta = beta};
      const auto closure = lattice_closure<d>(cloud, testing::options<d>(scheme, cloud.spacing));
      const auto bonds = testing::all_bonds<d>(cloud, closed_options<d>(cloud, scheme));
      std::vector<Line> lines;
      for (int k = 0; k < d; ++k) lines.push_back(line_of(cloud.count[k], cloud.spacing));
      double wrong = 0;
      for (Index i = 0; i < cloud.size(); ++i)
        for (const auto& ij : bonds[i]) {
          const auto at = place_of(cloud, i), to = place_of(cloud, ij.other);
          for (int k = 0; k < d; ++k) {
            const int a = (k + 1) % d, b = (k + 2) % d;
            double expected = 0;
            for (int m = 0; m < closure_reach; ++m)
              for (int p = 0; p <= closure_reach; ++p)
                for (int q = 0; q <= (d == 3 ? closure_reach : 0); ++q)
                  expected += closure.weight[k][m][p][q] * lines[k].difference[m](at[k], to[k]) *
                              lines[a].neighbours[p](at[a], to[a]) *
                              (d == 3 ? lines[b].neighbours[q](at[b], to[b]) : 1);
            wrong = std::max(wrong, std::abs(ij.stencil[k] - expected) * cloud.spacing);
          }
        }
      EXPECT_LT(wrong, 1e-14) << beta;
    }
}

// In motion: affine at finite strain, with the loops of lattices.
TYPED_TEST(LatticeClosureLaws, PassesThePatchTest) {
  constexpr int d = TypeParam::d;
  test::Numbers numbers(8);
  const Mat<d> A = Mat<d>::Identity() + 0.3 * numbers.matrix<d>();
  const Cloud<d> cloud = bodies<d>()[0];
  for (const double beta : {0.9, 1.2}) {
    Solid<d> solid =
        make_solid<d>(cloud, "neo-hookean", testing::rubber, closed_options<d>(cloud, {.beta = beta}));
    State<d> state = make_state(solid);
    for (Index i = 0; i < cloud.size(); ++i)
      set_vector<d>(state.u, solid.bonds.slots.of(i), (A - Mat<d>::Identity()) * cloud.X[i]);
    const auto f = testing::forces(solid, state);
    const Mat<d> P = NeoHookean(testing::rubber).first_piola(A);
    const double size = P.norm() * std::pow(cloud.spacing, d - 1);
    for (Index i = 0; i < cloud.size(); ++i) {
      EXPECT_LT((deformation_gradient_of(solid, state, i) - A).norm(), 1e-13);
      EXPECT_LT((cloud.V[i] * f[i] + P * share_of_surface(cloud, i)).norm() / size, 1e-12);
    }
  }
}

TYPED_TEST(LatticeClosureLaws, TheForceIsTheAdjointAndKeepsMomenta) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = bodies<d>()[0];
  Solid<d> solid = make_solid<d>(cloud, "neo-hookean", testing::rubber, closed_options<d>(cloud));
  State<d> state = make_state(solid), along = make_state(solid);
  testing::deform(solid, state, 0.15);
  const auto f = testing::forces(solid, state);
  test::Numbers numbers(11);
  double of_force = 0, of_stress = 0, size = 0;
  Vec<d> sum = Vec<d>::Zero();
  Mat<d> torque = Mat<d>::Zero();
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d> w = numbers.vector<d>(), x = position_of(solid, state, i), F = cloud.V[i] * f[i];
    set_vector<d>(along.u, solid.bonds.slots.of(i), w);
    of_force += F.dot(w);
    size += F.norm();
    sum += F;
    torque += x * F.transpose() - F * x.transpose();
  }
  const NeoHookean material(testing::rubber);
  for (Index i = 0; i < cloud.size(); ++i) {
    const Mat<d> P = material.first_piola(deformation_gradient_of(solid, state, i));
    const Mat<d> rate = deformation_gradient_of(solid, along, i) - Mat<d>::Identity();
    of_stress += cloud.V[i] * P.cwiseProduct(rate).sum();
  }
  EXPECT_NEAR(of_force, -of_stress, 1e-12 * size);
  EXPECT_GT(std::abs(of_stress), 1e-5 * size);
  EXPECT_LT(sum.norm(), 1e-13 * size);
  EXPECT_LT(torque.norm(), 1e-13 * size);
}

// Rows repeat as those of the start table do, so that a lattice of any size has some tens of them.
TYPED_TEST(LatticeClosureLaws, RowsRepeatAndTakeNoMoreThanTheStartTable) {
  constexpr int d = TypeParam::d;
  Cloud<d> closed = testing::block<d>(d == 2 ? 60 : 24, Layout::node, 0), start = closed;
  const auto table = make_bond_table<d>(closed, closed_options<d>(closed));
  const auto other = make_bond_table<d>(start, testing::options<d>({}, start.spacing));
  EXPECT_LE(table.rows(), other.rows());
  EXPECT_LE(table.bytes(), other.bytes());
  EXPECT_EQ(table.pairs, other.pairs);
  EXPECT_EQ(closed.V, start.V);
}

TEST(LatticeClosure, IsNotKnownForOtherClouds) {
  const Cloud<2> node = test::small_lattice<2>(Layout::node);
  const double d = node.spacing;
  EXPECT_EQ(reason_against_closure<2>(node, 1.8 * d), std::nullopt);
  EXPECT_EQ(reason_against_closure<2>(node, 3 * d), std::nullopt);
  EXPECT_NE(reason_against_closure<2>(node, 3.001 * d), std::nullopt);
  EXPECT_NE(reason_against_closure<2>(test::small_lattice<2>(Layout::cell), 1.8 * d), std::nullopt);
  EXPECT_NE(reason_against_closure<2>(jittered<2>(node, 0.1, 1, Layout::node), 1.8 * d), std::nullopt);
  Cloud<2> low = node, high = node;  // particles on one of two opposite faces only
  low.box.origin[0] -= 0.5 * d;
  low.box.size[0] += 0.5 * d;
  high.box.size[1] += 0.5 * d;
  EXPECT_NE(reason_against_closure<2>(low, 1.8 * d), std::nullopt);
  EXPECT_NE(reason_against_closure<2>(high, 1.8 * d), std::nullopt);
  Cloud<2> bitten = node;
  bitten.X.pop_back();
  EXPECT_NE(reason_against_closure<2>(bitten, 1.8 * d), std::nullopt);
  BondOptions<2> options = testing::options<2>({.estimator = "bond38"}, d);
  EXPECT_THROW(lattice_closure<2>(node, options), InputError);
}

}  // namespace
}  // namespace plumb::lattice_closure_test
