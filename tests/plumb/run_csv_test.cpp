#include <gtest/gtest.h>

#include <sstream>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

TEST(RunCsv, HasOneRowAParticleOfTheLastState) {
  const test::TemporaryFolder folder;
  const auto outcome =
      test::run_plumb("run " PLUMBLINE_SOURCE_DIR
                      "/verification/scenes/spinning-plate.toml "
                      "--set body.particles=[6,6] --set scene.max_steps=2 --quiet --csv - --out " +
                      (folder / "out").string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  std::istringstream csv(outcome.out);
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line,
            "position x [m],position y [m],displacement x [m],displacement y [m],velocity x [m/s],velocity y "
            "[m/s],J,pressure [Pa],von Mises stress [Pa]");
  int rows = 0;
  while (std::getline(csv, line)) ++rows;
  EXPECT_EQ(rows, 36);
}

}  // namespace
}  // namespace plumb
