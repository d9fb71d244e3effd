#include "lib/core/sentences.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

TEST(Sentences, EachPartEndsInAStopAndBeginsLarge) {
  EXPECT_EQ(sentences("spacing is -0.1 m", "it must be positive", "give 0.1"),
            "spacing is -0.1 m. It must be positive. Give 0.1.");
  EXPECT_EQ(sentences("no body", "", ""), "no body.");
  EXPECT_EQ(sentences("no body", "", "add one"), "no body. Add one.");
  EXPECT_EQ(sentences("x", "it is full.", "did you mean \"y\"?"), "x. It is full. Did you mean \"y\"?");
  EXPECT_EQ(sentences("", "", ""), "");
}

/// Formulas, names in quotes and numbers are not words.
TEST(Sentences, NamesAndFormulasKeepTheirLetters) {
  EXPECT_EQ(sentences("a", "x = 3 is outside", ""), "a. x = 3 is outside.");
  EXPECT_EQ(sentences("a", "valid: b, c", "[method] has it"), "a. Valid: b, c. [method] has it.");
  EXPECT_EQ(sentences("a", "2 values", "\"b\" is one"), "a. 2 values. \"b\" is one.");
  EXPECT_EQ(sentences("a", "end_time comes first", "n"), "a. end_time comes first. N.");
}

TEST(Sentences, TheMessageOfAnErrorIsMadeOfItsParts) {
  EXPECT_EQ(std::string(InputError("no kernel", "there is none", "name one").what()),
            "no kernel. There is none. Name one.");
  EXPECT_EQ(std::string(unknown_name("kernel", "quintc", {"cubic", "quintic"}).what()),
            "unknown kernel \"quintc\". Valid: cubic, quintic. Did you mean \"quintic\"?");
}

}  // namespace
}  // namespace plumb
