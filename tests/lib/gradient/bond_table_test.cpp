#include "plumbline/gradient/bond_table.hpp"

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
    EXPECT_LT(large.rows(), 200);
    EXPECT_GT(large.slots.packs(), 4000);
  }
}

}  // namespace
}  // namespace plumb::testing
