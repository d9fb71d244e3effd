// Static plate by the operator of paper 004: errors that tests/reference/static_plate.py has, which shares no code with this program.
#include <gtest/gtest.h>

#include "lib/scene/study.hpp"
#include "mms/static_study.hpp"
#include "places.hpp"

namespace plumb::mms {
namespace {

/// Relative error of u on a lattice of 0.2 m with supports of 2.05 spacings.
double error_of_plate(const std::vector<std::string>& more) {
  std::vector<std::string> set{"body.jitter=0",
                               "study.spacings=[0.2]",
                               "study.parameters.amplitude=0.01",
                               "material.model=linear-elastic",
                               "method.kernel=quintic",
                               "method.beta=0.6833333333333333"};
  set.insert(set.end(), more.begin(), more.end());
  const auto study = read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/static_plate.toml", set);
  return run_static_study(study).levels.at(0).relative(&ErrorNorms::l2);
}

double error_of_dual_supports(const std::string& alpha) {
  return error_of_plate({"method.paper=004", "method.scheme=tlsph", "method.pair=none",
                         "method.gradient=standard", "hourglass.alpha=" + alpha});
}

TEST(StaticValues, ThePlateOfPaper004) {
  // displacements of a hundredth leave rounding of 1e-14 in F
  EXPECT_NEAR(error_of_dual_supports("0"), 0.07048283517260, 1e-13);
  EXPECT_NEAR(error_of_dual_supports("1"), 0.02923291825550, 1e-13);
}

}  // namespace
}  // namespace plumb::mms
