// The k-d tree against brute force, and what it must refuse.
#include "lib/geometry/neighbours.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

template <class Case>
class FoundNeighbours : public ::testing::Test {};
TYPED_TEST_SUITE(FoundNeighbours, test::AllDimensions<TypeList<test::Plain>>, test::Names);

TYPED_TEST(FoundNeighbours, AreThoseOfBruteForceInAscendingOrder) {
  constexpr int d = TypeParam::d;
  for (const auto& [name, cloud] : test::all_clouds<d>())
    // 2 and sqrt(2) spacings are lattice distances: there r = R must not count, whatever the rounding
    for (const double reach : {0.5, 1.8, std::sqrt(2.0), 2.0, 3.0, 100.0}) {
      const double R = reach * cloud.spacing;
      const Neighbours found = find_neighbours<d>(cloud, R);
      ASSERT_EQ(found.begin.size(), cloud.X.size() + 1);
      for (Index i = 0; i < cloud.size(); ++i) {
        std::vector<Index> expected;
        test::neighbours_of<d>(cloud, cloud.X[i], R, &expected);
        const auto row = found.of(i);
        ASSERT_EQ(std::vector<Index>(row.begin(), row.end()), expected)
            << name << ", R/d " << reach << ", " << i;
      }
    }
}

TYPED_TEST(FoundNeighbours, AreMutual) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::all_clouds<d>()[2].cloud;
  const Neighbours found = find_neighbours<d>(cloud, 1.8 * cloud.spacing);
  for (Index i = 0; i < cloud.size(); ++i)
    for (const auto j : found.of(i)) {
      const auto row = found.of(j);
      EXPECT_TRUE(std::find(row.begin(), row.end(), i) != row.end()) << i << ", " << j;
    }
}

TEST(FindNeighbours, RefusesCoincidentParticlesAndNamesBoth) {
  Cloud<2> cloud = test::small_lattice<2>(Layout::cell);
  cloud.line = 0;  // no lattice any more
  cloud.X[17] = cloud.X[5] + Vec<2>(1e-10, 0);
  try {
    find_neighbours<2>(cloud, 0.36);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(error.problem().find("5 and 17"), std::string::npos) << error.what();
  }
}

TEST(NeighbourSearch, AnyPointMayAsk) {
  const Cloud<2> cloud = test::small_lattice<2>(Layout::node);
  const NeighbourSearch<2> search(cloud.X);
  std::vector<Index> found = {99}, expected;
  const Vec<2> point = cloud.box.origin + Vec<2>(0.31, 0.47);
  search.within(point, 0.5, found);
  test::neighbours_of<2>(cloud, point, 0.5, &expected);
  EXPECT_EQ(found, expected);
  search.within(point + Vec<2>(50, 0), 0.5, found);
  EXPECT_TRUE(found.empty());
}

TEST(Neighbours, LatticesByCountingEqualTheSearch) {
  const Cloud<3> lattice = test::small_lattice<3>(Layout::node);
  Cloud<3> cloud = lattice;
  cloud.line = 0;  // forget that it is a lattice
  for (const double beta : {0.6, 0.9, 1.2, 1.5}) {
    const double R = 2 * beta * cloud.spacing;
    const Neighbours counted = find_neighbours<3>(lattice, R), searched = find_neighbours<3>(cloud, R);
    EXPECT_EQ(counted.begin, searched.begin) << beta;
    EXPECT_EQ(counted.list, searched.list) << beta;
  }
}

}  // namespace
}  // namespace plumb
