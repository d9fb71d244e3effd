// A study that is ended keeps its finished parts, and the next sitting makes only the others.
#include "lib/output/sitting.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using Json = Sitting::Json;

class Sittings : public testing::Test {
 protected:
  /// Parts 0 .. 3 with the value 1/(3 + n); the sitting is to end before part `end`.
  std::vector<double> parts(Sitting& sitting, int end) {
    std::vector<double> values;
    at_ = 0;
    end_ = end;
    for (; at_ < 4; ++at_)
      values.push_back(sitting.part("part " + std::to_string(at_), [this] {
        ++made_;
        return Json{{"value", 1.0 / (3 + at_)}, {"broken", NAN}};
      })["value"]);
    return values;
  }
  Sitting sitting(const std::string& content = "a study") {
    return {folder_ / "kept", content, [this] { return at_ < end_; }};
  }
  void SetUp() override {
    Sitting first = sitting();
    EXPECT_THROW(parts(first, 2), SittingEnded);
    EXPECT_EQ(made_, 2);
  }
  fs::path file() const { return *fs::directory_iterator(folder_ / "kept"); }

  test::TemporaryFolder folder_;
  int made_ = 0, at_ = 0, end_ = 0;
};

TEST_F(Sittings, OnlyWhatIsMissingIsMade) {
  Sitting next = sitting();
  EXPECT_EQ(parts(next, 9), (std::vector{1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6}));  // to the last bit
  EXPECT_EQ(made_, 4);
  EXPECT_EQ(next.recalled(), 2);
  next.close();
  EXPECT_FALSE(fs::exists(folder_ / "kept")) << "a whole study leaves nothing behind";
}

TEST_F(Sittings, NothingIsToldOfAnUnknownAmountOfWork) {
  Sitting next = sitting("another study");  // parts that are recalled would take their work off
  int told = 0;
  next.tell(
      0, [&told](double, const std::string&) { ++told; }, "steps");
  parts(next, 9);
  EXPECT_EQ(made_, 2 + 4);
  EXPECT_EQ(told, 0);
}

TEST_F(Sittings, PartsOfAnotherStudyAreNotTaken) {
  Sitting other = sitting("another study");
  parts(other, 9);
  EXPECT_EQ(made_, 2 + 4);
  other.close();
  EXPECT_TRUE(fs::exists(file())) << "what the first one kept is not the other's to remove";
}

TEST_F(Sittings, DamagedPartsAreMadeAgain) {
  fs::resize_file(file(), fs::file_size(file()) / 2);
  Sitting next = sitting();
  EXPECT_EQ(parts(next, 9).size(), 4u);
  EXPECT_EQ(next.recalled(), 0);
}

TEST_F(Sittings, WhatIsKeptIsSaid) {
  Sitting next = sitting();
  try {
    parts(next, 3);
    FAIL();
  } catch (const SittingEnded& ended) {
    EXPECT_NE(std::string(ended.what()).find("3 finished parts are kept in " + file().string()),
              std::string::npos)
        << ended.what();
  }
}

TEST_F(Sittings, WhatCannotBeKeptIsSaid) {
  std::ofstream(folder_ / "no folder") << "a file";
  Sitting lost(folder_ / "no folder", "a study", [this] { return at_ < end_; });
  try {
    parts(lost, 2);
    FAIL();
  } catch (const SittingEnded& ended) {
    EXPECT_NE(std::string(ended.what()).find("what was finished is lost"), std::string::npos) << ended.what();
  }
}

TEST_F(Sittings, NumbersThatAreNotFiniteAreNaN) {
  Sitting next = sitting();
  const Json part = next.part("part 0", [] { return Json(); });
  EXPECT_TRUE(std::isnan(number_or_nan(part["broken"])));
  EXPECT_EQ(number_or_nan(part["value"]), 1.0 / 3);
}

/// Two of the parts of work 1 are there: of the rest, a part of work 1 and one of work 3, each quarter is
/// told.
TEST_F(Sittings, TheListenerIsToldOfThisSittingsWork) {
  Sitting next = sitting();
  std::vector<double> told;
  std::string last;
  end_ = 9;
  next.tell(
      1 + 1 + 1 + 3,
      [&](double fraction, const std::string& note) {
        told.push_back(fraction);
        last = note;
      },
      "steps");
  for (at_ = 0; at_ < 4; ++at_)
    next.part(
        "part " + std::to_string(at_),
        [&] {
          if (at_ != 3) return Json();
          next.check(2.0 / 3, 12);
          std::this_thread::sleep_for(std::chrono::milliseconds(60));  // longer than at_most_silent
          next.check(1.0 / 3, 12);                                     // a second run of the same part
          EXPECT_EQ(last, "part 3, 12 steps/s");
          return Json();
        },
        at_ == 3 ? 3 : 1);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  told.erase(std::unique(told.begin(), told.end()),
             told.end());  // on a slow machine the first check() tells too
  EXPECT_EQ(told, (std::vector{0.25, 0.75, 1.0}));
}

TEST(Sitting, WithoutAFolderNothingIsKeptAndNothingEnds) {
  Sitting whole;
  EXPECT_EQ(whole.part("one", [] { return Json(7); }), 7);
  EXPECT_NO_THROW(whole.check());
  EXPECT_NO_THROW(whole.close());
}

}  // namespace
}  // namespace plumb
