// Bodies out of files, surfaces and clouds, in the schemes of the house.
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include "lib/core/error.hpp"
#include "lib/scene/cloud_file.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/scene/tlsph.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

/// A scene whose left side is clamped and whose right side is pulled, beside a file of that text.
Scene scene_of(const std::string& file_name, const std::string& text, const std::string& body,
               const std::string& method, int dimension = 2) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / file_name) << text;
  std::ofstream(folder / "scene.toml")
      << "[scene]\ndimension = " << dimension << "\nend_time = \"1 ms\"\n[body]\n"
      << body << "\n[material]\nyoung = \"17 MPa\"\npoisson = 0.3\ndensity = 1100\n"
      << "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n"
      << "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"1e5\", "
      << (dimension == 2 ? "\"0\"]" : "\"0\", \"0\"]") << "\n[method]\n"
      << method;
  return read_scene((folder / "scene.toml").string());
}

std::string refusal(const std::string& file_name, const std::string& text, const std::string& body,
                    const std::string& method = "scheme = \"tlsph\"\n", int dimension = 2) {
  try {
    scene_of(file_name, text, body, method, dimension);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Text of an STL file of triangles, given by the numbers of their corners.
std::string stl(const std::vector<Vec<3>>& points, const std::vector<std::array<int, 3>>& triangles) {
  std::string text = "solid s\n";
  for (const auto& t : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int k : t) {
      const Vec<3>& X = points[static_cast<std::size_t>(k)];
      text +=
          "vertex " + std::to_string(X[0]) + ' ' + std::to_string(X[1]) + ' ' + std::to_string(X[2]) + '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid s\n";
}

/// An L: a square of side 2 without its upper right quarter.
const std::vector<Vec<3>> corners_of_l{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
const std::string flat_l = stl(corners_of_l, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});

/// The same, one high: its floor, its ceiling and its walls.
std::string solid_l() {
  std::vector<Vec<3>> points = corners_of_l;
  for (const Vec<3>& X : corners_of_l) points.emplace_back(X[0], X[1], 1);
  std::vector<std::array<int, 3>> triangles{{0, 2, 1}, {0, 3, 2}, {0, 4, 3},  {0, 5, 4},
                                            {6, 7, 8}, {6, 8, 9}, {6, 9, 10}, {6, 10, 11}};
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    triangles.push_back({k, next, next + 6});
    triangles.push_back({k, next + 6, k + 6});
  }
  return stl(points, triangles);
}

/// A node lattice of 9 x 5 points, one row after the other along that axis.
std::string lattice_text(bool x_first) {
  std::string text = "x,y\n";
  for (int n = 0; n < 45; ++n) {
    const int i = x_first ? n % 9 : n / 5, k = x_first ? n / 9 : n % 5;
    text += std::to_string(0.125 * i) + "," + std::to_string(0.125 * k) + "\n";
  }
  return text;
}

std::vector<Vec<2>> at_the_end(const Scene& scene) {
  auto simulation = make_simulation<2>(scene).simulation;
  RunRecord history;
  EXPECT_TRUE(run<2>(simulation, {}, history).completed());
  return simulation.snapshot().u;
}

class BodyFile : public testing::TestWithParam<std::string> {};

// A lattice in a file is the lattice of a box, whatever the scheme and the sequence of the points. Compatible
// bonds have a closed form on the box: here both are projected.
TEST_P(BodyFile, ALatticeInAFileIsTheBox) {
  std::string method = "scheme = \"" + GetParam() + "\"\n";
  if (GetParam() == "tlsph" || GetParam() == "implicit")
    method += "beta = 1.2\n[compatible]\ntable = \"projected\"\n";
  const Scene box = scene_of("no.csv", "", "size = [1, 0.5]\nspacing = 0.125", method);
  const auto u = at_the_end(box);
  double size = 0;
  for (const Vec<2>& each : u) size = std::max(size, each.norm());
  ASSERT_GT(size, 0);
  for (const bool x_first : {true, false}) {
    const auto of_file =
        at_the_end(scene_of("cloud.csv", lattice_text(x_first), "file = \"cloud.csv\"", method));
    ASSERT_EQ(of_file.size(), u.size());
    for (std::size_t n = 0; n < u.size(); ++n) {
      const std::size_t i = n % 9, k = n / 9;
      // 1e-8: sums of the same terms in another order, where a search for equilibrium ends
      EXPECT_LT((of_file[x_first ? n : 5 * i + k] - u[n]).norm(), 1e-8 * size) << n;
    }
  }
}

TEST_P(BodyFile, AnOutlineIsFilledAsShapesAreAndRunsWhereTheSchemeCan) {
  const std::string method = "scheme = \"" + GetParam() + "\"\n";
  const Scene scene = scene_of("l.stl", flat_l, "file = \"l.stl\"\nspacing = 0.125", method);
  EXPECT_EQ(scene.body.shape, "polygon");
  const Cloud<2> cloud = make_cloud<2>(scene.body);
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 3, 1e-9);
  if (GetParam() == "element") {
    EXPECT_THROW(make_simulation<2>(scene), InputError);
    return;
  }
  const auto u = at_the_end(scene);
  EXPECT_EQ(static_cast<Index>(u.size()), cloud.size());
}

TEST_P(BodyFile, AnIrregularCloudRunsWhereTheSchemeCan) {
  std::string text = "x,y\n";
  for (int n = 0; n < 81; ++n) {
    const double x = n % 9 / 8.0, y = n / 9 / 8.0, inside = x * (1 - x) * y * (1 - y);
    text += std::to_string(x + 0.4 * inside * std::sin(9.0 * n)) + "," +
            std::to_string(y + 0.4 * inside * std::cos(7.0 * n)) + "\n";
  }
  const Scene scene =
      scene_of("cloud.csv", text, "file = \"cloud.csv\"", "scheme = \"" + GetParam() + "\"\n");
  if (GetParam() == "element") {
    EXPECT_THROW(make_simulation<2>(scene), InputError);
    return;
  }
  EXPECT_EQ(at_the_end(scene).size(), 81u);
}

INSTANTIATE_TEST_SUITE_P(All, BodyFile, testing::ValuesIn(scheme_names()),
                         [](const auto& name) { return name.param; });

TEST(SurfaceFile, InThreeDimensionsItIsTheBodysSurface) {
  const Scene scene =
      scene_of("l.stl", solid_l(), "file = \"l.stl\"\nspacing = 0.25", "scheme = \"tlsph\"\n", 3);
  EXPECT_EQ(scene.body.shape, "polyhedron");
  EXPECT_EQ(scene.body.size, (std::vector<double>{2, 2, 1}));
  const Cloud<3> cloud = make_cloud<3>(scene.body);
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 3, 1e-9);
  for (const Vec<3>& X : cloud.X) EXPECT_FALSE(X[0] > 1 + 1e-12 && X[1] > 1 + 1e-12) << X.transpose();
  auto simulation = make_simulation<3>(scene).simulation;
  RunRecord history;
  EXPECT_TRUE(run<3>(simulation, {}, history).completed());
}

