// What --plot draws: a gnuplot of this file keeps what it is told, and every number in it is one of the JSON
// of the same call, under the name of its axis and series.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb::plots_test {
namespace {

using nlohmann::json;
using Points = std::vector<std::pair<double, double>>;

const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";

/// What gnuplot was told.
struct Drawing {
  std::string title, x, y;
  std::map<std::string, Points> series;
  json result;  ///< of the same call
};

std::string first_match(const std::string& text, const std::string& pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : "";
}

Points points_of(const std::string& script, const std::string& block) {
  Points points;
  const std::string heading = block + " << EOD\n";
  std::istringstream lines(script.substr(script.find(heading) + heading.size()));
  for (std::string line; std::getline(lines, line) && line != "EOD";) {
    std::istringstream numbers(line);
    double x = 0, y = 0;
    numbers >> x >> y;
    points.emplace_back(x, y);
  }
  return points;
}

Drawing drawn_by(const std::string& call) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "gnuplot")
      << "#!/bin/sh\ncat > \"$PLUMB_SCRIPT\"\n"
         "echo picture > \"$(sed -n 's/^set output \"\\(.*\\)\"$/\\1/p' \"$PLUMB_SCRIPT\")\"\n";
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  std::ofstream(folder / "table.csv") << "h,l2,h1\n0.4,0.32,4\n0.2,-0.08,2\n0.1,0.02,1\n0.05,0.005,0.5\n";
  const auto outcome =
      test::run_shell("cd " + folder.path().string() + " && PLUMB_SCRIPT=$PWD/script PATH=$PWD:$PATH " +
                      PLUMB_EXECUTABLE + " " + call + " --quiet --plot a.png --json a.json");
  EXPECT_LE(outcome.code, 1) << call << ": " << outcome.error;
  const std::string script = test::content_of(folder / "script");
  Drawing drawing;
  drawing.title = first_match(script, "set title \"([^\"]*)\"");
  drawing.x = first_match(script, "set xlabel \"([^\"]*)\"");
  drawing.y = first_match(script, "set label \"([^\"]*)\" at screen");
  const std::regex plotted("(\\$s\\d+) using 1:2 [^\n]* title \"([^\"]*)\"");
  for (std::sregex_iterator m(script.begin(), script.end(), plotted), end; m != end; ++m)
    drawing.series[(*m)[2]] = points_of(script, (*m)[1]);
  drawing.result = json::parse(test::content_of(folder / "a.json"));
  return drawing;
}

void expect_axes(const Drawing& drawing, const std::string& title, const std::string& x,
                 const std::string& y) {
  EXPECT_EQ(drawing.title, title);
  EXPECT_EQ(drawing.x, x);
  EXPECT_EQ(drawing.y, y);
}

/// The series holds the two columns of the rows that hold all of `where`; 1e-11: twelve digits are drawn.
void expect_series(const Drawing& drawing, const std::string& label, const std::string& x,
                   const std::string& y, const json& where, const std::string& rows = "rows") {
  Points expected;
  for (const json& row : drawing.result[rows]) {
    const auto items = where.items();
    const bool here = std::all_of(items.begin(), items.end(),
                                  [&](const auto& item) { return row[item.key()] == item.value(); });
    if (here) expected.emplace_back(row[x].get<double>(), row[y].get<double>());
  }
  ASSERT_TRUE(drawing.series.contains(label)) << label;
  const Points& found = drawing.series.at(label);
  ASSERT_EQ(found.size(), expected.size()) << label;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found[k].first, expected[k].first, 1e-11 * std::abs(expected[k].first)) << label;
    EXPECT_NEAR(found[k].second, expected[k].second, 1e-11 * std::abs(expected[k].second)) << label;
  }
}

