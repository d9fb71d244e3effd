// Clipped cells by their numbers: cubes cut by oblique planes against closed forms, first moments of whole
// bodies, and the same cells in any unit of length.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/shaped_cloud.hpp"

namespace plumb {
namespace {

using std::numbers::pi;

/// Of the part a . x < c of the unit cube, for a > 0: sums over the corners v with the sign of their number
/// of ones, V = sum s (c - a.v)+^d / (d! prod a); moments follow by derivatives with respect to a.
template <int d>
struct CutCube {
  double volume = 0, slope = 0;                                   ///< slope: dV/dc
  Vec<d> moment = Vec<d>::Zero(), moment_slope = Vec<d>::Zero();  ///< of x

  CutCube(const Vec<d>& a, double c) {
    const double all = a.prod(), d_factorial = std::tgamma(d + 1.0);
    for (int n = 0; n < (1 << d); ++n) {
      Vec<d> v;
      double s = 1;
      for (int k = 0; k < d; ++k) {
        v[k] = n >> k & 1;
        s *= v[k] > 0 ? -1 : 1;
      }
      const double left = std::max(0.0, c - a.dot(v));
      const double whole = s * std::pow(left, d) / (d_factorial * all),
                   layer = whole > 0 || whole < 0 ? d * whole / left : 0;
      volume += whole;
      slope += layer;
      for (int k = 0; k < d; ++k) {
        moment[k] += v[k] * whole + whole * left / ((d + 1) * a[k]);
        moment_slope[k] += v[k] * layer + whole / a[k];
      }
    }
  }
};

/// Every cell of a lattice that the plane a . X = c cuts, and every facet of that plane. The plane shall meet
/// no face of the box at less than 45 degrees: their pieces would make one facet.
template <int d>
void cut_by(const Vec<d>& a, double c) {
  constexpr double h = 0.25;
  std::vector<Vec<d>> X;
  for (int n = 0; n < std::pow(4, d); ++n) {
    Vec<d> middle;
    for (int k = 0, rest = n; k < d; ++k, rest /= 4) middle[k] = (rest % 4 + 0.5) * h;
    X.push_back(middle);
  }
  const Vec<d> point = c / a.squaredNorm() * a;
  const auto plane = shape_named<d>(
      "half-space", {{"point", {point.data(), point.data() + d}}, {"normal", {a.data(), a.data() + d}}});
  const auto cells = clipped_cells<d>(X, without(Shape<d>{{Vec<d>::Zero(), Vec<d>::Ones()}, {}}, plane));
  std::vector<double> area(X.size(), 0.0);
  for (const auto& f : cells.facets) {
    if (f.area.normalized().dot(a.normalized()) < 1 - 1e-9) continue;  // on the box
    const Vec<d> origin = X[f.owner] - Vec<d>::Constant(h / 2);
    const CutCube<d> part(h * a, c - a.dot(origin));
    // pieces on one plane make one facet
    EXPECT_NEAR(f.area.norm(), a.norm() * std::pow(h, d) * part.slope, 1e-9 * std::pow(h, d - 1));
    EXPECT_LT((f.centroid - origin - h * part.moment_slope / part.slope).norm(), 1e-8 * h);
    EXPECT_NEAR(f.depth, std::abs(c - a.dot(X[f.owner])) / a.norm(), 1e-9 * h);
    area[f.owner] += f.area.norm();
  }
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vec<d> origin = X[i] - Vec<d>::Constant(h / 2);
    const CutCube<d> part(h * a, c - a.dot(origin));
    EXPECT_NEAR(cells.volume[i], std::pow(h, d) * part.volume, 1e-9 * std::pow(h, d)) << X[i].transpose();
    EXPECT_NEAR(area[i], a.norm() * std::pow(h, d) * part.slope, 1e-9 * std::pow(h, d - 1))
        << X[i].transpose();
    if (part.volume > 1e-3) {
      EXPECT_LT((cells.centroid[i] - origin - h * part.moment / part.volume).norm(), 1e-7 * h)
          << X[i].transpose();
    }
  }
}

TEST(ClippedValues, OfALatticeThatAPlaneCuts) {
  cut_by<2>({2, 1}, 1.3);
  cut_by<2>({1, 3}, 0.71);
  cut_by<2>({5, 1}, 2.6);
  cut_by<3>({3, 2, 1}, 2.9);
  cut_by<3>({1, 1.5, 4}, 1.07);
}

/// A body at the scale 1, and the same at another one.
template <int d>
Shape<d> scaled(const std::string& name, ShapeLengths lengths, double scale) {
  for (auto& [key, values] : lengths)
    if (key != "normal")
      for (double& value : values) value *= scale;
  return shape_named<d>(name, lengths);
}

template <int d>
struct Named {
  std::string name;
  ShapeLengths lengths;
  double volume;
  Vec<d> centroid;
};

/// Powers of two change no digit of the points, and cells are the same in any unit.
template <int d>
void same_in_any_unit(const std::vector<Named<d>>& bodies, double spacing) {
  for (const auto& body : bodies)
    for (const double scale : {1024.0, 1.0 / 1024}) {
      SCOPED_TRACE(body.name);
      const auto here = scaled<d>(body.name, body.lengths, 1),
                 there = scaled<d>(body.name, body.lengths, scale);
      const Filling filling{spacing, Layout::node, false, 0.2, 3};
      const auto one = shaped_cloud<d>(here, filling);
      const auto other = shaped_cloud<d>(there, {scale * spacing, Layout::node, false, 0.2, 3});
      ASSERT_EQ(one.size(), other.size());
      for (Index i = 0; i < one.size(); ++i) ASSERT_LT((scale * one.X[i] - other.X[i]).norm(), 1e-12 * scale);
      std::vector<Vec<d>> X = one.X;
      for (auto& x : X) x *= scale;
      const auto cells = clipped_cells<d>(one.X, here), large = clipped_cells<d>(X, there);
      // voro++ works in a unit of its own, so that edges of one length are halved in another order: at most a
      // thousandth of the sagittas (clipped_cells_test.cpp); chords twice as long would change them fourfold
      const double sagitta = 0.2 * 0.01 * spacing * spacing;
      const auto volume = std::pow(spacing, d), area = volume / spacing;
      std::vector<Vec<d>> surface(X.size(), Vec<d>::Zero());
      for (const auto& f : cells.facets) surface[f.owner] += f.area / area;
      for (const auto& f : large.facets) surface[f.owner] -= f.area / std::pow(scale, d - 1) / area;
      for (std::size_t i = 0; i < X.size(); ++i) {
        EXPECT_NEAR(large.volume[i] / std::pow(scale, d) / volume, cells.volume[i] / volume, sagitta);
        EXPECT_LT((large.centroid[i] / scale - cells.centroid[i]).norm() / spacing, 10 * sagitta);
        EXPECT_LT(surface[i].norm(), 10 * sagitta);
      }
    }
}

/// Volume and centre of mass of the whole body.
template <int d>
void has_its_moments(const std::vector<Named<d>>& bodies, double spacing) {
  for (const auto& body : bodies) {
    SCOPED_TRACE(body.name);
    const auto shape = scaled<d>(body.name, body.lengths, 1);
    const auto cells = clipped_cells<d>(shaped_cloud<d>(shape, {spacing, Layout::cell}).X, shape);
    Vec<d> moment = Vec<d>::Zero();
    double volume = 0;
    for (std::size_t i = 0; i < cells.volume.size(); ++i) {
      moment += cells.volume[i] * cells.centroid[i];
      volume += cells.volume[i];
    }
    // chords of a quarter of the spacing, and corners that a cut chops off (see clipped_cells_test.cpp)
    EXPECT_NEAR(volume / body.volume, 1, 0.06 * spacing * spacing);
    EXPECT_LT((moment / volume - body.centroid).norm(), 0.06 * spacing * spacing);
  }
}

const std::vector<Named<2>> plane_bodies{
    {"ball", {{"centre", {0.3, -0.4}}, {"radius", {1}}}, pi, {0.3, -0.4}},
    {"annulus", {{"centre", {-0.2, 0.1}}, {"inner", {0.5}}, {"outer", {1}}}, 0.75 * pi, {-0.2, 0.1}},
    // 1.7 x 0.7 below 0.6 x 0.8
    {"polygon",
     {{"corners", {0, 0, 1.7, 0, 1.7, 0.7, 0.6, 0.7, 0.6, 1.5, 0, 1.5}}},
     1.67,
     {(1.19 * 0.85 + 0.48 * 0.3) / 1.67, (1.19 * 0.35 + 0.48 * 1.1) / 1.67}}};
const std::vector<Named<3>> solid_bodies{
    {"ball", {{"centre", {0.3, -0.4, 0.5}}, {"radius", {1}}}, 4 * pi / 3, {0.3, -0.4, 0.5}},
    {"cylinder", {{"centre", {1, 2, 3}}, {"radius", {0.8}}, {"length", {2}}}, 1.28 * pi, {1, 2, 3}}};

TEST(ClippedValues, AreTheSameInAnyUnitOfLength) {
  same_in_any_unit<2>(plane_bodies, 0.15);
  same_in_any_unit<3>(solid_bodies, 0.4);
}

TEST(ClippedValues, OfWholeBodiesHaveTheirMoments) {
  has_its_moments<2>(plane_bodies, 0.12);
  has_its_moments<3>(solid_bodies, 0.3);
}

}  // namespace
}  // namespace plumb
