#include "lib/output/particles.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;

/// What VTK's vtkXMLPolyDataReader finds in the series (Debian's Python has the module, python3-vtk9).
json read_back(const ParticleSeries& series) {
  const auto outcome =
      test::run_shell("/usr/bin/python3 " PLUMBLINE_SOURCE_DIR "/tests/lib/output/read_back.py " +
                      series.index_file().string());
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  return outcome.code == 0 ? json::parse(outcome.out) : json::array();
}

TEST(Particles, VtkReadsBackThreeDimensions) {
  const test::TemporaryFolder folder;
  ParticleSeries series(folder.path(), "column");
  const std::array positions{0.1, 0.2, 0.3, 1.0 / 3, -1e-300, 1e300};
  const std::array stress{std::numbers::pi, 17e6};
  const std::array velocity{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const std::array<PointField, 2> fields{
      {{"von Mises [Pa] <&>", 1, stress}, {"velocity [m/s]", 3, velocity}}};
  series.write({0.0, 3, positions, fields});
  series.write({0.1, 3, velocity, {}});

  const json frames = read_back(series);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0]["time"], 0.0);
  EXPECT_EQ(frames[1]["time"], 0.1);
  EXPECT_EQ(frames[1]["field_time"], 0.1);
  // Every number must come back bit for bit: the arrays are binary.
  EXPECT_EQ(frames[0]["points"], json({{0.1, 0.2, 0.3}, {1.0 / 3, -1e-300, 1e300}}));
  EXPECT_EQ(frames[0]["verts"], 2);
  EXPECT_EQ(frames[0]["arrays"]["id"], json({{0.0}, {1.0}}));
  EXPECT_EQ(frames[0]["arrays"]["von Mises [Pa] <&>"], json({{std::numbers::pi}, {17e6}}));
  EXPECT_EQ(frames[0]["arrays"]["velocity [m/s]"], json({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
  EXPECT_EQ(frames[1]["points"], json({{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
}

TEST(Particles, PlaneVectorsGetAZero) {
  const test::TemporaryFolder folder;
  ParticleSeries series(folder.path(), "plate");
  const std::array positions{0.5, 1.5, 2.5, 3.5, 4.5, 5.5};
  const std::array<PointField, 1> fields{{{"displacement [m]", 2, positions}}};
  series.write({0.25, 2, positions, fields});
  const json frames = read_back(series);
  ASSERT_EQ(frames.size(), 1U);
  const json expected{{0.5, 1.5, 0.0}, {2.5, 3.5, 0.0}, {4.5, 5.5, 0.0}};
  EXPECT_EQ(frames[0]["points"], expected);
  EXPECT_EQ(frames[0]["arrays"]["displacement [m]"], expected);
}

TEST(Particles, EveryLengthOfDataSurvivesTheEncoding) {
  // 8 bytes of length and 24 n of data: all three remainders modulo 3 occur for scalars with n = 1, 2, 3.
  for (const std::size_t count : {1U, 2U, 3U, 1000U}) {
    const test::TemporaryFolder folder;
    ParticleSeries series(folder.path(), "line");
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i) x[i] = 0.1 * static_cast<double>(i) + 0.01;
    const std::array<PointField, 1> fields{{{"x", 1, x}}};
    series.write({0, 1, x, fields});
    const json frames = read_back(series);
    ASSERT_EQ(frames.size(), 1U);
    ASSERT_EQ(frames[0]["points"].size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(frames[0]["points"][i], json({x[i], 0.0, 0.0}));
      EXPECT_EQ(frames[0]["arrays"]["x"][i], json({x[i]}));
    }
  }
}

TEST(Particles, AFieldOfTheWrongSizeIsRefusedBeforeAnythingIsWritten) {
  const test::TemporaryFolder folder;
  ParticleSeries series(folder.path(), "bad");
  const std::array positions{0.0, 1.0, 2.0, 3.0};
  const std::array<PointField, 1> fields{{{"J", 1, positions}}};
  EXPECT_THROW(series.write({0, 2, positions, fields}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Particles, AContinuedSeriesRemovesItsLaterFilesAndAClearedOneAllOfThem) {
  const test::TemporaryFolder folder;
  const std::array positions{0.0, 1.0};
  ParticleSeries series(folder.path(), "run");
  for (int k = 0; k < 4; ++k) series.write({0.5 * k, 2, positions, {}});
  series.flush();
  series.finish();
  for (const char* name : {"run_1.vtp", "run_00000x.vtp", "runs_000003.vtp"})
    std::ofstream(folder / name) << "x";
  ParticleSeries again(folder.path(), "run");
  again.resume({0, 0.5});
  const auto has = [&](const char* name) { return std::filesystem::exists(folder / name); };
  EXPECT_TRUE(has("run_000001.vtp"));
  EXPECT_FALSE(has("run_000002.vtp"));
  EXPECT_FALSE(has("run_000003.vtp"));
  EXPECT_EQ(read_back(again).size(), 2U);
  std::ofstream(folder / "run_000001.vtp").close();  // empty
  EXPECT_THROW(ParticleSeries(folder.path(), "run").resume({0, 0.5}), InputError);
  again.clear();
  for (const char* gone : {"run.pvd", "run_000000.vtp", "run_000001.vtp"}) EXPECT_FALSE(has(gone)) << gone;
  for (const char* kept : {"run_1.vtp", "run_00000x.vtp", "runs_000003.vtp"}) EXPECT_TRUE(has(kept)) << kept;
}

TEST(Particles, AfterAFailedWriteTheIndexStillListsTheFilesThatExist) {
  const test::TemporaryFolder folder;
  ParticleSeries series(folder.path(), "run");
  const std::array positions{0.0, 1.0};
  series.write({0, 2, positions, {}});
  // A folder of the next file's name: the rename fails, as it would where the disk is full.
  std::filesystem::create_directories(folder / "run_000001.vtp/occupied");
  EXPECT_THROW(series.write({1, 2, positions, {}}), OutputError);
  EXPECT_EQ(read_back(series).size(), 1U);
  EXPECT_EQ(series.size(), 1U);
}

}  // namespace
}  // namespace plumb
