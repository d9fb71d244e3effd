// What a bar in one dimension cannot have.
#include "lib/scene/readers.hpp"

namespace plumb {

void refuse_on_a_line(const Section& root, int dimension, const Method& method) {
  if (dimension != 1) return;
  if (method.projection)
    root.section("projection")
        .fail("", "in one dimension", "it takes away a torque, and nothing turns on a line", "leave it out");
  if (method.compatible.surface == "estimated")
    root.section("compatible")
        .fail("surface", "\"estimated\" in one dimension", "the ends of a bar are known",
              "use surface = \"shape\"");
  if (method.scheme != "updated") return;
  const Section section = root.section(root.has("updated") ? "updated" : "method");
  if (method.updated.deviator == "two-dimensional")
    section.fail("deviator", "deviator = \"two-dimensional\" in one dimension",
                 "a bar would have no deviator at all",
                 "use deviator = \"plane-strain\", which is that of three dimensions");
  if (method.updated.form == "eno")
    section.fail("form", "form = \"eno\" in one dimension",
                 "its pairs carry shear, for which a bar has no direction", "use form = \"gno\"");
}

}  // namespace plumb
