#include "lib/schemes/mixed/mixed_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"

namespace plumb {

MixedOptions MixedOptions::read(const Section& section, MixedOptions o) {
  o.volumes =
      section.choice_or({"volumes", "weights in the kernel sums: equal, or tributary as (41) has them"},
                        o.volumes, {"equal", "tributary"});
  o.gradient = section.choice_or(
      {"gradient", "corrected: the paper's kernel sums; compatible: bonds that converge on clouds, too"},
      o.gradient, {"corrected", "compatible"});
  o.kinematics = section.choice_or(
      {"kinematics", "tied: H = cof F, J = det F; evolved: unknowns of their own, (55), (56)"}, o.kinematics,
      {"tied", "evolved"});
  o.upwind = section.choice_or({"upwind", "dissipation between pairs; reconstructed is the paper's"},
                               o.upwind, {"none", "constant", "reconstructed", "adjoint"});
  o.diffuses_J = section.flag_or(
      {"diffuses_J",
       "D^j of (60): J goes from pair to pair by the jump of its conjugate; the paper leaves it out"},
      o.diffuses_J);
  if (o.diffuses_J && !o.evolves_HJ())
    section.fail("diffuses_J", "contradicts kinematics = \"tied\"", "J is then the determinant of F",
                 "set kinematics = \"evolved\", or leave it out");
  const long option = section.integer_or(
      {"option", "0: the reference is never updated; 1 to 4: kernels of (49) to (52)"}, o.option, 0);
  if (option > 4)
    section.fail("option", fmt::format("there is no option {}", option),
                 "0 keeps the reference, 1 to 4 are those of the paper", "give 0, 1, 2, 3 or 4");
  o.option = static_cast<int>(option);
  o.update_every = section.integer_or(
      {"update_every", "steps between updates of the reference, if option is not 0"}, o.update_every, 1);
  o.smooth_positions =
      section.flag_or({"smooth_positions", "particles move with the smoothed velocity"}, o.smooth_positions);
  if (o.diffuses_J && o.option > 0)
    section.fail("diffuses_J", fmt::format("contradicts option = {}", o.option),
                 "it is written for the reference at rest", "leave one of them out");
  if (o.gradient == "compatible" && o.option > 0)
    section.fail(
        "option", "contradicts gradient = \"compatible\"",
        "an update makes new constants of kernels, and compatible bonds are those of the body at rest",
        "leave one of them out");
  if (o.gradient == "compatible" && section.has("volumes"))
    section.fail("volumes", "contradicts gradient = \"compatible\"", "its volumes are found with its bonds",
                 "leave one of them out");
  o.list = section.number_or({"list", "radius of the list of neighbours over the spacing"}, o.list,
                             quantity::number, Sign::positive);
  if (o.list <= 1)
    section.fail("list", fmt::format("a radius of {:g} spacings holds no neighbour", o.list),
                 "particles of a lattice are one spacing apart", "1.75 holds all that touch by a corner");
  return o;
}

std::string MixedOptions::in_words() const {
  std::string text = fmt::format("{}, {}, upwinding {}, list {:g} spacings",
                                 gradient == "compatible" ? "compatible bonds" : volumes + " volumes",
                                 evolves_HJ() ? "F, H, J evolved" : "H = cof F, J = det F", upwind, list);
  if (option > 0) text += fmt::format(", reference by option {} every {} steps", option, update_every);
  if (diffuses_J) text += ", J diffused by D^j";
  if (projects) text += ", projected onto forces without torque";
  if (smooth_positions) text += ", positions by the smoothed velocity";
  return text;
}

std::vector<std::string> MixedOptions::warnings() const {
  std::vector<std::string> found;
  if (option >= 3 && !smooth_positions)
    found.emplace_back(
        "options 3 and 4 collapse in tension unless the particles move with the smoothed velocity: "
        "smooth_positions = true");
  if (evolves_HJ())
    found.emplace_back("evolved H and J gain energy: a free spin gains 4 % in 331 steps at cfl 0.9");
  if (diffuses_J)
    found.emplace_back(
        "D^j diffuses J with nothing that returns it to det F: nearly incompressible columns lose all of their energy");
  if (upwind == "reconstructed")
    found.emplace_back("single pairs may feed energy: the reconstruction is not the adjoint of itself");
  if ((option == 1 || option == 2) && upwind != "constant" && upwind != "reconstructed")
    found.emplace_back("options 1 and 2 give the results of option 0, at a higher price");
  return found;
}

}  // namespace plumb
