// Shapes, the Voronoi cells that they clip, and the clouds that fill them.
#include "lib/geometry/clipped_cells.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "lib/geometry/shaped_cloud.hpp"
#include "tests/support/clouds.hpp"

namespace plumb {
namespace {

using std::numbers::pi;

template <int d>
struct NamedShape {
  std::string name;
  Shape<d> shape;
  double volume;
  bool curved;
  int corners = 0;  ///< edges between flat pieces that are not on the box
};

std::vector<NamedShape<2>> plane_shapes() {
  const Shape<2> square{{Vec<2>(-1, -1), Vec<2>(2, 2)}, {}};
  const auto hole = shape_named<2>("ball", {{"centre", {0.1, -0.2}}, {"radius", {0.4}}});
  return {
      {"disc", shape_named<2>("ball", {{"radius", {1}}}), pi, true},
      {"annulus", shape_named<2>("annulus", {{"inner", {0.5}}, {"outer", {1}}}), 0.75 * pi, true},
      {"square with a round hole", without(square, hole), 4 - 0.16 * pi, true},
      {"square with a square hole",
       without(square, shape_named<2>("box", {{"origin", {-0.3, -0.5}}, {"size", {0.7, 0.8}}})), 4 - 0.56,
       false, 4},
      {"square cut by a line",
       without(square, shape_named<2>("half-space", {{"point", {0.5, 0}}, {"normal", {2, 0}}})), 3, false},
      // an L: one corner turns inwards
      {"polygon",
       shape_named<2>("polygon", {{"corners", {0, 0, 1.7, 0, 1.7, 0.7, 0.6, 0.7, 0.6, 1.5, 0, 1.5}}}),
       1.7 * 0.7 + 0.6 * 0.8, false, 6}};
}

std::vector<NamedShape<3>> solid_shapes() {
  const Shape<3> cube{{Vec<3>(-1, -1, -1), Vec<3>(2, 2, 2)}, {}};
  return {{"ball", shape_named<3>("ball", {{"radius", {1}}}), 4 * pi / 3, true},
          {"cylinder", shape_named<3>("cylinder", {{"radius", {0.8}}, {"length", {2}}}), 2 * 0.64 * pi, true},
          {"cube with a round hole", without(cube, shape_named<3>("ball", {{"radius", {0.7}}})),
           8 - 4 * pi / 3 * 0.343, true},
          {"cube cut by a plane",
           without(cube, shape_named<3>("half-space", {{"point", {1, 0, 0.5}}, {"normal", {0, 0, 1}}})), 6,
           false}};
}

/// The clipped cells fill the shape, and their facets enclose just that volume.
template <int d>
void cells_fill(const NamedShape<d>& named, double spacing) {
  for (const Layout layout : {Layout::cell, Layout::node})
    for (const bool blue : {false, true}) {
      SCOPED_TRACE(named.name + (layout == Layout::cell ? ", cell" : ", node") + (blue ? ", blue" : ""));
      const Cloud<d> cloud = shaped_cloud<d>(named.shape, {spacing, layout, blue, blue ? 0.0 : 0.2, 3});
      const auto cells = clipped_cells<d>(cloud.X, named.shape);
      const double volume = std::accumulate(cells.volume.begin(), cells.volume.end(), 0.0);
      // Chords of a quarter of the spacing (the mean one, of the box around, is up to 1.6 times larger) have
      // sagittas of c^2/(8 R) <= 0.01 spacings^2; surface over volume is at most 6. Corners that the cuts
      // chop off are smaller than such a chord.
      EXPECT_NEAR(volume / named.volume, 1, (named.curved ? 0.06 : 0.02) * spacing * spacing);
      Vec<d> sum = Vec<d>::Zero();
      double enclosed = 0;
      for (const auto& facet : cells.facets) {
        sum += facet.area;
        enclosed += facet.centroid.dot(facet.area) / d;
      }
      // 2D: neighbouring cells meet in the same points of the surface, found to 1e-10 spacings. 3D: their
      // triangles leave cracks as deep as the sagittas.
      EXPECT_LT(sum.norm() / volume, d == 2 ? 1e-9 : 2e-3 * spacing * spacing);
      // Pieces of an arc as long as a spacing make one facet, whose centroid is off by spacing^2/(24 R). A
      // corner is cut off by a chord of up to 0.2 spacings, which may join a piece of up to one spacing: its
      // centroid, half a spacing from that of the piece, is then off that plane's by sin 45 of it, in one of
      // d terms.
      const double corner = 0.2 * 0.5 * 0.71 / d;
      EXPECT_NEAR(
          enclosed / volume, 1,
          named.curved ? spacing * spacing / 3 : 1e-9 + named.corners * corner * spacing * spacing / volume);
    }
}

TEST(ClippedCells, FillPlaneShapes) {
  for (const auto& named : plane_shapes()) cells_fill<2>(named, 0.12);
}
TEST(ClippedCells, FillSolidShapes) {
  for (const auto& named : solid_shapes()) cells_fill<3>(named, 0.3);
}

// Without anything to clip they are the Voronoi cells of the box, with the same facets.
template <int d>
void whole_box() {
  for (const auto& [name, cloud] : test::all_clouds<d>()) {
    const auto cells = clipped_cells<d>(cloud.X, Shape<d>{cloud.box, {}});
    const auto volumes = voronoi_volumes<d>(cloud.X, cloud.box);
    std::vector<Vec<d>> difference(cloud.size(), Vec<d>::Zero());
    for (const auto& f : cells.facets) difference[f.owner] += f.area;
    for (const auto& f : voronoi_facets<d>(cloud.X, cloud.box)) difference[f.owner] -= f.area;
    for (Index i = 0; i < cloud.size(); ++i) {
      EXPECT_NEAR(cells.volume[i], volumes[i], 1e-11 * std::pow(cloud.spacing, d))
          << name;  // voro++'s tolerance
      EXPECT_LT(difference[i].norm(), 1e-11 * std::pow(cloud.spacing, d - 1)) << name;
    }
  }
}
TEST(ClippedCells, OfAWholeBoxAreTheVoronoiCells) {
  whole_box<2>();
  whole_box<3>();
}

template <int d>
void cloud_keeps_its_promises(const NamedShape<d>& named, double spacing) {
  for (const Layout layout : {Layout::cell, Layout::node})
    for (const bool blue : {false, true}) {
      SCOPED_TRACE(named.name + (layout == Layout::cell ? ", cell" : ", node") + (blue ? ", blue" : ""));
      const Filling filling{spacing, layout, blue, 0, 5};
      const Cloud<d> cloud = shaped_cloud<d>(named.shape, filling);
      double nearest = 1e9;
      Index on_surface = 0;
      for (Index i = 0; i < cloud.size(); ++i) {
        EXPECT_LT(named.shape.distance(cloud.X[i]), 1e-10 * spacing);
        on_surface += named.shape.distance(cloud.X[i]) > -1e-9 * spacing;
        for (Index j = 0; j < i; ++j) nearest = std::min(nearest, (cloud.X[i] - cloud.X[j]).norm());
      }
      EXPECT_EQ(on_surface > 0, layout == Layout::node);
      EXPECT_GT(nearest, 0.499 * spacing);  // nodes of the lattice stay half a spacing off the surface
      // one particle per spacing^d, but for the layers at the surface (7 for 6.67, 24 of a disc for 22.3) and
      // the spread of random packings
      const double per_cell = static_cast<double>(cloud.size()) * std::pow(spacing, d) / named.volume;
      EXPECT_GT(per_cell, layout == Layout::node ? 0.9 : 0.75);
      EXPECT_LT(per_cell, layout == Layout::node ? 1.7 : 1.2);
      EXPECT_EQ(shaped_cloud<d>(named.shape, filling).X, cloud.X);  // the same seed
    }
}

TEST(ShapedCloud, LiesInsideAndOnTheSurfaceOfNodeLayouts) {
  for (const auto& named : plane_shapes()) cloud_keeps_its_promises<2>(named, 0.1);
  for (const auto& named : solid_shapes()) cloud_keeps_its_promises<3>(named, 0.25);
}

TEST(Shape, DistancesAreSignedAndNoLargerThanTheTrueOnes) {
  test::Numbers numbers(4);
  for (const auto& named : plane_shapes())
    for (int n = 0; n < 300; ++n) {
      const Vec<2> X = 1.5 * numbers.vector<2>(), Y = 1.5 * numbers.vector<2>();
      EXPECT_LE(std::abs(named.shape.distance(X) - named.shape.distance(Y)), (X - Y).norm() * (1 + 1e-12))
          << named.name;
    }
}

TEST(Shape, BadOnesAreRefused) {
  EXPECT_THROW(shape_named<2>("bal", {}), InputError);
  EXPECT_THROW(shape_named<2>("ball", {}), InputError);  // no radius
  EXPECT_THROW(shape_named<2>("ball", {{"radius", {-1}}}), InputError);
  EXPECT_THROW(shape_named<2>("ball", {{"radius", {1}}, {"centre", {0, 0, 0}}}), InputError);  // 3D
  EXPECT_THROW(shape_named<2>("cylinder", {{"radius", {1}}, {"length", {1}}}), InputError);
  EXPECT_THROW(shape_named<2>("annulus", {{"inner", {1}}, {"outer", {0.5}}}), InputError);
  EXPECT_THROW(shape_named<2>("polygon", {{"corners", {0, 0, 1, 1}}}), InputError);
  EXPECT_THROW(shape_named<3>("half-space", {{"point", {0, 0, 0}}, {"normal", {0, 0, 0}}}), InputError);
  const auto plane = shape_named<2>("half-space", {{"point", {0, 0}}, {"normal", {1, 0}}});
  EXPECT_THROW(shaped_cloud<2>(plane, {0.1}), InputError);  // no bounds
  EXPECT_THROW(
      shaped_cloud<2>(shape_named<2>("annulus", {{"inner", {0.01}}, {"outer", {0.02}}}), {0.1, Layout::cell}),
      InputError);  // a hole around the only cell's middle
}

}  // namespace
}  // namespace plumb
