#include "lib/schemes/tlsph/bonds/bond_table.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

BondTable<3> table_of(Cloud<3> cloud, int threads) {
  omp_set_num_threads(threads);
  BondTable<3> table = make_bond_table<3>(cloud, options<3>({}, cloud.spacing));
  omp_set_num_threads(omp_get_num_procs());
  return table;
}

TEST(BondTable, IsTheSameForAnyNumberOfThreads) {
  for (const double jitter : {0.0, 0.2}) {
    const Cloud<3> cloud = block<3>(24, Layout::node, jitter);  // many more than a thread's least part
    const BondTable<3> one = table_of(cloud, 1);
    for (const int threads : {2, 3, 7}) {
      const BondTable<3> many = table_of(cloud, threads);
      EXPECT_EQ(one.row, many.row) << threads;
      EXPECT_EQ(one.begin, many.begin) << threads;
      EXPECT_EQ(one.offset, many.offset) << threads;
      EXPECT_EQ(one.stencil, many.stencil) << threads;
      EXPECT_EQ(one.force, many.force) << threads;
    }
  }
}

/// Interior, faces, edges, corners: their number does not grow with the body.
TEST(BondTable, OfALatticeHasAsManyRowsAsKindsOfPlaces) {
  for (const Layout layout : {Layout::cell, Layout::node}) {
    const Index small = table_of(block<3>(21, layout, 0), 1).rows();
    const BondTable<3> large = table_of(block<3>(37, layout, 0), 1);  // the last packs of lines are alike
    EXPECT_EQ(large.rows(), small);
    EXPECT_LE(large.rows(), 7 * 7 * 7);  // along each axis three layers at each end and the rest
    EXPECT_GT(large.slots.packs(), 4000);
  }
}

/// V_i c_ij = -V_j c_ji to round-off, but for the first bond, which is off by `wrong` of the largest one.
BondTable<2> skew_table(double wrong) {
  Cloud<2> cloud = block<2>(8, Layout::node, 0.2);
  BondOptions<2> o = options<2>({}, cloud.spacing);
  o.project = [wrong](Cloud<2>& c, const Neighbours&, std::vector<std::vector<BondConstants<2>>>& bonds) {
    double most = 0;
    for (Index i = 0; i < c.size(); ++i)
      for (auto& ij : bonds[i])
        for (auto& ji : bonds[ij.other]) {
          if (ji.other != i || ij.other < i) continue;
          const Vec<2> A = c.V[i] * ij.stencil - c.V[ij.other] * ji.stencil;
          ij.stencil = A / (2 * c.V[i]);
          ji.stencil = -A / (2 * c.V[ij.other]);
          most = std::max({most, ij.stencil.cwiseAbs().maxCoeff(), ji.stencil.cwiseAbs().maxCoeff()});
        }
    bonds[0][0].stencil[0] += wrong * most;
  };
  return make_bond_table<2>(cloud, o);
}

// F and the force may share their vectors only where they are the same numbers: a difference beyond rounding
// makes a force that is not the derivative of the energy.
TEST(BondTable, SharesVectorsWhereTheyAreTheSameAndNowhereElse) {
  EXPECT_TRUE(skew_table(0).force.empty());
  for (const double wrong : {1e-12, 1e-3, -1.0}) {
    const BondTable<2> table = skew_table(wrong);
    ASSERT_EQ(table.force.size(), table.stencil.size()) << wrong;
    EXPECT_EQ(&table.force_weights(), &table.force);
  }
}

}  // namespace
}  // namespace plumb::testing
