// [body] file: particles that another program placed.
#include <gtest/gtest.h>

#include <fstream>

#include "lib/core/error.hpp"
#include "lib/scene/cloud_file.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::string scene_text(const std::string& body, int dimension = 2) {
  return "[scene]\nname = \"cloud\"\ndimension = " + std::to_string(dimension) +
         "\nend_time = \"1 ms\"\n[body]\n" + body +
         "\n[material]\nmodel = \"neo-hookean\"\nyoung = \"1 MPa\"\npoisson = 0.3\ndensity = 1000\n";
}

/// A scene beside a cloud of these lines.
Scene scene_of(const std::string& cloud, const std::string& body, const std::string& name = "cloud.csv") {
  const test::TemporaryFolder folder;
  std::ofstream(folder / name) << cloud;
  std::ofstream(folder / "scene.toml") << scene_text(body);
  return read_scene((folder / "scene.toml").string());
}

std::string refusal(const std::string& cloud, const std::string& body = "file = \"cloud.csv\"") {
  try {
    scene_of(cloud, body);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string square = "x,y\n0,0\n1,0\n2,0\n0,1\n1,1\n2,1\n0,2\n1,2\n2,2\n";

TEST(CloudFile, VolumesAreThoseOfVoronoiCellsInTheBoxAroundThePoints) {
  const Scene scene = scene_of(square, "file = \"cloud.csv\"");
  EXPECT_EQ(scene.body.size, (std::vector<double>{2, 2}));
  EXPECT_NEAR(*scene.body.spacing, 1, 1e-12);
  const Cloud<2> cloud = cloud_of_file<2>(scene.body);
  ASSERT_EQ(cloud.size(), 9);
  EXPECT_NEAR(cloud.V[0], 0.25, 1e-12);
  EXPECT_NEAR(cloud.V[1], 0.5, 1e-12);
  EXPECT_NEAR(cloud.V[4], 1, 1e-12);
  EXPECT_EQ(cloud.X[5], Vec<2>(2, 1));
  EXPECT_EQ(make_cloud<2>(scene.body).V, cloud.V);  // what every scheme gets
}

TEST(CloudFile, VolumesOfTheFileAndUnits) {
  const Scene scene =
      scene_of("x,y,volume\n0,0,4\n1000,0,5\n0,1000,6\n1000,1000,7\n", "file = \"cloud.csv\"\nunit = \"mm\"");
  const Cloud<2> cloud = cloud_of_file<2>(scene.body);
  EXPECT_NEAR(cloud.X[3][0], 1, 1e-12);
  EXPECT_NEAR(cloud.V[3], 7e-6, 1e-18);
}

TEST(CloudFile, AShapeBoundsTheCells) {
  const Scene box = scene_of("0.5 0.5\n1.5 0.5\n0.5 1.5\n1.5 1.5\n", "file = \"cloud.csv\"\nsize = [2, 2]");
  for (const double V : cloud_of_file<2>(box.body).V) EXPECT_NEAR(V, 1, 1e-12);
  const Scene ball = scene_of("0.1 0\n-0.1 0\n", "file = \"cloud.csv\"\nshape = \"ball\"\nradius = 0.5");
  for (const double V : cloud_of_file<2>(ball.body).V)  // polygons on the circle: the sagitta of their sides
    EXPECT_NEAR(V, 0.25 * M_PI / 2, 1e-3);
}

TEST(CloudFile, RefusalsNameThePlace) {
  EXPECT_NE(refusal("x,y\n0,0\n1,0\n0,1\n1,0\n").find("points 2 and 4 are both at (1, 0)"),
            std::string::npos);
  EXPECT_NE(refusal("x,y,z\n0,0,0\n1,0,1\n").find("point 2 has z = 1"), std::string::npos);
  EXPECT_NE(refusal("x,y,volume\n0,0,1\n1,0,-1\n0,1,1\n").find("volume of point 2"), std::string::npos);
  EXPECT_NE(refusal("x,y\n0,0\n1,0\n2,0\n").find("in a line"), std::string::npos);
  EXPECT_NE(refusal(square, "file = \"cloud.csv\"\nsize = [1, 2]").find("point 3 at (2, 0) lies outside"),
            std::string::npos);
  EXPECT_NE(refusal(square, "file = \"cloud.csv\"\nlayout = \"cell\"").find("layout: contradicts file"),
            std::string::npos);
  EXPECT_NE(refusal(square, "file = \"other.csv\"").find("other.csv: cannot be read"), std::string::npos);
  EXPECT_NE(refusal(square, "file = \"cloud.csv\"\nunit = \"kg\"").find("unit"), std::string::npos);
  EXPECT_NE(refusal("x,y\n0,0\n").find("one point"), std::string::npos);
}

TEST(CloudFile, ItsSpacingIsItsOwn) {
  const Scene scene = scene_of(square, "file = \"cloud.csv\"");
  EXPECT_THROW(with_spacing(scene.body, 0.5), InputError);
  EXPECT_THROW(parse_scene(scene_text("file = \"nowhere.csv\""), "scene.toml"), InputError);
}

}  // namespace
}  // namespace plumb
