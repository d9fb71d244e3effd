#include "lib/schemes/implicit/implicit_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/input/section.hpp"

namespace plumb {
namespace {

std::vector<std::string> read_misprints(const Section& section) {
  const std::vector<std::string> known{"27", "29", "61"};
  if (!section.has("misprints")) return {};
  auto chosen =
      section.texts({"misprints", "equations of paper 004 that are taken as they are printed"}, known);
  for (const std::string& equation : chosen)
    if (std::find(known.begin(), known.end(), equation) == known.end())
      section.fail("misprints", fmt::format("there is none of ({})", equation),
                   "the others are right, or cannot be computed", "valid: \"27\", \"29\", \"61\"");
  return chosen;
}

void refuse_beside_arc_length(const Section& section, const ImplicitOptions& options) {
  if (options.moves())
    section.fail("arc_length", "contradicts dynamics", "it follows equilibria, without time",
                 "leave one of them out");
  if (options.time_step)
    section.fail("time_step", "contradicts arc_length", "steps are as long as that says",
                 "give the number of steps");
  if (options.solver == LinearSolver::iterative)
    section.fail("solver", "\"iterative\" contradicts arc_length",
                 "conjugate gradients need a positive tangent, which there is not behind a limit point",
                 "use solver = \"direct\"");
}

}  // namespace

ImplicitOptions ImplicitOptions::read(const Section& section) {
  ImplicitOptions options;
  options.time_step = section.optional_number({"time_step", "length of the steps, instead of their number"},
                                              quantity::time, Sign::positive);
  if (options.time_step && section.has("steps"))
    section.fail("steps", "contradicts time_step", "the steps to the end time follow from their length",
                 "leave one of them out");
  options.steps = section.integer_or({"steps", "load steps to the end time"}, options.steps, 1);
  options.adaptive = section.flag_or(
      {"adaptive", "steps are halved on failure, and grow where Newton's method is quick"}, options.adaptive);
  options.arc_length = section.optional_number(
      {"arc_length",
       "steps move the particles by that, root mean square, and the size of the loads is found"},
      quantity::length, Sign::positive);
  options.tolerance = section.number_or({"tolerance", "residual relative to the forces"}, options.tolerance,
                                        quantity::number, Sign::positive);
  if (options.tolerance >= 1)
    section.fail("tolerance", fmt::format("{:g} is no tolerance", options.tolerance),
                 "it is a share of the forces", "give a number below 1, such as 1e-10");
  if (section.choice_or({"solver", "of the linear systems: factors of the tangent, or conjugate gradients"},
                        "direct", {"direct", "iterative"}) == "iterative")
    options.solver = LinearSolver::iterative;
  const std::string dynamics =
      section.choice_or({"dynamics", "none: equilibria; else the rule of steps in time"}, "none",
                        {"none", "midpoint", "energy-momentum", "trapezoid"});
  options.midpoint = dynamics == "midpoint";
  options.trapezoid = dynamics == "trapezoid";
  options.energy_momentum = dynamics == "energy-momentum";
  if (options.energy_momentum && options.solver == LinearSolver::iterative)
    section.fail("solver", "\"iterative\" contradicts dynamics = \"energy-momentum\"",
                 "its tangent is not symmetric, and conjugate gradients need that",
                 "use solver = \"direct\", or dynamics = \"midpoint\"");
  if (options.arc_length) refuse_beside_arc_length(section, options);
  options.misprints = read_misprints(section);
  section.reject_unknown();
  return options;
}

std::string ImplicitOptions::in_words() const {
  std::string text = steps_in_words();
  for (const std::string& equation : misprints)
    text += fmt::format(", ({}) of paper 004 as printed", equation);
  return text;
}

std::string ImplicitOptions::steps_in_words() const {
  const std::string size = time_step ? fmt::format("steps of {:g} s", *time_step)
                                     : fmt::format("{} step{}", steps, steps == 1 ? "" : "s");
  if (moves())
    return fmt::format("{}, {}, residual {:g} of the forces",
                       midpoint    ? "implicit midpoint rule"
                       : trapezoid ? "trapezoidal rule"
                                   : "energy-momentum rule",
                       size, tolerance);
  if (arc_length)
    return fmt::format(
        "equilibria on a path of loads that may fall, {} of {:g} m, residual {:g} of the forces", size,
        *arc_length, tolerance);
  return fmt::format("equilibrium by Newton's method, {}{}, residual {:g} of the forces{}", size,
                     adaptive ? " (halved and grown as needed)" : "", tolerance,
                     solver == LinearSolver::iterative ? ", conjugate gradients" : "");
}

double ImplicitOptions::first_step(double end_time) const {
  return time_step ? std::min(1.0, *time_step / end_time) : 1.0 / static_cast<double>(steps);
}

}  // namespace plumb
