#include "lib/output/progress.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(Progress, DurationsForPeople) {
  EXPECT_EQ(duration_text(0), "0.0 s");
  EXPECT_EQ(duration_text(1.24), "1.2 s");
  EXPECT_EQ(duration_text(59.6), "60 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(3599.7), "1 h 00 min");
  EXPECT_EQ(duration_text(2 * 3600 + 5 * 60), "2 h 05 min");
}

/// Half of what was missing in 10 s: the other half takes 10 s more, wherever the work began.
TEST(Progress, TimeLeftCountsFromWhereTheWorkBegan) {
  EXPECT_DOUBLE_EQ(seconds_left(10, 0.5, 0).value(), 10);
  EXPECT_DOUBLE_EQ(seconds_left(10, 0.9, 0.8).value(), 10);
  EXPECT_DOUBLE_EQ(seconds_left(3, 1, 0.5).value(), 0);
  EXPECT_FALSE(seconds_left(10, 0.8, 0.8)) << "no rate yet";
}

/// In the unit in which people read it: one per cent or more, if an hour brings as much.
TEST(Progress, RateHasAUnitThatFits) {
  EXPECT_EQ(rate_text(10, 0.5, 0), "5 %/s");
  EXPECT_EQ(rate_text(10, 0.75, 0.5), "2.5 %/s") << "only what was done in this sitting";
  EXPECT_EQ(rate_text(100, 0.5, 0), "30 %/min");
  EXPECT_EQ(rate_text(3600, 0.12, 0), "12 %/h");
  EXPECT_EQ(rate_text(0.5, 0.65, 0), "130 %/s") << "not 1.3e+02";
  EXPECT_EQ(rate_text(1, 0.0997, 0), "10 %/s");
  EXPECT_EQ(rate_text(10, 0.4, 0.4), "");
}

TEST(Progress, ShortWorkAndQuietWorkPrintNothing) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  for (const auto style : {Progress::Style::none, Progress::Style::lines, Progress::Style::bar}) {
    Progress progress("work", style, file);
    for (int k = 0; k <= 100; ++k) progress.update(k / 100.0);
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

}  // namespace
}  // namespace plumb
