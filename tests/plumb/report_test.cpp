#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_plumb;
namespace fs = std::filesystem;

TEST(Report, MakesOnePageWhoseLinksAllLead) {
  const test::TemporaryFolder folder;
  const auto outcome = run_plumb("report --quiet --only kernels,response --out " + folder.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const std::string page = test::content_of(folder / "index.html");
  const std::regex link("href=\"([^\"#:]+)\"");
  std::size_t links = 0;
  for (std::sregex_iterator m(page.begin(), page.end(), link), end; m != end; ++m, ++links)
    EXPECT_TRUE(fs::exists(folder / (*m)[1].str())) << (*m)[1];
  EXPECT_GT(links, 10u);
  EXPECT_NE(page.find("plumb oned kernels --at 0"), std::string::npos);
}

TEST(Report, SecondCallUsesStoredResults) {
  const test::TemporaryFolder folder;
  const std::string call = "report --quiet --only kernels --out " + folder.path().string() + " --json -";
  EXPECT_EQ(nlohmann::json::parse(run_plumb(call).out)["reused"], 0);
  const auto second = nlohmann::json::parse(run_plumb(call).out);
  EXPECT_EQ(second["reused"], second["studies"]);
}

TEST(Report, UnknownSectionNamesTheNearest) {
  const auto outcome = run_plumb("report --only kernel");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.error.find("kernels"), std::string::npos) << outcome.error;
}

}  // namespace
}  // namespace plumb
