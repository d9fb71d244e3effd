#include "mms/check.hpp"

#include <gtest/gtest.h>

#include "mms/manufactured.hpp"

namespace plumb::mms {
namespace {

// Two derivations, every solution, every material, 1000 random points, times, parameters and elastic
// constants.
TEST(SolutionCheck, BothDerivationsAgreeForTheWholeCatalogue) {
  const std::vector<SolutionEntry> entries = solution_list();
  EXPECT_GE(entries.size(), 14u);
  for (const SolutionEntry& entry : entries) {
    const std::vector<SolutionCheck> checks = check_solution(entry.name);
    EXPECT_GE(checks.size(), entry.dimensions.size());
    for (const SolutionCheck& check : checks) {
      EXPECT_TRUE(check.passed) << check.solution << " " << check.dimension << "D " << check.material;
      RecordProperty(check.solution + std::to_string(check.dimension) + "_force",
                     std::to_string(check.force));
      EXPECT_LE(check.force, check_tolerance);
      EXPECT_LE(check.traction, check_tolerance);
      EXPECT_LE(check.velocity, check_tolerance);
    }
  }
}

TEST(SolutionCheck, UnknownNameIsRefused) {
  EXPECT_THROW(check_solution("swinging-plat"), InputError);
}

}  // namespace
}  // namespace plumb::mms
