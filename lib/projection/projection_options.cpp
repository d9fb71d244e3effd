#include "plumbline/projection/projection_options.hpp"

#include "plumbline/projection/angular_momentum.hpp"
#include "plumbline/solid/part_site.hpp"

namespace plumb {

template <int d>
void ProjectionOptions::add_to(PartSite<d>& site) const {
  add_term(site.solid, angular_momentum_projection(site.solid));
}

template void ProjectionOptions::add_to(PartSite<2>&) const;
template void ProjectionOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
