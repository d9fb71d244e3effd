#include "reports/run/expected_times.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.hpp"

namespace {

using plumb::reports::run::ExpectedTimes;
using plumb::test::TemporaryFolder;

TEST(ExpectedTimes, TheShareDoneIsOneOfTimeAndNotOfStudies) {
  const TemporaryFolder folder;
  {
    ExpectedTimes first(folder / "times.json");
    first.plan({"short", "long"}, {});
    EXPECT_EQ(first.fraction(), 0);
    first.finished("short", 1.0);
    EXPECT_EQ(first.fraction(), 0.5) << "nothing is known yet: by numbers";
    first.finished("long", 99.0);
    EXPECT_EQ(first.fraction(), 1);
    first.save();
  }
  ExpectedTimes second(folder / "times.json");
  second.plan({"short", "long"}, {});
  second.finished("short", 3.0);
  EXPECT_DOUBLE_EQ(second.fraction(), 1.0 / 100);
  second.finished("short", 3.0);
  EXPECT_DOUBLE_EQ(second.fraction(), 1.0 / 100) << "counted once";
  second.finished("long", 99.0);
  EXPECT_DOUBLE_EQ(second.fraction(), 1);
}

TEST(ExpectedTimes, StoredStudiesCostNothingAndUnknownOnesTheMean) {
  const TemporaryFolder folder;
  std::ofstream(folder / "times.json") << R"({"a": 10, "b": 30})";
  ExpectedTimes times(folder / "times.json");
  times.plan({"a", "b", "new"}, {"a"});
  times.finished("a", 10.0);
  EXPECT_NEAR(times.fraction(), 0, 1e-3);
  times.finished("new", 5.0);
  EXPECT_NEAR(times.fraction(), 20.0 / 50, 1e-3) << "the mean of 10 and 30";
}

TEST(ExpectedTimes, AFailedStudyTeachesNothingAndADamagedFileIsNone) {
  const TemporaryFolder folder;
  std::ofstream(folder / "times.json") << R"({"a": 10, "b": )";
  ExpectedTimes times(folder / "times.json");
  times.plan({"a", "b"}, {});
  times.finished("a", std::nullopt);
  EXPECT_EQ(times.fraction(), 0.5);
  times.finished("b", 7.0);
  times.save();
  ExpectedTimes next(folder / "times.json");
  next.plan({"a", "b"}, {});
  next.finished("a", 1.0);
  EXPECT_EQ(next.fraction(), 0.5) << "a counts as the mean, which is b";
}

}  // namespace
