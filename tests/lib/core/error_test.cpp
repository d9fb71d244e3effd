#include "lib/core/error.hpp"

#include <gtest/gtest.h>

namespace plumb {
namespace {

TEST(InputError, ReadsProblemWhySuggestion) {
  const InputError error("spacing is -0.1 m", "it must be positive", "give 0.1");
  EXPECT_STREQ(error.what(), "spacing is -0.1 m. It must be positive. Give 0.1.");
  EXPECT_STREQ(InputError("no body", "", "").what(), "no body.");
}

TEST(NearestName, FindsTheMisspeltOneAndNothingForNonsense) {
  const std::vector<std::string> names = {"cubic", "quintic", "wendland-c2"};
  EXPECT_EQ(nearest_name("cubik", names), "cubic");
  EXPECT_EQ(nearest_name("wendlandc2", names), "wendland-c2");
  EXPECT_EQ(nearest_name("zzzzzz", names), "");
  EXPECT_EQ(nearest_name("cubic", {}), "");
}

TEST(UnknownName, NamesAllValidOnesAndTheNearest) {
  const InputError error = unknown_name("kernel", "quintc", {"cubic", "quintic"});
  EXPECT_STREQ(error.what(), "unknown kernel \"quintc\". Valid: cubic, quintic. Did you mean \"quintic\"?");
}

}  // namespace
}  // namespace plumb
