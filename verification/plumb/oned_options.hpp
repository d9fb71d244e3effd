#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oned/gradient.hpp"

namespace CLI {
class App;
}

namespace plumb::app {

/// The options that the subcommands of `plumb oned` share, as typed.
struct OnedOptions {
  double length = 5;
  std::vector<Index> n;
  std::string layout = "cell", form = "printed";
  double jitter = 0;
  std::uint64_t seed = 1;
  std::string kernel = "cubic";
  std::optional<double> radius_over_dx, radius;
  std::vector<std::string> fields{"poly:1,0,0,1"}, estimators{"standard", "improved"}, pairs{"W1"};

  /// The discretisation; its n is the only number of cells, or the first of several. Throws InputError.
  oned::Discretisation discretisation() const;
  std::vector<oned::TestField> parsed_fields() const;
  /// Every estimator with every pair, in that order, each once.
  std::vector<oned::GradientMethod> methods() const;
};

/// Adds --length, --n, --layout, --jitter, --seed, --kernel, --radius-over-dx and --radius. `several`: --n
/// takes a list.
void add_cloud_options(CLI::App& command, OnedOptions& options, bool several);
void add_field_option(CLI::App& command, OnedOptions& options);
void add_method_options(CLI::App& command, OnedOptions& options);

/// What was asked for, for the JSON: {"length", "layout", ..., "radius_over_dx" or "radius"}.
nlohmann::ordered_json parameters_of(const OnedOptions& options);

}  // namespace plumb::app
