#include "plumbline/dissipation/jst_options.hpp"

#include "plumbline/input/section.hpp"

namespace plumb {

std::vector<std::string> outer_laplacian_names() {
  return {"symmetric", "transpose"};
}

std::optional<JstOptions> read_jst(const Section& root) {
  const auto section = root.optional_section("jst");
  if (!section) return std::nullopt;
  JstOptions jst;
  jst.eta2 = section->number_or("eta2", jst.eta2, quantity::number, Sign::not_negative);
  jst.eta4 = section->number_or("eta4", jst.eta4, quantity::number, Sign::not_negative);
  jst.laplacian_factor =
      section->number_or("laplacian_factor", jst.laplacian_factor, quantity::number, Sign::positive);
  jst.outer = section->choice_or("outer", jst.outer, outer_laplacian_names());
  section->reject_unknown();
  return jst;
}

}  // namespace plumb
