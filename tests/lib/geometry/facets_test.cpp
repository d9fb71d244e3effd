// Facets of a body's surface: they cover it, and both ways to find them agree on lattices.
#include "lib/geometry/facets.hpp"

#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"

namespace plumb {
namespace {

template <int d>
void facets_cover_the_box() {
  for (const auto& [name, cloud] : test::all_clouds<d>()) {
    Vec<d> lower = Vec<d>::Zero(), upper = Vec<d>::Zero();
    double volume = 0;
    for (const Facet<d>& facet : box_facets(cloud)) {
      lower += facet.area.cwiseMin(0);
      upper += facet.area.cwiseMax(0);
      volume += (facet.centroid - cloud.box.origin).dot(facet.area) / d;  // divergence theorem
    }
    for (int k = 0; k < d; ++k) {
      const double area = cloud.box.size.prod() / cloud.box.size[k];
      EXPECT_NEAR(upper[k], area, 1e-11 * area) << name;  // voro++'s own tolerance is 1e-11
      EXPECT_NEAR(lower[k], -area, 1e-11 * area) << name;
    }
    EXPECT_NEAR(volume, cloud.box.size.prod(), 1e-11 * cloud.box.size.prod()) << name;
  }
}

TEST(Facets, CoverTheBox) {
  facets_cover_the_box<1>();
  facets_cover_the_box<2>();
  facets_cover_the_box<3>();
}

TEST(Facets, OfLatticesAreTheVoronoiOnes) {
  for (const Layout layout : {Layout::cell, Layout::node}) {
    const Cloud<3> cloud = test::small_lattice<3>(layout);
    std::vector<Vec<3>> exact(cloud.size(), Vec<3>::Zero()), found = exact;
    for (const auto& f : lattice_facets(cloud)) exact[f.owner] += f.area;
    for (const auto& f : voronoi_facets<3>(cloud.X, cloud.box)) found[f.owner] += f.area;
    for (Index i = 0; i < cloud.size(); ++i) EXPECT_LT((exact[i] - found[i]).norm(), 1e-11) << i;
  }
}

}  // namespace
}  // namespace plumb
