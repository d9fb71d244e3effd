// Lattices and jittered clouds: places, volumes, repeatability, refusals.
#include <gtest/gtest.h>

#include <numeric>

#include "lib/core/error.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

template <class Case>
class Clouds : public ::testing::Test {};
TYPED_TEST_SUITE(Clouds, test::AllDimensions<TypeList<test::Plain>>, test::Names);

template <int d>
double total_volume(const Cloud<d>& cloud) {
  return std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0);
}

TYPED_TEST(Clouds, VolumesFillTheBox) {
  constexpr int d = TypeParam::d;
  for (const auto& [name, cloud] : test::all_clouds<d>()) {
    const double box = cloud.box.size.prod();
    EXPECT_NEAR(total_volume(cloud), box, 1e-12 * box) << name;  // voro++ adds some hundred cells in double
    for (const double V : cloud.V) EXPECT_GT(V, 0) << name;
    for (const auto& X : cloud.X) {
      EXPECT_TRUE(((X - cloud.box.origin).array() >= 0).all()) << name;
      EXPECT_TRUE(((cloud.box.origin + cloud.box.size - X).array() >= 0).all()) << name;
    }
  }
}

TYPED_TEST(Clouds, CellLatticeHasItsParticlesInTheMiddleOfCells) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::small_lattice<d>(Layout::cell);
  EXPECT_EQ(cloud.size(), d == 1 ? 8 : d == 2 ? 48 : 240);
  EXPECT_NEAR((cloud.X.front() - cloud.box.origin - Vec<d>::Constant(0.1)).norm(), 0, 1e-15);
  for (const double V : cloud.V) EXPECT_NEAR(V, std::pow(0.2, d), 1e-15);
}

TYPED_TEST(Clouds, NodeLatticeHasTributaryVolumes) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::small_lattice<d>(Layout::node);
  EXPECT_EQ(cloud.size(), d == 1 ? 9 : d == 2 ? 63 : 378);
  for (Index i = 0; i < cloud.size(); ++i) {
    int faces = 0;  // half on faces, quarter on edges, eighth at corners
    for (int k = 0; k < d; ++k) {
      const double lower = cloud.X[i][k] - cloud.box.origin[k];
      if (lower == 0 || cloud.X[i][k] == cloud.box.origin[k] + cloud.box.size[k]) ++faces;
    }
    EXPECT_NEAR(cloud.V[i], std::pow(0.2, d) / (1 << faces), 1e-15) << i;
  }
}

TYPED_TEST(Clouds, LinesRunAlongTheLongestAxis) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::small_lattice<d>(Layout::cell);
  ASSERT_EQ(cloud.line, 8);
  for (Index i = 1; i < 8; ++i)
    EXPECT_NEAR((cloud.X[i] - cloud.X[i - 1] - 0.2 * Vec<d>::Unit(0)).norm(), 0, 1e-14);
}

TYPED_TEST(Clouds, JitterIsTheSameForTheSameSeedAndStaysWithinItsFraction) {
  constexpr int d = TypeParam::d;
  const Cloud<d> regular = test::small_lattice<d>(Layout::node);
  const Cloud<d> a = jittered<d>(regular, 0.2, 9, Layout::node),
                 b = jittered<d>(regular, 0.2, 9, Layout::node);
  const Cloud<d> other = jittered<d>(regular, 0.2, 10, Layout::node);
  double most = 0, difference = 0;
  for (Index i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.X[i], b.X[i]);
    EXPECT_EQ(a.V[i], b.V[i]);
    const Vec<d> shift = a.X[i] - regular.X[i];
    most = std::max(most, shift.cwiseAbs().maxCoeff());
    difference = std::max(difference, (a.X[i] - other.X[i]).norm());
    const Vec<d> lower = regular.X[i] - regular.box.origin, upper = lower - regular.box.size;
    if ((lower.array() == 0).any() || (upper.cwiseAbs().array() < 1e-14).any()) {
      EXPECT_EQ(shift.norm(), 0) << "a particle on a face has moved";
    }
  }
  EXPECT_LE(most, 0.2 * regular.spacing);
  EXPECT_GT(most, 0.1 * regular.spacing);  // and it does move
  EXPECT_GT(difference, 0);
  EXPECT_EQ(a.line, 0);  // no equal neighbourhoods any more
}

TYPED_TEST(Clouds, VoronoiVolumesOfALatticeAreItsTributaryVolumes) {
  constexpr int d = TypeParam::d;
  for (const Layout layout : {Layout::cell, Layout::node}) {
    const Cloud<d> cloud = test::small_lattice<d>(layout);
    const auto V = voronoi_volumes<d>(cloud.X, cloud.box);
    for (Index i = 0; i < cloud.size(); ++i)
      EXPECT_NEAR(V[i], cloud.V[i], 1e-11 * std::pow(0.2, d)) << i;  // points on faces are shifted by 1e-13
  }
}

// Three points in a unit square: areas worked out by hand. Bisectors x = 0.5 below, and the two slanted ones
// meet it at (0.5, 0.5) by symmetry: the upper cell is the part above both bisectors of
// (0.25,0.25)-(0.5,0.75) and its mirror image.
TEST(VoronoiVolumes, OfThreePointsInASquare) {
  const std::vector<Vec<2>> X = {{0.25, 0.25}, {0.75, 0.25}, {0.5, 0.75}};
  const auto V = voronoi_volumes<2>(X, {Vec<2>::Zero(), Vec<2>::Ones()});
  // bisector of points 1 and 3: (x - 0.375)/4 + (y - 0.5)/2 = 0, so y = 0.6875 - x/2; at x = 0.5 y = 0.4375
  const double lower_left = 0.5 * (0.6875 + 0.4375) / 2;
  EXPECT_NEAR(V[0], lower_left, 1e-12);
  EXPECT_NEAR(V[1], lower_left, 1e-12);
  EXPECT_NEAR(V[2], 1 - 2 * lower_left, 1e-12);
}

TEST(CellsOf, RefusesASpacingThatDoesNotDivideTheSizeAndNamesOneThatDoes) {
  const Box<2> box{Vec<2>::Zero(), {1, 0.6}};
  EXPECT_EQ(cells_of<2>(box, 0.2), (std::array<Index, 2>{5, 3}));
  try {
    cells_of<2>(box, 0.25);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("axis y"), std::string::npos) << error.what();
    EXPECT_NE(error.suggestion().find("0.3 m"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace plumb
