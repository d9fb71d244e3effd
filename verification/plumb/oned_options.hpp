#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "oned/gradient.hpp"

namespace CLI {
class App;
}

namespace plumb::app {

/// One combination of the lists of kernels, radii and jitters.
struct OnedVariant {
  oned::Discretisation discretisation;
  nlohmann::ordered_json
      keys;  ///< {"kernel", "radius_over_dx" or "radius", "jitter"} as far as they are lists
  /// Returns "text, quintic, R/dx = 2": the text with what the lists have here.
  std::string named(const std::string& text) const;
};

/// The options that the subcommands of `plumb oned` share, as typed.
struct OnedOptions {
  double length = 5;
  std::vector<Index> n;
  std::string layout = "cell", form = "printed";
  std::vector<double> jitter{0};
  std::uint64_t seed = 1;
  std::vector<std::string> kernel{"cubic"};
  std::vector<double> radius_over_dx, radius;
  std::vector<std::string> fields{"poly:1,0,0,1"}, estimators{"standard", "improved"}, pairs{"W1"};

  /// The discretisation; of lists the first entry. Throws InputError.
  oned::Discretisation discretisation() const;
  /// Every kernel with every radius and jitter; one if there are no lists. Throws InputError.
  std::vector<OnedVariant> variants() const;
  std::vector<oned::Radius> radii() const;
  std::vector<oned::TestField> parsed_fields() const;
  /// Every estimator with every pair, in that order, each once.
  std::vector<oned::GradientMethod> methods() const;
};

/// Which options take lists.
struct TakesLists {
  bool n = false, variants = false;
};
/// Adds --length, --n, --layout, --jitter, --seed, --kernel, --radius-over-dx and --radius.
void add_cloud_options(CLI::App& command, OnedOptions& options, TakesLists lists);
void add_field_option(CLI::App& command, OnedOptions& options);
void add_method_options(CLI::App& command, OnedOptions& options);

/// What was asked for, for the JSON: {"length", "layout", ..., "radius_over_dx" or "radius"}.
nlohmann::ordered_json parameters_of(const OnedOptions& options);

}  // namespace plumb::app
