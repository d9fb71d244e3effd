// Long studies tell how far they are, also inside their longest run.
#include <gtest/gtest.h>

#include <algorithm>

#include "mms/temporal.hpp"
#include "mms/work_precision.hpp"
#include "places.hpp"

namespace plumb::mms {
namespace {

struct Told {
  std::vector<double> fractions;
  std::vector<std::string> notes;
  StudyProgress listener() {
    return [this](double fraction, const std::string& note) {
      fractions.push_back(fraction);
      notes.push_back(note);
    };
  }
  bool rises_to_one() const {
    return std::is_sorted(fractions.begin(), fractions.end()) && fractions.back() > 1 - 1e-12;
  }
};

Study plate(const std::string& spacings) {
  return read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/swinging_plate_finite_strain.toml",
                    {"study.spacings=" + spacings, "study.periods=0.05", "study.quadrature=nodal"});
}

/// Two integrators and (30) as printed with six steps each, and the reference: 19 runs. The work that was
/// announced is the work of all of them, or the end is not at 1.
TEST(Progress, OfTimeSteps) {
  Told told;
  Sitting sitting;
  run_temporal(plate("[0.5]"), told.listener(), sitting);
  EXPECT_GE(told.fractions.size(), 19u);
  EXPECT_TRUE(told.rises_to_one());
  EXPECT_LT(told.fractions.end()[-2], 1);
  EXPECT_NE(told.notes.front().find("rk3, "), std::string::npos) << told.notes.front();
}

TEST(Progress, OfWorkAndPrecision) {
  Told told;
  Sitting sitting;
  work_precision({{"one", plate("[0.5,0.25]")}, {"other", plate("[0.5]")}}, 2, {}, told.listener(), sitting);
  EXPECT_GE(told.fractions.size(), 3u * 3u);  // three turns of three levels
  EXPECT_TRUE(told.rises_to_one());
  EXPECT_LT(told.fractions.end()[-2], 1);
}

/// The finest level of a study is most of its work: the listener hears of it before it ends, with the rate.
TEST(Progress, InsideALevel) {
  Told told;
  Sitting sitting;
  Study study = plate("[0.2,0.05]");
  study.periods = 1;
  run_study(study, told.listener(), sitting);
  EXPECT_TRUE(told.rises_to_one());
  const auto inside = std::count_if(told.fractions.begin(), told.fractions.end(),
                                    [](double fraction) { return fraction > 0.1 && fraction < 0.99; });
  EXPECT_GE(inside, 1);
  EXPECT_NE(told.notes.back().find("pair evaluations/s"), std::string::npos) << told.notes.back();
}

}  // namespace
}  // namespace plumb::mms
