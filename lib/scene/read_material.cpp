#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/material/law.hpp"
#include "lib/material/rate_models.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/readers.hpp"

namespace plumb {
namespace {

void read_elastic(const Section& section, MaterialChoice& material, MaterialOf of) {
  material.young =
      section.number({"young", "Young's modulus of the reference"}, quantity::stress, Sign::positive);
  material.poisson = section.number({"poisson", "Poisson's ratio, above -1 and below 0.5"}, quantity::number);
  if (material.poisson >= 0.5)
    section.fail("poisson", fmt::format("{} is too large", material.poisson),
                 "at 0.5 the material is incompressible and its bulk modulus infinite", "use at most 0.4999");
  if (material.poisson <= -1.0)
    section.fail("poisson", fmt::format("{} is too small", material.poisson),
                 "at -1 the shear modulus is infinite", "common solids have 0 to 0.5");
  if (of == MaterialOf::body || section.has("density"))
    material.density = section.number({"density", "of the reference"}, quantity::density, Sign::positive);
}

/// The parameters that the law declares; a key of another law stays unknown.
void read_parameters(const Section& section, MaterialChoice& material) {
  for (const LawParameter& about : parameters_of_law(material.model)) {
    const std::string key(about.name);
    if (!about.required && !section.has(key)) continue;
    const double value = section.number({key, std::string(about.meaning)}, about.quantity, about.sign);
    if (value > about.most)
      section.fail(key, fmt::format("{} is too large", value), std::string(about.meaning),
                   fmt::format("use at most {}", about.most));
    material.parameters[key] = value;
  }
}

void read_plane(const Section& section, MaterialChoice& material, int dimension) {
  if (section.choice_or({"plane", "bodies in 2D: plane strain, or plane stress"}, "strain", plane_names()) ==
      "strain")
    return;
  if (dimension != 2)
    section.fail("plane", fmt::format("\"stress\" in {} dimension{}", dimension, dimension == 1 ? "" : "s"),
                 "plane stress is for bodies in 2D", "leave it out");
  if (has_history(material.model))
    section.fail("plane", fmt::format("\"stress\" contradicts model = \"{}\"", material.model),
                 "plane stress is for elastic laws", "use plane = \"strain\"");
  material.plane = Plane::stress;
}

}  // namespace

MaterialChoice read_material(const Section& section, int dimension, MaterialOf of) {
  MaterialChoice material;
  material.model = section.choice_or({"model", "the law"}, material.model, material_names());
  read_elastic(section, material, of);
  read_parameters(section, material);
  read_plane(section, material, dimension);
  section.reject_unknown();
  try {
    require_law(material.law(), material.elastic());
  } catch (const InputError& error) {
    section.fail("", error.problem(), error.why(), error.suggestion());
  }
  return material;
}

void refuse_history(const Section& root, const MaterialChoice& material, const Method& method) {
  const bool has_rates = method.scheme == "eulerian" || method.scheme == "updated";
  if (needs_rates(material.model) && !has_rates)
    root.section("material")
        .fail("model", fmt::format("\"{}\" contradicts scheme = \"{}\"", material.model, method.scheme),
              "its stress follows rates", "use scheme = \"eulerian\" or \"updated\"");
  if (!has_history(material.model) || !method.implicit.energy_momentum) return;
  root.section("material")
      .fail("model",
            fmt::format("\"{}\" contradicts [implicit] dynamics = \"energy-momentum\"", material.model),
            "its stress depends on what was before, so that no stored energy has it as its derivative",
            "use dynamics = \"midpoint\", or an elastic law");
}

}  // namespace plumb
