#include "mms/annulus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "lib/core/error.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb::mms {
namespace {

constexpr double area = 3.141592653589793 * (1.25 * 1.25 - 0.75 * 0.75);

double total(const Cloud<2>& cloud) {
  return std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0);
}

TEST(PolarCloud, FillsTheAnnulusExactlyAndReachesBothCircles) {
  const Cloud<2> cloud = polar_cloud(0.75, 1.25, 0.05);
  EXPECT_NEAR(total(cloud), area, 1e-13);
  double least = 9, most = 0;
  for (const Vec<2>& X : cloud.X) {
    least = std::min(least, X.norm());
    most = std::max(most, X.norm());
  }
  EXPECT_NEAR(least, 0.75, 1e-15);
  EXPECT_NEAR(most, 1.25, 1e-15);
  EXPECT_EQ(cloud.size(), 11 * 126);  // 2 pi / 0.05 = 125.66
}

// Voronoi cells clipped by the circles fill it, but for the sagittas of chords of d/8.
TEST(ClippedCloud, FillsTheAnnulus) {
  for (double d : {0.1, 0.05, 0.025}) {
    const Cloud<2> cloud = shaped_cloud<2>(annulus_shape(0.75, 1.25), {d, Layout::cell});
    // chord c on a circle of radius R: c^2/(12 R) per length, both circles, c up to sqrt(2) d/8 in 2D
    const double sagittas = 2 * 3.141592653589793 * (d / 8) * (d / 8) / 12 * 4;
    EXPECT_NEAR(total(cloud), area, sagittas);
  }
}

// A ring of curved shape passes the patch test with compatible bonds: no force inside under uniform stress.
TEST(PolarCloud, IsMadeCompatible) {
  const Cloud<2> cloud = polar_cloud(0.75, 1.25, 0.1);
  const Surface<2> surface = polar_surface(cloud, 0.75, 1.25);
  const double angle = 2 * 3.141592653589793 / 63;  // 63 particles around
  EXPECT_NEAR(surface.volume, 63 * std::sin(angle) / 2 * (1.25 * 1.25 - 0.75 * 0.75), 1e-13);
  EXPECT_LT(surface.centroid.norm(), 1e-13);
  Scene scene;
  scene.dimension = 2;
  scene.max_steps = 1;
  scene.material = {"neo-hookean", 17e6, 0.45, 1100};
  scene.method.gradient = "compatible";
  EXPECT_FALSE(make_tlsph<2>(scene, cloud).warnings.empty());  // its surface is not given: a guess
  auto simulation = make_tlsph<2>(scene, cloud, std::optional(surface));
  Solid<2>& solid = simulation.solid;
  Mat<2> G;
  G << 0.3, -0.1, 0.2, 0.1;
  for (Index i = 0; i < cloud.size(); ++i) set_vector<2>(simulation.state.u, i, G * cloud.X[i]);
  double worst = 0;
  Workspace<2> workspace;
  ASSERT_TRUE(evaluate(solid, workspace, simulation.state, 0, [&](const Block& block, BlockForce<2>& f) {
    for (Index i = block.begin(); i < block.end(); ++i)
      if (i >= 63 && i < cloud.size() - 63)
        worst =
            std::max(worst, std::hypot(f(0, i), f(1, i)) * cloud.spacing / std::abs(workspace.P.at(0, i)));
  }));
  EXPECT_LT(worst, 1e-10);  // the table is projected to 1e-12, and a hundred bonds add up
  for (Index i = 0; i < cloud.size(); ++i)
    EXPECT_LT((deformation_gradient_of(solid, simulation.state, i) - Mat<2>::Identity() - G).norm(), 1e-11);
}

TEST(Annulus, TooCoarseASpacingIsRefused) {
  EXPECT_THROW(polar_cloud(0.75, 1.25, 0.3), InputError);
  EXPECT_THROW(annulus_shape(0.75, 0.5), InputError);
}

}  // namespace
}  // namespace plumb::mms
