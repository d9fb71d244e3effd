#include "reports/picture.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "lib/core/error.hpp"
#include "reports/plot/check.hpp"
#include "reports/plot/prepare.hpp"

namespace {

using namespace plumb::reports;
using plumb::InputError;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Error against spacing on two logarithmic axes, as a convergence study draws it.
Picture convergence() {
  Picture p{"Error & <spacing>", {"spacing d", "m", Scale::log}, {"error in L₂", "m", Scale::log}};
  p.series = {{"W1", {0.2, 0.1, 0.05}, {4e-4, 1e-4, 2.5e-5}},
              {"W0 `id`", {0.2, 0.1, 0.05}, {8e-4, 2e-4, 5e-5}}};
  p.series[0].band = Band{{3e-4, 0.9e-4, 2e-5}, {5e-4, 1.1e-4, 3e-5}};
  p.triangles = {{2.0, 0}};
  p.lines = {{1e-5, "noise floor", false}};
  return p;
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// All text between tags, which is what a reader sees; throws if the SVG is not well-formed.
std::string visible_text(const std::string& svg) {
  std::istringstream in(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(in, tree);
  std::string text;
  const auto walk = [&text](const auto& self, const boost::property_tree::ptree& node) -> void {
    text += node.data() + "|";
    for (const auto& child : node)
      if (child.first != "style") self(self, child.second);
  };
  walk(walk, tree);
  return text;
}

std::string message(const auto& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class PictureFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "plumb-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

TEST(Picture, SvgIsWellFormedAndShowsEveryText) {
  const std::string text = visible_text(svg(convergence()));
  for (const char* wanted :
       {"Error & <spacing>", "spacing d [m]", "error in L₂ [m]", "W1", "W0 'id'", "slope 2", "noise floor"})
    EXPECT_NE(text.find(wanted), std::string::npos) << wanted << " is missing in " << text;
}

TEST(Picture, ABodyHasASquareForEveryParticleAndANamedColourBar) {
  Picture p{"body", {"x", "m"}, {"y", "m"}};
  p.map = PointMap{{0, 1, 2}, {0, 0, 1}, {10, 20, nan}, 0.5, "von Mises stress", "MPa"};
  p.equal_axes = true;
  EXPECT_NE(svg(p).find("von Mises stress [MPa]"), std::string::npos);
  EXPECT_EQ(data_csv(p).substr(0, 16), "x,y,value\n0,0,10");
  std::get<PointMap>(p.map).z.pop_back();
  EXPECT_THROW(svg(p), InputError);
}

TEST(Picture, IntervalsNameTheirRowsAndPatchesTheirScale) {
  Picture orders{"Orders", {"order"}, {""}};
  orders.map = Intervals{{"W1 & more", "W0"}, {1.9, 0.5}, {2, 0.7}, {2.1, 0.9}, {2, 2}};
  const auto text = visible_text(svg(orders));
  for (const char* wanted : {"W1 & more", "W0", "order"})
    EXPECT_NE(text.find(wanted), std::string::npos) << wanted;
  EXPECT_NE(data_csv(orders).find("W0,0.5,0.69999999999999996,0.90000000000000002,2"), std::string::npos);
  Picture body{"body", {""}, {""}};
  body.map = Patches{{0, 1, 1, 0}, {0, 0, 1, 1}, {5}, "stress", "MPa", 0.0, 10.0, {{0, 0, 1, 0, "x, 1 m"}}};
  const auto seen = visible_text(svg(body));
  for (const char* wanted : {"stress [MPa]", "x, 1 m"})
    EXPECT_NE(seen.find(wanted), std::string::npos) << wanted;
  EXPECT_NE(data_csv(body).find("0,0,1,0,1,1,0,1,5"), std::string::npos);
  std::get<Patches>(body.map).y.pop_back();
  EXPECT_THROW(svg(body), InputError);
  std::get<Intervals>(orders.map).low.pop_back();
  EXPECT_THROW(svg(orders), InputError);
}

TEST(Picture, SamePictureGivesTheSameBytes) {
  EXPECT_EQ(svg(convergence()), svg(convergence()));
}

TEST(Picture, EveryIdStartsWithThePrefix) {
  const std::string text = svg(convergence(), "figure-7");
  std::size_t ids = 0;
  for (std::size_t at = text.find(" id="); at != std::string::npos; at = text.find(" id=", at + 1), ++ids)
    EXPECT_EQ(text.substr(at + 5, 9), "figure-7-") << text.substr(at, 40);
  EXPECT_GT(ids, 10u);
}

TEST(Picture, TextCannotActAsACommand) {
  Picture p = convergence();
  p.title = "`touch plumb-was-here` \"; set output 'x' # \\";
  EXPECT_NE(visible_text(svg(p)).find("'touch plumb-was-here'"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists("plumb-was-here"));
}

TEST(Picture, PointsThatALogAxisCannotShowAreReportedAndNamedInThePicture) {
  Picture p = convergence();
  p.series[1].y[1] = 0;
  p.series[1].y[2] = nan;
  const auto file = std::filesystem::temp_directory_path() / "plumb-dropped-test.svg";
  const auto dropped = save(p, file);
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_EQ(dropped[0].series, "W0 `id`");
  EXPECT_EQ(dropped[0].points, 2u);
  EXPECT_NE(visible_text(read(file)).find("Not drawn: 2 points"), std::string::npos);
  std::filesystem::remove(file);
}

TEST(Picture, ASeriesWithoutAnyPointForALogAxisIsRefused) {
  Picture p = convergence();
  p.series[0].y = {0, -1, 0};
  const auto text = message([&] { svg(p); });
  EXPECT_NE(text.find("\"W1\""), std::string::npos) << text;
  EXPECT_NE(text.find("not positive on a logarithmic axis"), std::string::npos) << text;
}

TEST(Picture, RefusesWhatCannotBeDrawn) {
  Picture lengths = convergence();
  lengths.series[0].x.pop_back();
  EXPECT_THROW(svg(lengths), InputError);
  Picture band = convergence();
  band.series[0].band->low.pop_back();
  EXPECT_THROW(svg(band), InputError);
  Picture linear = convergence();
  linear.y.scale = Scale::linear;
  EXPECT_THROW(svg(linear), InputError);  // a slope triangle needs two logarithmic axes
  Picture ends = convergence();
  ends.x.min = -1;
  EXPECT_THROW(svg(ends), InputError);
  EXPECT_THROW(svg(Picture{"empty", {"x"}, {"y"}}), InputError);
  Picture equal = convergence();
  equal.equal_axes = true;
  EXPECT_THROW(svg(equal), InputError);
  Picture size = convergence();
  size.width = 0;
  EXPECT_THROW(svg(size), InputError);
  Picture map{"map", {"x"}, {"y"}};
  map.map = HeatMap{{0, 1}, {0, 1}, {1, 2, 3}, "value"};
  EXPECT_THROW(svg(map), InputError);
  map.map = CategoryMap{{0, 1}, {0}, {0, 1}, {"stable"}};
  EXPECT_THROW(svg(map), InputError);
}

TEST(Picture, CellsOfAMapEndHalfwayOnTheAxisAsDrawn) {
  EXPECT_EQ(plot::cell_borders({1, 2, 4, 5}, false), (std::vector<double>{0.5, 1.5, 3, 4.5, 5.5}));
  const std::vector<double> logarithmic = plot::cell_borders({1, 4, 64}, true), expected{0.5, 2, 16, 256};
  ASSERT_EQ(logarithmic.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(logarithmic[k], expected[k], 1e-12 * expected[k]);
}

TEST(Picture, SizesAreTakenUpToTheirLimits) {
  const auto made = [](int width, int height) {
    Picture p = convergence();
    p.width = width;
    p.height = height;
    return message([&] { plot::check(p); });
  };
  for (const auto& [width, height] : {std::pair(200, 150), {8000, 8000}, {200, 8000}})
    EXPECT_EQ(made(width, height), "no error");
  for (const auto& [width, height] : {std::pair(199, 150), {200, 149}, {8001, 150}, {200, 8001}})
    EXPECT_NE(made(width, height), "no error") << width << ' ' << height;
}

TEST(Picture, MapsShowTheirNamesAndUnits) {
  Picture heat{"Limit", {"beta"}, {"Poisson's ratio"}};
  heat.map = HeatMap{{0.6, 0.9, 1.2}, {0.3, 0.45}, {1, 2, 3, 4, nan, 6}, "largest step", "µs"};
  EXPECT_NE(visible_text(svg(heat)).find("largest step [µs]"), std::string::npos);
  Picture kinds{"Cause", {"beta"}, {"Poisson's ratio"}};
  kinds.map = CategoryMap{{0.6, 0.9}, {0.3, 0.45}, {0, 1, 1, -1}, {"stable", "inverted"}};
  const auto text = visible_text(svg(kinds));
  EXPECT_NE(text.find("stable"), std::string::npos);
  EXPECT_NE(text.find("inverted"), std::string::npos);
}

TEST_F(PictureFile, PngByItsEnding) {
  save(convergence(), folder / "p.png");
  EXPECT_EQ(read(folder / "p.png").substr(0, 4), "\x89PNG");
}

TEST_F(PictureFile, WrongEndingAndUnwritablePlaceAreSaid) {
  EXPECT_NE(message([&] { save(convergence(), folder / "p.pdf"); }).find(".svg"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "p.pdf"));
  EXPECT_NE(message([&] { save(convergence(), folder / "none" / "p.svg"); }).find("cannot be written"),
            std::string::npos);
}

TEST_F(PictureFile, MissingGnuplotIsSaid) {
  const std::string before = std::getenv("PATH");
  setenv("PATH", folder.c_str(), 1);
  const auto text = message([&] { save(convergence(), folder / "p.svg"); });
  setenv("PATH", before.c_str(), 1);
  EXPECT_NE(text.find("gnuplot is not in PATH"), std::string::npos) << text;
  EXPECT_FALSE(std::filesystem::exists(folder / "p.svg"));
}

TEST(Picture, DataBehindThePictureAsCsv) {
  Picture p = convergence();
  p.series[1].label = "a, \"b\"";
  p.series[1].y[2] = nan;
  EXPECT_EQ(data_csv(p).substr(0, 21), "series,x,y,low,high\nW");
  EXPECT_NE(data_csv(p).find("\nW1,0.10000000000000001,0.0001"), std::string::npos) << data_csv(p);
  EXPECT_NE(data_csv(p).find("\n\"a, \"\"b\"\"\",0.050000000000000003,,,\n"), std::string::npos)
      << data_csv(p);
}

}  // namespace
