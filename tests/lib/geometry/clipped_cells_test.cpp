// Shapes, the Voronoi cells that they clip, and the clouds that fill them.
#include "lib/geometry/clipped_cells.hpp"

#include <gtest/gtest.h>

#include <map>
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
       false},
      {"square cut by a line",
       without(square, shape_named<2>("half-space", {{"point", {0.5, 0}}, {"normal", {2, 0}}})), 3, false},
      // an L: one corner turns inwards
      {"polygon",
       shape_named<2>("polygon", {{"corners", {0, 0, 1.7, 0, 1.7, 0.7, 0.6, 0.7, 0.6, 1.5, 0, 1.5}}}),
       1.7 * 0.7 + 0.6 * 0.8, false}};
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
      // sagittas of c^2/(8 R) <= 0.01 spacings^2; surface over volume is at most 6. Flat pieces are cut along
      // their planes, corners included.
      EXPECT_NEAR(volume / named.volume, 1, named.curved ? 0.06 * spacing * spacing : 1e-11);
      Vec<d> sum = Vec<d>::Zero();
      double enclosed = 0;
      for (const auto& facet : cells.facets) {
        sum += facet.area;
        enclosed += facet.centroid.dot(facet.area) / d;
      }
      // 2D: neighbouring cells meet in the same points of the surface, found to 1e-10 spacings. 3D: their
      // triangles leave cracks as deep as the sagittas.
      EXPECT_LT(sum.norm() / volume, d == 2 ? 1e-9 : 2e-3 * spacing * spacing);
      // Pieces of an arc as long as a spacing make one facet, whose centroid is off by spacing^2/(24 R).
      EXPECT_NEAR(enclosed / volume, 1, named.curved ? spacing * spacing / 3 : 1e-9);
    }
}

TEST(ClippedCells, FillPlaneShapes) {
  for (const auto& named : plane_shapes()) cells_fill<2>(named, 0.12);
}
TEST(ClippedCells, FillSolidShapes) {
  for (const auto& named : solid_shapes()) cells_fill<3>(named, 0.3);
}

using Outline = std::vector<Vec<2>>;

