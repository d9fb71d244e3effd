#include "verification/plumb/oned_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "lib/kernel/catalogue.hpp"
#include "lib/schemes/tlsph/bonds/estimator_catalogue.hpp"

namespace plumb::app {
namespace {

/// The names without repetitions, in the order given.
std::vector<std::string> once(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const auto& name : names)
    if (std::find(result.begin(), result.end(), name) == result.end()) result.push_back(name);
  return result;
}

/// The complaint about a seed, empty if there is none (the library would take -1 for a huge number).
std::string whole_number(const std::string& text) {
  if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos) return {};
  return fmt::format("\"{}\" is not a whole number from 0", text);
}

}  // namespace

oned::Discretisation OnedOptions::discretisation() const {
  oned::Discretisation d;
  d.length = length;
  if (!n.empty()) d.n = n.front();
  d.layout = oned::layout_named(layout);
  d.jitter = jitter;
  d.seed = seed;
  kernel_named<1>(kernel);
  d.kernel = kernel;
  if (radius && radius_over_dx)
    throw InputError("--radius and --radius-over-dx together", "both set the support", "Give one of them.");
  d.radius = radius ? oned::Radius{*radius, true} : oned::Radius{radius_over_dx.value_or(4), false};
  return d;
}

std::vector<oned::TestField> OnedOptions::parsed_fields() const {
  std::vector<oned::TestField> result;
  for (const auto& text : once(fields)) result.push_back(oned::parse_field(text));
  return result;
}

std::vector<oned::GradientMethod> OnedOptions::methods() const {
  std::vector<oned::GradientMethod> result;
  for (const auto& estimator : once(estimators)) {
    estimator_named<1>(estimator);
    for (const auto& pair : once(pairs))
      result.push_back({estimator, pair_named(pair), oned::form_named(form)});
  }
  return result;
}

void add_cloud_options(CLI::App& command, OnedOptions& options, bool several) {
  command.add_option("--length", options.length, "length L of the body (0, L) [m]")->capture_default_str();
  auto* n = command.add_option(
      "--n", options.n, several ? "numbers of cells, as a list: 20,40,80,160" : "number of cells; dx = L/N");
  if (several)
    n->delimiter(',');
  else
    n->expected(1);
  n->default_str(several ? "20,40,80,160,320" : "40");
  command
      .add_option("--layout", options.layout,
                  "cell: N particles at (i+1/2) dx; node: N+1 at i dx, half volumes at the ends")
      ->capture_default_str();
  command.add_option("--jitter", options.jitter, "largest random displacement over dx, with Voronoi volumes")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "seed of the jitter")
      ->check(whole_number)
      ->capture_default_str();
  command.add_option("--kernel", options.kernel, join(names_of(KernelCatalogue{})))->capture_default_str();
  command.add_option("--radius-over-dx", options.radius_over_dx, "support radius R over dx")
      ->default_str("4");
  command.add_option("--radius", options.radius, "support radius R [m], fixed while dx shrinks");
}

void add_field_option(CLI::App& command, OnedOptions& options) {
  command
      .add_option("--field", options.fields,
                  "poly:a0,a1,a2,.. | sin:k | sin:A,k,phi | exp:k | tanh:k,x0 | runge; may be repeated")
      ->allow_extra_args(false)
      ->capture_default_str();
}

void add_method_options(CLI::App& command, OnedOptions& options) {
  command
      .add_option("--estimator", options.estimators,
                  join(names_of(EstimatorCatalogue{})) + "; several: a,b or repeated")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command
      .add_option(
          "--pair", options.pairs,
          "none, W0, W0raw, W1; several: a,b or repeated (W0: Shepard kernel with L-corrected gradient, "
          "W0raw: without L)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command
      .add_option("--form", options.form,
                  "pair none only: printed, sum V grad W x_j as in (33), or difference, with x_j - x_i")
      ->capture_default_str();
}

nlohmann::ordered_json parameters_of(const OnedOptions& options) {
  const oned::Discretisation d = options.discretisation();
  nlohmann::ordered_json result{{"length", d.length}, {"layout", options.layout}, {"jitter", d.jitter},
                                {"seed", d.seed},     {"kernel", d.kernel},       {"form", options.form}};
  result[d.radius.fixed ? "radius" : "radius_over_dx"] = d.radius.value;
  return result;
}

}  // namespace plumb::app
