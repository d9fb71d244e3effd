#include "lib/convergence/status.hpp"

#include <gtest/gtest.h>

#include "lib/convergence/verdict.hpp"
#include "lib/convergence/words.hpp"

namespace plumb {
namespace {

TEST(Outcome, OnlyWhatWasDeclaredCounts) {
  EXPECT_EQ(status_of({{"pass"}, {"divergent", false}}), "pass");
  EXPECT_EQ(status_of({{"pass"}, {"pass"}}), "pass");
  EXPECT_EQ(status_of({{"pass"}, {"fail"}, {"above"}}), "fail");
  EXPECT_EQ(status_of({{"pass"}, {"not-computed"}}), "fail");
  for (const char* word : {"above", "not-asymptotic", "noise-floor", "too-few-levels", "inconclusive"})
    EXPECT_EQ(status_of({{"pass"}, {word}}), "inconclusive") << word;
}

TEST(Outcome, WithoutADeclarationGrowthAndTooFewLevelsAreSaid) {
  EXPECT_EQ(status_of({}), "undeclared");
  EXPECT_EQ(status_of({{"asymptotic", false}, {"stalled", false}, {"noise-floor", false}}), "undeclared");
  EXPECT_EQ(status_of({{"asymptotic", false}, {"divergent", false}, {"too-few-levels", false}}), "divergent");
  EXPECT_EQ(status_of({{"asymptotic", false}, {"too-few-levels", false}}), "too-few-levels");
}

TEST(Outcome, OneRuleForExitCodes) {
  EXPECT_EQ(exit_code_of("pass"), 0);
  EXPECT_EQ(exit_code_of("undeclared"), 0);
  for (const char* status : {"fail", "inconclusive", "divergent", "too-few-levels", "above", ""})
    EXPECT_EQ(exit_code_of(status), 1) << status;
}

TEST(Words, EveryVerdictAndTrendIsExplainedOnce) {
  for (const Verdict verdict : {Verdict::pass, Verdict::fail, Verdict::above, Verdict::not_asymptotic,
                                Verdict::noise_floor, Verdict::too_few_levels, Verdict::inconclusive})
    EXPECT_FALSE(meaning_of(name_of(verdict)).empty()) << name_of(verdict);
  for (const Trend trend : {Trend::asymptotic, Trend::not_asymptotic, Trend::noise_floor, Trend::stalled,
                            Trend::divergent, Trend::too_few_levels})
    EXPECT_FALSE(meaning_of(name_of(trend)).empty()) << name_of(trend);
  for (const VerdictWord& one : verdict_words) {
    EXPECT_EQ(meaning_of(one.word), one.meaning);  // the first of its name: none is there twice
    EXPECT_TRUE(one.meaning.ends_with('.')) << one.word;
  }
  EXPECT_TRUE(meaning_of("no-such-word").empty());
}

}  // namespace
}  // namespace plumb
