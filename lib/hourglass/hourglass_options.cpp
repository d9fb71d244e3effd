#include "plumbline/hourglass/hourglass_options.hpp"

#include "plumbline/input/section.hpp"

namespace plumb {

std::optional<HourglassOptions> read_hourglass(const Section& root) {
  const auto section = root.optional_section("hourglass");
  if (!section) return std::nullopt;
  HourglassOptions hourglass;
  hourglass.alpha = section->number_or("alpha", hourglass.alpha, quantity::number, Sign::not_negative);
  section->reject_unknown();
  if (hourglass.alpha == 0) return std::nullopt;
  return hourglass;
}

}  // namespace plumb