TEST(Plots, OfTheLine) {
  const Drawing gradient =
      drawn_by("oned gradient --field poly:1,0,1 --estimator standard,improved --pair W1 --n 10");
  expect_axes(gradient, "Estimated gradient of poly:1,0,1", "X [m]", "dx/dX");
  EXPECT_EQ(gradient.series.size(), 3u);
  expect_series(gradient, "exact", "X", "exact", {{"estimator", "standard"}});
  for (const std::string estimator : {"standard", "improved"})
    expect_series(gradient, estimator + " W1", "X", "value", {{"estimator", estimator}});
  const Drawing response = drawn_by("oned response --points 5");
  expect_axes(response, "Response inside a uniform lattice", "θ = k dx", "response");
  EXPECT_EQ(response.series.size(), 3u);
  expect_series(response, "exact", "theta", "theta", {{"estimator", "standard"}});
  for (const std::string estimator : {"standard", "improved"})
    expect_series(response, estimator + " W1", "theta", "value", {{"estimator", estimator}});
  const Drawing kernels = drawn_by("oned kernels --at 0 --n 20");
  expect_axes(kernels, "Kernels at x = 0 m, R = 1 m, dx = 0.25 m", "X_j [m]", "kernel [1/m]");
  for (const std::string name : {"W", "W0", "W1"}) expect_series(kernels, name, "x", name, json::object());
  EXPECT_EQ(kernels.series.size(), 6u);  // the curves between the particles, too
  const Drawing correction = drawn_by("oned correction --points 5");
  expect_axes(correction, "The first-order correction along the body", "x [m]", "correction");
  expect_series(correction, "alpha", "x", "alpha", json::object());
  expect_series(correction, "sum V W", "x", "VW", json::object());
  expect_series(correction, "negative share", "x", "negative", json::object());
  const Drawing radii = drawn_by("oned correction --points 5 --radius-over-dx 2,3");
  for (const double radius : {2.0, 3.0})
    expect_series(radii, "R/dx = " + std::to_string(static_cast<int>(radius)), "x", "alpha",
                  {{"radius_over_dx", radius}});
  const Drawing function = drawn_by("oned function --n 10 --field sin:1");
  expect_axes(function, "Estimated function of sin:1", "X [m]", "f");
  for (const std::string pair : {"none", "W0", "W1"})
    expect_series(function, pair, "X", "value", {{"pair", pair}});
  const Drawing study =
      drawn_by("oned study --n 10,20,40,80 --field poly:1,0,0,1 --estimator standard,improved");
  expect_axes(study, "Root mean square error of the estimated gradient of poly:1,0,0,1", "dx [m]", "RMSE");
  EXPECT_EQ(study.series.size(), 2u);
  for (const std::string estimator : {"standard", "improved"})
    expect_series(study, estimator + " W1", "dx", "rmse", {{"estimator", estimator}});
}

