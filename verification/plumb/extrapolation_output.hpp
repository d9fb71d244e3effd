#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/convergence/richardson.hpp"

namespace plumb::app {

/// What values on several grids say about their limit, for people and as JSON.
struct Extrapolated {
  std::string text;
  /// {"behaviour", "order", "limit", "gci", "gci_absolute", "gci_fine", "gci_coarse",
  /// "asymptotic_ratio", "safety", "least_squares", "uncertainty", "status"}. gci_fine and gci_coarse are the
  /// first two of gci_absolute.
  nlohmann::ordered_json json;
  std::string_view status;  ///< "pass" if the three finest grids have a limit, "inconclusive" or "fail" else
};

/// Extrapolates three grids or more, and fits four or more by least squares too. Throws InputError as
/// richardson() does.
Extrapolated extrapolated(const std::vector<Sample>& samples, double safety,
                          std::optional<double> declared_order);

}  // namespace plumb::app
