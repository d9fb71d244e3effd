#include "lib/schemes/tlsph/parts/projection_options.hpp"

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"
#include "lib/schemes/tlsph/parts/angular_momentum.hpp"

namespace plumb {

template <int d>
void ProjectionOptions::add_to(PartSite<d>& site) const {
  if constexpr (d == 1)
    throw InputError("[projection] in one dimension", "a bar does not turn", "leave it out");
  else
    add_term(site.solid, angular_momentum_projection(site.solid));
}

template void ProjectionOptions::add_to(PartSite<1>&) const;
template void ProjectionOptions::add_to(PartSite<2>&) const;
template void ProjectionOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
