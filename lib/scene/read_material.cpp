#include <fmt/format.h>

#include <optional>

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

/// A parameter under its name or its symbol; nothing if neither is there.
std::optional<double> parameter(const Section& section, const LawParameter& about) {
  const std::string name(about.name), symbol(about.symbol), meaning(about.meaning);
  std::string key = name;
  if (!symbol.empty() && section.has({symbol, "short for " + name})) {
    if (section.has(name))
      section.fail(symbol, "contradicts " + name, "they are two names of one parameter",
                   "leave one of them out");
    key = symbol;
  } else if (!about.required && !section.has(name)) {
    return std::nullopt;
  }
  const double value = section.number({key, meaning}, about.quantity, about.sign);
  if (value > about.most)
    section.fail(key, fmt::format("{} is too large", value), meaning,
                 fmt::format("use at most {}", about.most));
  return value;
}

/// damage = [D1, .., D5]: five parameters at once.
void read_damage(const Section& section, MaterialChoice& material) {
  if (!section.has({"damage", "damage_1 to damage_5 at once"})) return;
  const std::vector<double> all =
      section.numbers({"damage", "damage_1 to damage_5 at once"}, 5, quantity::number);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string key = fmt::format("damage_{}", k + 1);
    if (material.parameters.contains(key))
      section.fail("damage", "contradicts " + key, "it is one of the five", "leave one of them out");
    material.parameters[key] = all[k];
  }
}

/// The parameters that the law declares; a key of another law stays unknown.
void read_parameters(const Section& section, MaterialChoice& material) {
  bool breaks = false;
  for (const LawParameter& about : parameters_of_law(material.model)) {
    breaks = breaks || about.name == "damage_1";
    if (const auto value = parameter(section, about)) material.parameters[std::string(about.name)] = *value;
  }
  if (breaks) read_damage(section, material);
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
