#include "lib/schemes/tlsph/parts/jst_options.hpp"

#include <fmt/format.h>

#include "lib/input/section.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"
#include "lib/schemes/tlsph/parts/jst.hpp"

namespace plumb {

std::vector<std::string> outer_laplacian_names() {
  return {"symmetric", "transpose"};
}

std::optional<JstOptions> JstOptions::read(const Section& section) {
  JstOptions jst;
  jst.eta2 =
      section.number_or({"eta2", "second-order coefficient"}, jst.eta2, quantity::number, Sign::not_negative);
  jst.eta4 =
      section.number_or({"eta4", "fourth-order coefficient"}, jst.eta4, quantity::number, Sign::not_negative);
  jst.laplacian_factor = section.number_or(
      {"laplacian_factor", "of the weights of the Laplacian; the paper's own is probably 1"},
      jst.laplacian_factor, quantity::number, Sign::positive);
  jst.outer = section.choice_or(
      {"outer",
       "the outer Laplacian of (28): symmetric, or the transpose of the inner one, which takes energy by construction"},
      jst.outer, outer_laplacian_names());
  return jst;
}

std::string JstOptions::in_words() const {
  return fmt::format("JST with eta2 = {:g}, eta4 = {:g}, outer level {}", eta2, eta4, outer);
}

template <int d>
void JstOptions::ask_for_weights(BondOptions<d>& bonds) const {
  bonds.laplacian = true;
  bonds.laplacian_factor = laplacian_factor;
  bonds.outer_transpose = outer == "transpose";
}

template <int d>
void JstOptions::add_to(PartSite<d>& site) const {
  add_term(site.solid, jst_term(site.solid, *this));
  if (eta4 > 0) site.limit_step(jst_step_limit(site.solid, *this, site.real_axis));
}

template void JstOptions::ask_for_weights(BondOptions<1>&) const;
template void JstOptions::ask_for_weights(BondOptions<2>&) const;
template void JstOptions::ask_for_weights(BondOptions<3>&) const;
template void JstOptions::add_to(PartSite<1>&) const;
template void JstOptions::add_to(PartSite<2>&) const;
template void JstOptions::add_to(PartSite<3>&) const;

}  // namespace plumb
