#include "verification/plumb/foreign/solution_choice.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/input/section.hpp"
#include "lib/input/units.hpp"
#include "lib/scene/readers.hpp"

namespace plumb::app {
namespace {

/// All parameters with their values: those that are given, and defaults.
std::map<std::string, double> checked_parameters(const mms::SolutionEntry& entry, const Section& root) {
  mms::Parameters values = entry.parameters;
  if (const auto section = root.optional_section("parameters"))
    for (const std::string& key : section->all_keys()) values.set(key, section->any_number(key));
  std::map<std::string, double> all;
  for (const auto& p : values.all()) all[std::string(p.name)] = p.value;
  return all;
}

}  // namespace

SolutionChoice read_solution_choice(const std::string& name, int dimension, const Section& root) {
  const mms::SolutionEntry entry = mms::solution_entry(name);
  // most points of other programs lie in a plane or in space
  if (dimension == 0) dimension = std::max(2, entry.dimensions.front());
  if (std::find(entry.dimensions.begin(), entry.dimensions.end(), dimension) == entry.dimensions.end())
    throw InputError(fmt::format("the solution {} does not exist in {}D", name, dimension), "",
                     "See `plumb mms --list`.");
  SolutionChoice choice{name, dimension, checked_parameters(entry, root), entry.material};
  if (const auto section = root.optional_section("material")) {
    const MaterialChoice material = read_material(*section, dimension);
    choice.elastic = material.elastic();
    choice.law = material.law();
  }
  return choice;
}

SolutionChoice solution_choice(const SolutionOptions& options) {
  const TomlValue document = parse_document("", "the options", options.overrides);
  const Section root(document, "");
  SolutionChoice choice = read_solution_choice(options.name, options.dimension, root);
  root.reject_unknown();
  return choice;
}

double seconds_of(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) value = parse_quantity(text, quantity::time);
  if (!std::isfinite(value)) throw InputError("the time " + text + " is not finite", "", "");
  return value;
}

std::string in_words(const SolutionChoice& choice) {
  std::string text =
      fmt::format("{} in {}D, {}, E = {:g} Pa, nu = {:g}, rho = {:g} kg/m^3", choice.name, choice.dimension,
                  choice.law.name, choice.elastic.young, choice.elastic.poisson, choice.elastic.density);
  for (const auto& [key, value] : choice.law.parameters) text += fmt::format(", {} = {:g}", key, value);
  if (choice.dimension == 2 && choice.law.plane == Plane::stress) text += ", plane stress";
  for (const auto& [key, value] : choice.parameters) text += fmt::format(", {} = {:g}", key, value);
  return text;
}

void add_solution_options(CLI::App& command, SolutionOptions& options) {
  command.add_option("--dimension", options.dimension, "of the solution, where it exists in more than one")
      ->check(CLI::IsMember({1, 2, 3}));
  command
      .add_option("--set", options.overrides,
                  "a parameter of the solution or a key of its material: parameters.amplitude=0.02, "
                  "material.young=\"17 MPa\" (then with poisson and density); may be repeated")
      ->type_name("section.key=value");
}

}  // namespace plumb::app
