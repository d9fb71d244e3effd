#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

const std::string column =
    "run " PLUMBLINE_SOURCE_DIR
    "/verification/scenes/bending-column.toml --set scene.max_steps=5 --set output.vtk=false "
    "--quiet --json - --out ";

TEST(RunBudget, IsWrittenWhenAskedForAndLeavesTheRunAsItIs) {
  const test::TemporaryFolder folder;
  const auto plain = test::run_plumb(column + (folder / "plain").string());
  const auto with = test::run_plumb(column + (folder / "with").string() + " --set output.budget=true");
  ASSERT_EQ(plain.code, 0) << plain.error;
  ASSERT_EQ(with.code, 0) << with.error;
  EXPECT_FALSE(std::filesystem::exists(folder / "plain" / "budget.csv"));
  const auto a = nlohmann::json::parse(plain.out), b = nlohmann::json::parse(with.out);
  EXPECT_EQ(a["energy"], b["energy"]);  // bit for bit
  EXPECT_EQ(a["linear_momentum"], b["linear_momentum"]);
  std::istringstream csv(test::content_of(folder / "with" / "budget.csv"));
  std::string line;
  std::getline(csv, line);
  for (const char* part : {"internal force: linear momentum x", "jst: energy", "supports: angular momentum z",
                           "integrator: energy", "gap of energy"})
    EXPECT_NE(line.find(part), std::string::npos) << part;
  int lines = 0;
  while (std::getline(csv, line)) ++lines;
  EXPECT_EQ(lines, 6);
}

}  // namespace
}  // namespace plumb
