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
  d.jitter = jitter.front();
  d.seed = seed;
  kernel_named<1>(kernel.front());
  d.kernel = kernel.front();
  d.radius = radii().front();
  return d;
}

std::vector<oned::Radius> OnedOptions::radii() const {
  if (!radius.empty() && !radius_over_dx.empty())
    throw InputError("--radius and --radius-over-dx together", "both set the support", "Give one of them.");
  std::vector<oned::Radius> all;
  for (const double value : radius) all.push_back({value, true});
  for (const double value : radius_over_dx) all.push_back({value, false});
  if (all.empty()) all.push_back({4, false});
  return all;
}

std::vector<OnedVariant> OnedOptions::variants() const {
  const auto all = radii();
  std::vector<OnedVariant> made;
  for (const auto& name : once(kernel))
    for (const auto& R : all)
      for (const double moved : jitter) {
        OnedVariant variant{discretisation(), nlohmann::ordered_json::object()};
        kernel_named<1>(name);
        variant.discretisation.kernel = name;
        variant.discretisation.radius = R;
        variant.discretisation.jitter = moved;
        if (kernel.size() > 1) variant.keys["kernel"] = name;
        if (all.size() > 1) variant.keys[R.fixed ? "radius" : "radius_over_dx"] = R.value;
        if (jitter.size() > 1) variant.keys["jitter"] = moved;
        made.push_back(std::move(variant));
      }
  return made;
}

std::string OnedVariant::named(const std::string& text) const {
  std::string all = text;
  const auto add = [&all](const std::string& more) { all += (all.empty() ? "" : ", ") + more; };
  for (const auto& [key, value] : keys.items())
    add(key == "kernel"           ? value.get<std::string>()
        : key == "radius_over_dx" ? fmt::format("R/dx = {:g}", value.get<double>())
        : key == "radius"         ? fmt::format("R = {:g} m", value.get<double>())
                                  : fmt::format("jitter {:g}", value.get<double>()));
  return all;
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

void add_cloud_options(CLI::App& command, OnedOptions& options, TakesLists lists) {
  const auto list = [](CLI::Option* option, bool several) {
    if (several)
      option->delimiter(',')->allow_extra_args(false);
    else
      option->expected(1);
    return option;
  };
  const std::string as_list = lists.variants ? ", or a list" : "";
  command.add_option("--length", options.length, "length L of the body (0, L) [m]")->capture_default_str();
  auto* n = command.add_option(
      "--n", options.n, lists.n ? "numbers of cells, as a list: 20,40,80,160" : "number of cells; dx = L/N");
  if (lists.n)
    n->delimiter(',');
  else
    n->expected(1);
  n->default_str(lists.n ? "20,40,80,160,320" : "40");
  command
      .add_option("--layout", options.layout,
                  "cell: N particles at (i+1/2) dx; node: N+1 at i dx, half volumes at the ends")
      ->capture_default_str();
  list(command.add_option("--jitter", options.jitter,
                          "largest random displacement over dx, with Voronoi volumes" + as_list),
       lists.variants)
      ->default_str("0");
  command.add_option("--seed", options.seed, "seed of the jitter")
      ->check(whole_number)
      ->capture_default_str();
  list(command.add_option("--kernel", options.kernel, join(names_of(KernelCatalogue{})) + as_list),
       lists.variants)
      ->default_str("cubic");
  list(command.add_option("--radius-over-dx", options.radius_over_dx, "support radius R over dx" + as_list),
       lists.variants)
      ->default_str("4");
  list(command.add_option("--radius", options.radius,
                          "support radius R [m], fixed while dx shrinks" + as_list),
       lists.variants);
}

void add_field_option(CLI::App& command, OnedOptions& options) {
  command
      .add_option(
          "--field", options.fields,
          "poly:a0,a1,a2,.. | sin:k | sin:A,k,phi | exp:k | tanh:k,x0 | runge | a formula in X, \"sin(3*X)*X\"; may be repeated")
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

namespace {

/// The entry of a list of one, or the list.
template <class T>
nlohmann::ordered_json one_or_all(const std::vector<T>& list) {
  return list.size() == 1 ? nlohmann::ordered_json(list.front()) : nlohmann::ordered_json(list);
}

}  // namespace

nlohmann::ordered_json parameters_of(const OnedOptions& options) {
  const oned::Discretisation d = options.discretisation();
  nlohmann::ordered_json result{{"length", d.length},
                                {"layout", options.layout},
                                {"jitter", one_or_all(options.jitter)},
                                {"seed", d.seed},
                                {"kernel", one_or_all(options.kernel)},
                                {"form", options.form}};
  std::vector<double> radii;
  for (const oned::Radius& radius : options.radii()) radii.push_back(radius.value);
  result[d.radius.fixed ? "radius" : "radius_over_dx"] = one_or_all(radii);
  return result;
}

}  // namespace plumb::app