TEST(Plots, OfStudies) {
  const Drawing mms =
      drawn_by("mms " + studies +
               "swinging_plate.toml --set study.spacings=[0.5,0.4,0.25] --set study.quadrature=nodal");
  expect_axes(mms, "swinging plate: error at t = 0.04426 s", "spacing [m]", "relative error");
  EXPECT_EQ(mms.series.size(), 3u);
  for (const auto& [label, norm] :
       {std::pair("L2, nodal", "l2"), {"H1, nodal", "h1"}, {"max, nodal", "linf"}})
    expect_series(mms, label, "d", std::string("relative_") + norm, json::object(), "levels");
  const Drawing operators =
      drawn_by("operators " + studies +
               "operators.toml --set study.spacings=[0.1,0.0625] --set method.gradient=compatible");
  expect_axes(operators, "operators on the swinging plate: operators on the exact field", "spacing [m]",
              "relative error");
  for (const auto& [label, key] : {std::pair("F, inside", "f_inside"),
                                   {"Div P, boundary", "div_p_boundary"},
                                   {"Laplacian, inside", "laplacian_inside"},
                                   {"F, boundary", "f_boundary"}})
    expect_series(operators, label, "d", key, json::object(), "levels");
  const Drawing statics = drawn_by(
      "static " + studies + "static_plate.toml --set study.spacings=[0.5,0.4,0.25] --set study.name=plate");
  expect_axes(statics, "plate: error of the equilibrium", "spacing [m]", "relative error");
  for (const auto& [label, norm] :
       {std::pair("L2, nodal", "l2"), {"H1, nodal", "h1"}, {"max, nodal", "linf"}})
    expect_series(statics, label, "d", std::string("relative_") + norm, json::object(), "levels");
  const Drawing edges =
      drawn_by("stability " PLUMBLINE_SOURCE_DIR
               "/verification/stability/small-motion.toml --cache '' --set stability.values=[0.9,1.2] "
               "--set stability.tolerance=0.5");
  expect_axes(edges, "free plate: cfl over beta, small motion", "method.beta", "largest stable cfl");
  expect_series(edges, "verlet, standard", "x", "limit", {{"variant", "verlet, standard"}});
  const Drawing temporal =
      drawn_by("mms " PLUMBLINE_SOURCE_DIR "/tests/plumb/temporal_floor.toml --temporal");
  expect_axes(temporal, "temporal floor: error of the time steps at d = 0.25 m", "time step [s]",
              "L2 difference to the fine-step run [m^2]");
  EXPECT_EQ(temporal.series.size(), 3u);
  for (const auto& [label, points] : temporal.series) {
    const std::string integrator = label.substr(0, label.find(':'));
    expect_series(temporal, label, "dt", "l2", {{"integrator", integrator}});
  }
}

/// A body in the plane: a square for each particle, and the stress in the unit of its size.
TEST(Plots, OfABody) {
  const test::TemporaryFolder folder;
  const auto outcome = test::run_shell(
      "cd " + folder.path().string() +
      " && " PLUMB_EXECUTABLE " run " PLUMBLINE_SOURCE_DIR
      "/verification/scenes/swinging-plate.toml --quiet --set body.spacing=0.2 --out a --plot a.svg --csv a.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const std::string picture = test::content_of(folder / "a.svg"), table = test::content_of(folder / "a.csv");
  EXPECT_NE(picture.find("swinging plate at t = "), std::string::npos);
  EXPECT_NE(picture.find("von Mises stress [kPa]"), std::string::npos);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 11 * 11 + 1);
}

TEST(Plots, OfTablesAndPoints) {
  const Drawing judged = drawn_by("judge table.csv --expect 2,1");
  expect_axes(judged, "table.csv", "spacing", "error");
  EXPECT_EQ(judged.series.at("l2"), (Points{{0.4, 0.32}, {0.2, 0.08}, {0.1, 0.02}, {0.05, 0.005}}));  // sizes
  EXPECT_EQ(judged.series.at("h1"), (Points{{0.4, 4}, {0.2, 2}, {0.1, 1}, {0.05, 0.5}}));
  const Drawing point = drawn_by("material " PLUMBLINE_SOURCE_DIR "/verification/material/copper-cycle.toml");
  expect_axes(point, "j2-logarithmic at one point", "time [s]", "stress [Pa]");
  EXPECT_EQ(point.series.size(), 5u);
  expect_series(point, "q", "t", "q", json::object());
  for (const auto& [label, a, b] :
       {std::tuple("sigma_11", 0, 0), {"sigma_12", 0, 1}, {"sigma_22", 1, 1}, {"sigma_33", 2, 2}}) {
    const Points& found = point.series.at(label);
    ASSERT_EQ(found.size(), point.result["rows"].size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const json& row = point.result["rows"][k];
      EXPECT_NEAR(found[k].first, row["t"].get<double>(), 1e-11);
      const double stress = row["cauchy"][static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
      EXPECT_NEAR(found[k].second, stress, 1e-11 * std::abs(stress)) << label;
    }
  }
}

}  // namespace
}  // namespace plumb::plots_test
