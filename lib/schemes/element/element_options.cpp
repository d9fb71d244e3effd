#include "lib/schemes/element/element_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"

namespace plumb {

ElementOptions ElementOptions::read(const Section& section) {
  ElementOptions options;
  options.order =
      section.choice_or({"order", "linear elements, such with one point (reduced), or quadratic ones"},
                        options.order, {"linear", "reduced", "quadratic"});
  options.solve = section.choice_or(
      {"solve", "velocity Verlet with lumped masses, or Newton's method as [implicit] says"}, options.solve,
      {"explicit", "newton"});
  if (section.has("alpha") && !options.one_point())
    section.fail("alpha", fmt::format("contradicts order = \"{}\"", options.order),
                 "only elements with one point need an hourglass energy", "use order = \"reduced\"");
  options.alpha =
      section.number_or({"alpha", "hourglass energy of elements with one point, over the shear modulus"},
                        options.alpha, quantity::number, Sign::not_negative);
  section.reject_unknown();
  return options;
}

std::string ElementOptions::in_words() const {
  const std::string kind =
      one_point() ? fmt::format("linear elements with one point and hourglass energy, alpha = {:g}", alpha)
                  : fmt::format("{} elements", order);
  return kind + (by_newton() ? ", by Newton's method" : ", by velocity Verlet with lumped masses");
}

}  // namespace plumb
