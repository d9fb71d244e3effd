#include "lib/schemes/tlsph/parts/dissipation_options.hpp"

#include "lib/input/section.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"
#include "lib/schemes/tlsph/parts/pair_upwind.hpp"

namespace plumb {

std::optional<DissipationOptions> DissipationOptions::read(const Section& section) {
  DissipationOptions options;
  options.kind = section.choice_or(
      {"kind", "upwind: Riemann's problem of each pair, whose states velocity gradients reconstruct"},
      options.kind, {"upwind"});
  return options;
}

std::string DissipationOptions::in_words() const {
  return "upwinding of pairs by the form R^T S R, which keeps both momenta and takes energy";
}

template <int d>
void DissipationOptions::add_to(PartSite<d>& site) const {
  add_term(site.solid, pair_upwind_term(site.solid));
  site.limit_step(pair_upwind_step_limit(site.solid, site.real_axis));
}

template void DissipationOptions::add_to(PartSite<1>&) const;
template void DissipationOptions::add_to(PartSite<2>&) const;
template void DissipationOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
