#include "lib/schemes/tlsph/parts/damping.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"

namespace plumb {

std::optional<DampingOptions> DampingOptions::read(const Section& section) {
  const double rate =
      section.number({"rate", "free motion decays by exp(-rate t/2)"}, quantity::rate, Sign::not_negative);
  if (rate == 0) return std::nullopt;
  return DampingOptions{rate};
}

std::string DampingOptions::in_words() const {
  return fmt::format("mass-proportional, rate {:g} 1/s", rate);
}

template <int d>
void DampingOptions::add_to(PartSite<d>& site) const {
  Term<d> term;
  term.name = section;
  term.second = [rate = rate](const Solid<d>& solid, const Block& block, const Instant<d>& now,
                              BlockForce<d>& force) {
    const double coefficient = solid.elastic.density * rate;
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) force(k, i) -= coefficient * now.state.v[k][i];
  };
  add_term(site.solid, std::move(term));
  site.limit_step(site.real_axis / rate);
}

template void DampingOptions::add_to(PartSite<1>&) const;
template void DampingOptions::add_to(PartSite<2>&) const;
template void DampingOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
