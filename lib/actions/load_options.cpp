#include "lib/actions/load_options.hpp"

#include <algorithm>

#include "lib/input/section.hpp"

namespace plumb {

std::optional<LoadOptions> read_load(const Section& root, int dimension) {
  const auto section = root.optional_section({"load", "forces on all particles"});
  if (!section) return std::nullopt;
  LoadOptions load;
  if (section->has("gravity"))
    load.gravity = section->formulas({"gravity", "force per mass, formulas of X, Y, Z, t"}, dimension,
                                     quantity::acceleration, Variables::space_and_time);
  if (section->has("body_force"))
    load.body_force = section->formulas({"body_force", "force per reference volume, formulas of X, Y, Z, t"},
                                        dimension, quantity::force_per_volume, Variables::space_and_time);
  load.ramp =
      section->optional_number({"ramp", "the loads grow smoothly from 0 to their values in this time"},
                               quantity::time, Sign::positive);
  section->reject_unknown();
  if (load.gravity.empty() && load.body_force.empty())
    section->fail("", "missing key gravity or body_force", "the section is there but loads nothing",
                  "leave out [load] for a body without loads");
  return load;
}

double ramp_share(const std::optional<double>& ramp, double time) {
  if (!ramp) return 1;
  const double s = std::clamp(time / *ramp, 0.0, 1.0);
  return s * s * s * (10 - s * (15 - 6 * s));
}

}  // namespace plumb