double area_of(const Outline& p) {
  double twice = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vec<2>&a = p[k], &b = p[(k + 1) % p.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

/// The side of a line where n . X <= c.
struct Side {
  Vec<2> n;
  double c;
};

/// Sides of the Voronoi cell of particle i: bisectors to all others.
std::vector<Side> cell_sides(const std::vector<Vec<2>>& X, std::size_t i) {
  std::vector<Side> sides;
  for (std::size_t j = 0; j < X.size(); ++j)
    if (j != i) sides.push_back({X[j] - X[i], 0.5 * (X[j].squaredNorm() - X[i].squaredNorm())});
  return sides;
}

/// The outline cut by those sides (Sutherland and Hodgman); parts of one that is not convex stay joined by bridges without area.
Outline cut_by(Outline outline, const std::vector<Side>& sides) {
  for (const Side& side : sides) {
    Outline left;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec<2>&a = outline[k], &b = outline[(k + 1) % outline.size()];
      const double here = side.n.dot(a) - side.c, there = side.n.dot(b) - side.c;
      if (here <= 0) left.push_back(a);
      if (here * there < 0) left.push_back(a + here / (here - there) * (b - a));
    }
    outline = std::move(left);
  }
  return outline;
}

/// Length of what those sides leave of a segment.
double length_within(const Vec<2>& a, const Vec<2>& b, const std::vector<Side>& sides) {
  double from = 0, to = 1;
  for (const Side& side : sides) {
    const double here = side.n.dot(a) - side.c, there = side.n.dot(b) - side.c;
    if (here > 0 && there > 0) return 0;
    if (here > 0) from = std::max(from, here / (here - there));
    if (there > 0) to = std::min(to, here / (here - there));
  }
  return std::max(0.0, to - from) * (b - a).norm();
}

/// Counterclockwise, aslant to the lattice of their boxes: a square, a wedge of 14 degrees, a star with corners that turn
/// inwards, and one whose sides differ by 4 degrees.
std::vector<Outline> slanted() {
  const auto at = [](double x, double y) {
    return Vec<2>(std::cos(0.3) * x - std::sin(0.3) * y, std::sin(0.3) * x + std::cos(0.3) * y);
  };
  Outline star, blunt;
  for (int k = 0; k < 10; ++k) {
    const double angle = k * pi / 5 + 0.1, r = k % 2 ? 0.4 : 1;
    star.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  for (int k = 0; k < 90; ++k) blunt.emplace_back(std::cos(k * pi / 45 + 0.01), std::sin(k * pi / 45 + 0.01));
  return {{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, {at(0, 0), at(2, 0.2), at(2, 0.7)}, star, blunt};
}

/// Areas and pieces of the edges of every cell, by another formula: the outline and its edges cut by bisectors.
TEST(ClippedCells, OfAPolygonAreExactAtItsCornersToo) {
  for (const Outline& outline : slanted())
    for (const Layout layout : {Layout::cell, Layout::node}) {
      std::vector<double> corners;
      for (const Vec<2>& corner : outline) corners.insert(corners.end(), {corner[0], corner[1]});
      const auto shape = shape_named<2>("polygon", {{"corners", corners}});
      const double spacing = 0.11, whole = area_of(outline);
      const Cloud<2> cloud = shaped_cloud<2>(shape, {spacing, layout, false, 0, 3});
      const auto cells = clipped_cells<2>(cloud.X, shape);
      double sum = 0;
      std::vector<std::map<std::size_t, double>> pieces(cloud.X.size());
      for (const auto& facet : cells.facets) {
        for (std::size_t k = 0; k < outline.size(); ++k) {
          const Vec<2> edge = outline[(k + 1) % outline.size()] - outline[k], normal(edge[1], -edge[0]);
          if (facet.area.dot(normal) < (1 - 1e-9) * facet.area.norm() * normal.norm()) continue;
          pieces[facet.owner][k] += facet.area.norm();
          // it lies on that edge
          EXPECT_NEAR(normal.dot(facet.centroid - outline[k]) / normal.norm(), 0, 1e-10 * spacing);
        }
      }
      for (std::size_t i = 0; i < cloud.X.size(); ++i) {
        const auto sides = cell_sides(cloud.X, i);
        sum += cells.volume[i];
        // voro++ finds corners of cells to 1e-11 of the cell
        EXPECT_NEAR(cells.volume[i], area_of(cut_by(outline, sides)), 1e-11 * spacing * spacing);
        for (std::size_t k = 0; k < outline.size(); ++k)
          EXPECT_NEAR(pieces[i][k], length_within(outline[k], outline[(k + 1) % outline.size()], sides),
                      1e-9 * spacing)
              << i << ' ' << k;
      }
      EXPECT_NEAR(sum / whole, 1, 1e-12);
    }
}

/// A body with a hole of flat sides: eight corners that turn inwards.
TEST(ClippedCells, OfACubeWithACubicHoleAreExact) {
  const Shape<3> cube{{Vec<3>(-1, -1, -1), Vec<3>(2, 2, 2)}, {}};
  const auto shape =
      without(cube, shape_named<3>("box", {{"origin", {-0.31, -0.52, -0.13}}, {"size", {0.7, 0.8, 0.37}}}));
  const Cloud<3> cloud = shaped_cloud<3>(shape, {0.3, Layout::cell, false, 0.2, 3});
  const auto cells = clipped_cells<3>(cloud.X, shape);
  EXPECT_NEAR(std::accumulate(cells.volume.begin(), cells.volume.end(), 0.0), 8 - 0.7 * 0.8 * 0.37, 1e-11);
  Vec<3> size = Vec<3>::Zero();
  for (const auto& facet : cells.facets) size += facet.area.cwiseAbs();
  for (int k = 0; k < 3; ++k) {  // twice the faces across an axis, of the cube and of the hole
    const double hole = 0.7 * 0.8 * 0.37 / std::array{0.7, 0.8, 0.37}[static_cast<std::size_t>(k)];
    EXPECT_NEAR(size[k], 2 * (4 + hole), 1e-9) << k;
  }
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
