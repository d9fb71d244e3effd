// G as it is kept, place by place, against the sparse matrix that it stands for.
#include "lib/schemes/implicit/place_gradients.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/schemes/implicit/energy_operators.hpp"
#include "tests/lib/schemes/implicit_bodies.hpp"

namespace plumb {
namespace {

using Eigen::VectorXd;

VectorXd some_wave(Index size, double shift) {
  VectorXd v(size);
  for (Index n = 0; n < size; ++n) v[n] = std::sin(1.3 * static_cast<double>(n) + shift);
  return v;
}

Solid<2> beside_walls() {
  Cloud<2> cloud = testing::block<2>(5, Layout::mirror, 0);
  BondOptions<2> options = testing::options<2>({}, cloud.spacing);
  options.walls = {{0, false}, {1, true}};
  return make_solid<2>(std::move(cloud), "neo-hookean", testing::rubber, options);
}

template <int d>
void is_its_matrix(const Solid<d>& solid) {
  const EnergyOperators<d> operators = energy_operators(solid, solid.terms);
  const PlaceGradients<d>& G = operators.gradient;
  const LinearOperators matrices = linear_operators(solid);
  const VectorXd u = some_wave(d * solid.cloud.size(), 0.1), P = some_wave(d * d * solid.cloud.size(), 0.7);
  const double digits = 1e-13;  // sums of some tens of products
  ASSERT_EQ(G.places(), solid.cloud.size());
  EXPECT_LE((Eigen::SparseMatrix<double>(G.matrix() - matrices.gradient)).norm(),
            digits * matrices.gradient.norm());
  const VectorXd F = matrices.gradient * u, f = matrices.force * P;
  EXPECT_LE((G.times(u) - F).norm(), digits * F.norm());
  EXPECT_LE((G.forces(operators.weight, P) - f).norm(), digits * f.norm());
  const VectorXd F_size = matrices.gradient.cwiseAbs() * u.cwiseAbs(),
                 f_size = matrices.force.cwiseAbs() * P.cwiseAbs();
  EXPECT_LE((G.largest_gradients(u) - F_size).norm(), digits * F_size.norm());
  EXPECT_LE((G.largest_forces(operators.weight, P) - f_size).norm(), digits * f_size.norm());
  const std::vector<Index> some{1, 4, 5, d * solid.cloud.size() - 1};
  const Eigen::MatrixXd part = G.matrix(3, 7, some);
  ASSERT_EQ(part.rows(), 4 * d * d);
  for (std::size_t n = 0; n < some.size(); ++n)
    EXPECT_EQ((part.col(static_cast<Index>(n)) -
               VectorXd(matrices.gradient.col(some[n])).segment(3 * d * d, 4 * d * d))
                  .norm(),
              0);
  EXPECT_FALSE(G.number(0, solid.cloud.size() - 1));  // too far away
  const VectorXd stiff = per_component(matrices.terms, d) * u;
  EXPECT_LE((operators.forces(P, u) - f - stiff).norm(), digits * (f.norm() + stiff.norm()));
  EXPECT_LE((SparseMatrix(operators.terms() - matrices.terms)).norm(), digits * matrices.terms.norm());
  const VectorXd stiff_size = per_component(matrices.terms.cwiseAbs(), d) * u.cwiseAbs();
  EXPECT_LE((operators.largest_of_terms(u) - stiff_size).norm(), digits * stiff_size.norm());
}

TEST(PlaceGradients, AreTheMatrixOfTheBody) {
  for (const auto& table : testing::all_tables()) {
    is_its_matrix<2>(testing::elastic_body<2>(table, LawChoice("neo-hookean"), 1, 0.2));
    is_its_matrix<3>(testing::elastic_body<3>(table, LawChoice("neo-hookean"), 1, 0.2));
  }
  is_its_matrix<2>(beside_walls());
}

/// Neither twice nor once for each component: a vector and a number per pair, and half of the terms.
TEST(PlaceGradients, AreKeptOnce) {
  const Solid<3> solid = testing::elastic_body<3>({}, LawChoice("neo-hookean"), 1, 0.2);
  const EnergyOperators<3> operators = energy_operators(solid, solid.terms);
  EXPECT_EQ(operators.gradient.shares(), solid.bonds.pairs + solid.cloud.size());
  EXPECT_EQ(operators.half_of_terms.nonZeros(), (operators.terms().nonZeros() + solid.cloud.size()) / 2);
}

}  // namespace
}  // namespace plumb
