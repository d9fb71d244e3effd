#include "lib/actions/relaxation_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"

namespace plumb {

std::optional<RelaxationOptions> read_relaxation(const Section& root) {
  const auto section = root.optional_section({"relaxation", "the run ends when the body is at rest"});
  if (!section) return std::nullopt;
  RelaxationOptions relaxation;
  relaxation.residual = section->number_or(
      {"residual",
       "norm of the forces on free particles relative to that of loads and supports, at which the body is at rest"},
      relaxation.residual, quantity::number, Sign::positive);
  if (relaxation.residual >= 1)
    section->fail("residual", fmt::format("{:g} would call any state a rest", relaxation.residual),
                  "it is relative to the forces of loads and supports", "use a number below 1, say 1e-8");
  section->reject_unknown();
  return relaxation;
}

}  // namespace plumb
