#include "reports/run/store.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "reports/report.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::TemporaryFolder;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// A program in place of plumb: counts its calls, writes the JSON it is asked for, ends with the code in the
/// file "code".
class StoreOfResults : public ::testing::Test {
 protected:
  void SetUp() override {
    write(folder / "program",
          "#!/bin/sh\necho x >> calls\nwhile [ $# -gt 0 ]; do [ \"$1\" = --json ] && echo '{\"value\": 7}' > "
          "\"$2\"; shift; "
          "done\necho last words >&2\n[ -f code ] && exit $(cat code)\nexit 0\n");
    fs::permissions(folder / "program", fs::perms::owner_all);
    write(folder / "scene.toml", "a = 1");
  }
  JobResult get(int threads = 0, const std::string& code = {}) const {
    return run::Store(folder / "store", folder / "program", folder.path(), threads, code)
        .get({"job", {"run", "scene.toml"}, {"scene.toml"}});
  }
  std::size_t calls() const { return fs::exists(folder / "calls") ? fs::file_size(folder / "calls") / 2 : 0; }
  TemporaryFolder folder;
};

TEST_F(StoreOfResults, UnchangedStudyIsReused) {
  const auto first = get();
  EXPECT_FALSE(first.reused);
  EXPECT_EQ(first.command, "plumb run scene.toml");
  const auto second = get();
  EXPECT_TRUE(second.reused);
  EXPECT_EQ(calls(), 1u);
  EXPECT_EQ(second.cpu_s, first.cpu_s);    // the cost is that of the run that was made
  EXPECT_GT(first.peak_rss.value(), 1e5);  // a shell has more than a tenth of a megabyte
  EXPECT_EQ(second.peak_rss, first.peak_rss);
  EXPECT_EQ(nlohmann::json::parse(run::content_of(second.folder / "result.json"))["value"], 7);
}

TEST_F(StoreOfResults, ChangedInputProgramOrThreadsMeansANewRun) {
  get();
  write(folder / "scene.toml", "a = 2");
  EXPECT_FALSE(get().reused);
  std::ofstream(folder / "program", std::ios::app) << "# another build\n";
  EXPECT_FALSE(get().reused);
  EXPECT_FALSE(get(2).reused);
  EXPECT_EQ(calls(), 4u);
}

TEST_F(StoreOfResults, NamedCodeCountsInPlaceOfTheProgram) {
  get(0, "code 1");
  std::ofstream(folder / "program", std::ios::app) << "# only the report changed\n";
  EXPECT_TRUE(get(0, "code 1").reused);
  EXPECT_FALSE(get(0, "code 2").reused);
  EXPECT_EQ(calls(), 2u);
}

TEST_F(StoreOfResults, TheReportLooksUpByTheCodeThatComputes) {
  ReportOptions options;
  options.out = folder / "out";
  options.program = folder / "program";
  options.root = folder.path();
  options.only = {"kernels"};
  options.code = "code 1";
  const auto first = make_report(options);
  EXPECT_EQ(first.reused, 0u);
  ASSERT_EQ(first.problems.size(),
            1u);  // the program's {"value": 7} is no result of kernels: said, and no crash
  std::ofstream(folder / "program", std::ios::app) << "# only the report changed\n";
  const auto second = make_report(options);
  EXPECT_EQ(second.reused, second.jobs);
  options.code = "code 2";
  EXPECT_EQ(make_report(options).reused, 0u);
}

TEST_F(StoreOfResults, FailedStudyIsSaidAndNotKept) {
  write(folder / "code", "2");
  const auto failed = get();
  EXPECT_NE(failed.failure.find("exit code 2: last words"), std::string::npos) << failed.failure;
  EXPECT_FALSE(get().reused);
  EXPECT_EQ(calls(), 2u);
  write(folder / "code", "1");  // a check failed: that is a result
  EXPECT_TRUE(get().failure.empty());
  EXPECT_TRUE(get().reused);
}

TEST_F(StoreOfResults, InterruptedStudyIsNotKept) {
  write(folder / "program",
        "#!/bin/sh\necho x >> calls\nwhile [ $# -gt 0 ]; do [ \"$1\" = --json ] && echo '{\"status\": "
        "\"interrupted\"}' > \"$2\"; shift; done\nexit 1\n");
  EXPECT_FALSE(get().failure.empty());
  EXPECT_FALSE(get().reused);
  EXPECT_EQ(calls(), 2u);
}

TEST_F(StoreOfResults, MissingInputIsSaid) {
  fs::remove(folder / "scene.toml");
  EXPECT_NE(get().failure.find("scene.toml"), std::string::npos);
  EXPECT_EQ(get().failure.back(), '.') << get().failure;
  EXPECT_EQ(calls(), 0u);
}

}  // namespace
