#include "lib/output/series.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "lib/output/file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

TEST(CsvSeries, EveryLineIsInTheFileBeforeAppendReturns) {
  const test::TemporaryFolder folder;
  CsvSeries series(folder / "series.csv", {"time [s]", "x, y"});
  EXPECT_EQ(test::content_of(folder / "series.csv"), "time [s],\"x, y\"\n");
  series.append(std::array{0.0, 0.1});
  EXPECT_EQ(test::content_of(folder / "series.csv"), "time [s],\"x, y\"\n0,0.10000000000000001\n");
}

TEST(CsvSeries, RefusesALineOfAnotherLength) {
  const test::TemporaryFolder folder;
  CsvSeries series(folder / "series.csv", {"a", "b"});
  EXPECT_THROW(series.append(std::array{1.0}), std::invalid_argument);
  EXPECT_EQ(test::content_of(folder / "series.csv"), "a,b\n");
}

TEST(CsvSeries, AWriteThatFailsLeavesWholeLinesOnly) {
  const test::TemporaryFolder folder;
  CsvSeries series(folder / "series.csv", {"a"});
  // A limit of 10 bytes a file: "a\n", "1.5\n" fit, of the next line only 4 bytes do.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const rlimit small{10, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  series.append(std::array{1.5});
  EXPECT_THROW(series.append(std::array{1.0 / 3}), OutputError);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  EXPECT_EQ(test::content_of(folder / "series.csv"), "a\n1.5\n");
  series.append(std::array{2.5});
  EXPECT_EQ(test::content_of(folder / "series.csv"), "a\n1.5\n2.5\n");
}

TEST(CsvSeries, APlaceThatCannotBeWrittenIsAnOutputError) {
  EXPECT_THROW(CsvSeries("/no/such/folder/series.csv", {"a"}), OutputError);
  EXPECT_THROW(CsvSeries("/dev/full", {"a"}), OutputError);
}

}  // namespace
}  // namespace plumb
