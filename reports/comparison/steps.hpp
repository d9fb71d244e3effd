#pragma once
#include <optional>
#include <string>

#include "reports/comparison/outcome.hpp"

/// The largest stable step of a scheme, by runs with CFL numbers from small to large.
namespace plumb::reports::comparison {

/// What was found for a scheme.
struct LargestStep {
  std::optional<double> cfl;   ///< the largest that is stable, as all smaller ones are; absent: none is
  std::optional<double> step;  ///< of that run [s]
  bool at_least = false;       ///< all are stable
  std::string next;            ///< what the next larger one does, or why nothing was run
};

/// The calls for a scheme, one for each CFL number; none where the table says that it cannot.
std::vector<Job> jobs_of(const StepLadder& ladder, const Scheme& scheme);

/// Reads them. Throws MissingResult.
LargestStep largest_step(const Results& results, const StepLadder& ladder, const Scheme& scheme);

}  // namespace plumb::reports::comparison
