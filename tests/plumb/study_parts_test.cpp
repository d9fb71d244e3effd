// Sections of a scene in a study: what they do there is what they do.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;

/// The error of a jittered plate in that study, with a further section.
double error_with(const std::string& section, const std::string& momentum) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "study.toml")
      << test::content_of(PLUMBLINE_SOURCE_DIR "/verification/studies/swinging_plate.toml") << section;
  const auto outcome =
      test::run_plumb("mms " + (folder / "study.toml").string() +
                      " --set study.spacings=[0.5] --set study.periods=0.1 --set study.force=finite-strain "
                      "--set body.jitter=0.2"
                      " --set jst.eta4=0 --set method.integrator=verlet --set method.momentum=" +
                      momentum + " --threads 1 --quiet --json -");
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["levels"].size(), 1u) << outcome.error;
  return result["levels"][0]["l2"];
}

/// A force that derives from an energy has no torque: there is nothing to take from it. The paper's force has
/// one.
TEST(StudyParts, AProjectionTakesTheTorqueOfForcesThatHaveOne) {
  const double adjoint = error_with("", "adjoint"), symmetrised = error_with("", "symmetrised");
  EXPECT_NEAR(error_with("[projection]\n", "adjoint"), adjoint,
              1e-10 * adjoint);  // round-off of some ten steps
  EXPECT_GT(std::abs(error_with("[projection]\n", "symmetrised") - symmetrised), 1e-3 * symmetrised);
}

/// A section that scales with a number, at zero and at a number.
TEST(StudyParts, DissipationSpringsAndDampingAct) {
  const double plain = error_with("", "adjoint");
  EXPECT_DOUBLE_EQ(error_with("[hourglass]\nalpha = 0\n", "adjoint"), plain);
  EXPECT_GT(std::abs(error_with("[hourglass]\nalpha = 1\n", "adjoint") - plain), 1e-3 * plain);
  EXPECT_GT(std::abs(error_with("[damping]\nrate = 20\n", "adjoint") - plain), 1e-3 * plain);
}

}  // namespace
}  // namespace plumb
