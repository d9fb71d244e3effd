// `plumb compare`: two runs on common times and points.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>

#include "lib/output/particles.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_shell;

/// u = (a X + b Y) t at n x n points of the unit square, at the times 0, dt, .. 1.
void write_run(const std::filesystem::path& folder, int n, double a, double b, double dt) {
  std::filesystem::create_directory(folder);
  ParticleSeries series(folder, "particles");
  for (double t = 0; t < 1 + 0.5 * dt; t += dt) {
    std::vector<double> x, u, v;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double X = (i + 0.5) / n, Y = (j + 0.5) / n, rate = a * X + b * Y;
        u.insert(u.end(), {rate * t, 0});
        v.insert(v.end(), {rate, 0});
        x.insert(x.end(), {X + rate * t, Y});
      }
    const std::vector<PointField> fields{{"displacement [m]", 2, u}, {"velocity [m/s]", 2, v}};
    series.write({t, 2, x, fields});
  }
}

nlohmann::json compare(const test::TemporaryFolder& folder, const std::string& options) {
  const auto outcome = run_shell("cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " compare " +
                                 options + " --json -");
  return nlohmann::json::parse(outcome.out);
}

TEST(Compare, ARunIsItself) {
  const test::TemporaryFolder folder;
  write_run(folder / "a", 5, 0.1, 0.2, 0.25);
  const auto result = compare(folder, "a a --within 0");
  EXPECT_EQ(result["status"], "pass");
  ASSERT_EQ(result["rows"].size(), 5u);
  for (const auto& row : result["rows"]) EXPECT_EQ(row["l2"], 0);
}

// The difference is known: 0.1 t X, root mean square over the points 0.1 t sqrt(mean X^2).
TEST(Compare, DifferencesAreThoseOfTheFields) {
  const test::TemporaryFolder folder;
  write_run(folder / "a", 10, 0.1, 0, 0.25);
  write_run(folder / "b", 10, 0.2, 0, 0.25);
  const auto result = compare(folder, "a b --within 0.9");
  EXPECT_EQ(result["status"], "fail");
  double square = 0;
  for (int i = 0; i < 10; ++i) square += std::pow((i + 0.5) / 10, 2) / 10;
  const auto last = result["rows"][4];
  EXPECT_NEAR(last["l2"].get<double>(), 0.1 * std::sqrt(square), 1e-12);
  EXPECT_NEAR(last["velocity_l2"].get<double>(), 0.1 * std::sqrt(square), 1e-12);
  EXPECT_NEAR(last["linf"].get<double>(), 0.095, 1e-12);
  EXPECT_NEAR(result["largest_relative_l2"].get<double>(), 1, 1e-12);
}

// A field that is linear in space and time is the same on other points and times.
TEST(Compare, OtherPointsAndTimesAreInterpolated) {
  const test::TemporaryFolder folder;
  write_run(folder / "a", 6, 0.1, 0.3, 0.25);
  write_run(folder / "b", 11, 0.1, 0.3, 0.4);
  const auto result = compare(folder, "a b");
  ASSERT_EQ(result["rows"].size(), 4u);  // 1 lies beyond the last instant of b, 0.8
  for (const auto& row : result["rows"]) {
    EXPECT_LT(row["linf"].get<double>(), 1e-12);
    EXPECT_EQ(row["points"], 36);
    EXPECT_FALSE(row["same_points"].get<bool>());
  }
  EXPECT_TRUE(result["rows"][1]["interpolated_in_time"].get<bool>());
}

TEST(Compare, FilesOfOtherPrograms) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "a.csv") << "x,y,ux,uy\n0,0,0,0\n1,0,1,0\n0,1,0,0\n";
  std::ofstream(folder / "b.csv") << "x,y,ux,uy\n0,0,0,0\n1,0,1,3e-3\n0,1,0,0\n";
  const auto result = compare(folder, "a.csv b.csv");
  EXPECT_NEAR(result["rows"][0]["linf"].get<double>(), 3e-3, 1e-15);
  EXPECT_TRUE(result["rows"][0]["time"].is_null());
}

TEST(Compare, WhatCannotBeComparedIsRefused) {
  const test::TemporaryFolder folder;
  write_run(folder / "a", 3, 0.1, 0.2, 0.5);
  std::filesystem::create_directory(folder / "empty");
  const auto code = [&](const std::string& options) {
    return run_shell("cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " compare " + options).code;
  };
  EXPECT_EQ(code("a empty"), 2);
  EXPECT_EQ(code("a nowhere"), 2);
  EXPECT_EQ(code("a"), 2);
  EXPECT_EQ(code("a a --within -1"), 2);
}

}  // namespace
}  // namespace plumb