TEST(SurfaceFile, UnitsBlueNoiseAndFurtherHoles) {
  const std::string body =
      "file = \"l.STL\"\nunit = \"mm\"\nspacing = \"0.125 mm\"\ncloud = \"blue-noise\"\n[[body.hole]]\nshape "
      "= "
      "\"ball\"\ncentre = [\"0.5 mm\", \"0.5 mm\"]\nradius = \"0.25 mm\"";
  const Scene scene = scene_of("l.STL", flat_l, body, "scheme = \"tlsph\"\n");
  const Cloud<2> cloud = make_cloud<2>(scene.body);
  // circles become polygons: their sagittas
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), (3 - M_PI / 16) * 1e-6, 1e-9);
}

TEST(SurfaceFile, AHoleOfTheOutlineIsAHole) {
  std::vector<Vec<3>> points;
  for (const double side : {1.0, 0.5})
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      points.emplace_back(side * x, side * y, 0);
  const std::string frame =
      stl(points, {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}});
  const Scene scene =
      scene_of("frame.stl", frame, "file = \"frame.stl\"\nspacing = 0.125", "scheme = \"tlsph\"\n");
  EXPECT_EQ(scene.body.shape, "box");
  ASSERT_EQ(scene.body.holes.size(), 1u);
  const Cloud<2> cloud = make_cloud<2>(scene.body);
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 3, 1e-9);
}

TEST(SurfaceFile, RefusalsNameThePlace) {
  const std::string body = "file = \"l.stl\"\nspacing = 0.25";
  EXPECT_NE(refusal("l.stl", solid_l(), body).find("reach from z = 0 to z = 1"), std::string::npos);
  EXPECT_NE(refusal("l.stl", flat_l, body, "", 3).find("file: the surface is open at the edge from"),
            std::string::npos)
      << refusal("l.stl", flat_l, body, "", 3);
  EXPECT_NE(refusal("l.stl", flat_l, body + "\nshape = \"ball\"").find("shape: contradicts file"),
            std::string::npos);
  EXPECT_NE(refusal("l.stl", flat_l, "file = \"l.stl\"").find("spacing"), std::string::npos);
  EXPECT_NE(refusal("l.stl", "x,y\n0,0\n", body).find("no STL"), std::string::npos);
  EXPECT_NE(refusal("l.stl", flat_l, body + "\nparticles = [9, 9]").find("particles"), std::string::npos);
}

/// Particles on [0, 2]^2, spacing 0.125, without those nearer to (1, 1) than that.
std::string with_hole(double radius) {
  std::string text = "x,y\n";
  for (int n = 0; n < 17 * 17; ++n) {
    const Vec<2> X(0.125 * (n % 17), 0.125 * (n / 17));
    if ((X - Vec<2>(1, 1)).norm() >= radius) text += std::to_string(X[0]) + "," + std::to_string(X[1]) + "\n";
  }
  return text;
}

TEST(CloudWithAHole, IsRefusedUnlessItIsExplained) {
  const std::string body = "file = \"cloud.csv\"";
  const std::string said = refusal("cloud.csv", with_hole(0.45), body);
  EXPECT_NE(said.find("there is a hole at (0.9"), std::string::npos) << said;
  EXPECT_EQ(refusal("cloud.csv", with_hole(0.13), body), "") << "one particle and those beside it";
  const std::string hole = "\n[[body.hole]]\nshape = \"ball\"\ncentre = [1, 1]\nradius = 0.4";
  const Scene scene = scene_of("cloud.csv", with_hole(0.45), body + hole, "scheme = \"tlsph\"\n");
  const Cloud<2> cloud = cloud_of_file<2>(scene.body);
  EXPECT_NEAR(std::accumulate(cloud.V.begin(), cloud.V.end(), 0.0), 4 - 0.16 * M_PI, 2e-3);
}

TEST(CloudWithAHole, GradedCloudsHaveNone) {
  std::string text = "x,y\n";  // spacing from 0.02 to 0.2
  for (double x = 0; x < 2; x += 0.02 + 0.09 * x)
    for (double y = 0; y < 2; y += 0.02 + 0.09 * x)
      text += std::to_string(x) + "," + std::to_string(y) + "\n";
  EXPECT_EQ(refusal("cloud.csv", text, "file = \"cloud.csv\""), "");
}

}  // namespace
}  // namespace plumb
