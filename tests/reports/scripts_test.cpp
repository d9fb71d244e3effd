// What gnuplot is told to draw, to the letter: a regression test of every kind of picture, so that a slip in
// a margin, a tick, a dash or a place of a label is seen. After an intended change look at the pictures, then
// PLUMB_WRITE_SCRIPTS=1 build/release/tests/tests_reports --gtest_filter='*Scripts*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "places.hpp"
#include "reports/plot/script.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;

Picture errors() {
  Picture p{
      "Error of the swinging plate against the spacing, with a long title that takes two lines and more",
      {"spacing d", "m", Scale::log},
      {"relative error in L₂", "", Scale::log}};
  p.series = {{"W1, improved", {0.2, 0.1, 0.05, 0.025}, {4e-3, 1.1e-3, 2.6e-4, 7e-5}},
              {"W0", {0.2, 0.1, 0.05}, {8e-3, 2.1e-3, 5.2e-4}, Style::points},
              {"W0, standard", {0.2, 0.1, 0.05}, {7.8e-3, 5e-3, 3.2e-3}, Style::lines}};
  p.series[0].band = Band{{3e-3, 0.9e-3, 2e-4, 5e-5}, {5e-3, 1.3e-3, 3e-4, 9e-5}};
  p.series[1].hollow = true;
  p.series[2].dashed = true;
  p.triangles = {{2, 0}, {1, 2}};
  p.lines = {{1e-4, "round-off", false}, {0.07, "", true}};
  return p;
}

Picture energies() {
  Picture p{"Energy", {"time", "s"}, {"energy", "J"}};
  p.labels = Labels::legend;
  for (int k = 0; k < 7; ++k)
    p.series.push_back(
        {"a name of part " + std::to_string(k), {0, 0.5, 1.25}, {0.0, 1.0 * k, -0.5 * k}, Style::lines});
  p.series[3].colour = 0;
  p.y.min = -4.5;
  p.x.ticks = {0, 0.4, 1.2};
  return p;
}

Picture steps_of_one() {
  Picture p{"Steps", {"n"}, {"share"}};
  p.series = {{"a", {0, 2, 5.5}, {0, 0.3, 0.55}}};
  return p;
}

Picture flat() {
  Picture p{"One value", {"N", "1"}, {"value"}};
  p.series = {{"flat", {10, 20000, 3e5}, {2.5, 2.5, 2.5}}, {"two", {10, 20000, 3e5}, {2.5, 2.5, 2.5}}};
  return p;
}

Picture heat() {
  Picture p{"Heat", {"x", "m", Scale::log}, {"y", "m"}};
  p.map = HeatMap{{0.1, 0.2, 0.4}, {0, 1}, {1, 2, 3, 4, 50, 600}, "stress", "MPa", Scale::log};
  return p;
}

Picture categories() {
  Picture p{"Outcomes", {"scheme"}, {"cfl"}};
  p.map = CategoryMap{{1, 1.5, 2}, {0.1, 0.2}, {0, 1, -1, 2, 1, 0}, {"stable", "inverted", "hourglass"}};
  return p;
}

Picture intervals() {
  Picture p{"Orders", {"order"}, {""}};
  p.map = Intervals{{"W1 & more", "W0", "none"}, {1.9, 0.5, 2.2}, {2, 0.7, 2.3}, {2.1, 0.9, 2.4}, {2, 2, 2}};
  return p;
}

Picture points() {
  Picture p{"Particles", {"x", "m"}, {"y", "m"}};
  p.map = PointMap{{0, 1, 2}, {0, 0.5, 1}, {10, 20, 35}, 0.5, "von Mises stress", "MPa"};
  p.equal_axes = true;
  return p;
}

Picture patches() {
  Picture p{"Body", {""}, {""}};
  p.map = Patches{{0, 1, 1, 0, 1, 2, 2, 1}, {0, 0, 1, 1, 0, 0, 1, 1}, {5, 7.5}, "stress", "MPa", 0.0, 10.0,
                  {{0, 0, 1, 0, "x, 1 m"}}};
  p.equal_axes = true;
  return p;
}

struct Case {
  std::string name;
  Picture (*picture)();
};

class Scripts : public testing::TestWithParam<Case> {};

TEST_P(Scripts, AreWhatTheyWere) {
  const auto file =
      std::filesystem::path(PLUMBLINE_SOURCE_DIR "/tests/reports/scripts") / (GetParam().name + ".gp");
  const Picture picture = GetParam().picture();
  std::string text = plot::script(plot::prepare(picture), plot::Format::svg, "picture.svg");
  if (GetParam().name == "errors")
    text += plot::script(plot::prepare(picture), plot::Format::png, "picture.png");
  if (std::getenv("PLUMB_WRITE_SCRIPTS")) std::ofstream(file) << text;
  EXPECT_EQ(text, plumb::test::content_of(file));
}

INSTANTIATE_TEST_SUITE_P(Pictures, Scripts,
                         testing::Values(Case{"errors", errors}, Case{"energies", energies},
                                         Case{"steps", steps_of_one}, Case{"flat", flat}, Case{"heat", heat},
                                         Case{"categories", categories}, Case{"intervals", intervals},
                                         Case{"points", points}, Case{"patches", patches}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
