#include "plumbline/output/progress.hpp"

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
