#include "lib/schemes/tlsph/parts/hourglass_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"
#include "lib/schemes/tlsph/parts/hourglass.hpp"
#include "lib/schemes/tlsph/parts/slope_hourglass.hpp"

namespace plumb {

std::optional<HourglassOptions> HourglassOptions::read(const Section& section) {
  HourglassOptions hourglass;
  hourglass.weight = section.choice_or(
      {"weight", "of the bonds: the kernel, or minus its slope times the distance (paper 004)"},
      hourglass.weight, {"kernel", "slope"});
  if (hourglass.weight == "slope") hourglass.alpha = 1;  // as paper 004
  hourglass.alpha = section.number_or(
      {"alpha", "strength; the larger, the less alternating motion and the stiffer a coarse bend"},
      hourglass.alpha, quantity::number, Sign::not_negative);
  if (hourglass.alpha == 0) return std::nullopt;
  return hourglass;
}

std::string HourglassOptions::in_words() const {
  if (weight == "slope")
    return fmt::format("energy of what no affine motion explains, weights -W' r (paper 004), alpha = {:g}",
                       alpha);
  return fmt::format("energy of alternating motion, alpha = {:g}", alpha);
}

template <int d>
void HourglassOptions::add_to(PartSite<d>& site) const {
  if (weight == "slope")
    add_term(site.solid, slope_hourglass_term(site.solid, site.kernel, alpha, site.radius));
  else
    add_term(site.solid, hourglass_term(site.solid, site.kernel, alpha));
}

template void HourglassOptions::add_to(PartSite<1>&) const;
template void HourglassOptions::add_to(PartSite<2>&) const;
template void HourglassOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
