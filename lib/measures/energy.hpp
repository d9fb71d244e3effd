#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// Energy of one kind, under the name that stands in the series.
struct NamedEnergy {
  std::string name;
  double value;  ///< [J] (per metre of thickness in 2D)
};

/// Energies of a state; `dissipated` is what the scheme has turned into heat since its start.
struct Energy {
  double kinetic = 0, strain = 0;  ///< [J]
  std::vector<NamedEnergy> more;   ///< stored elsewhere (hourglass energy, plastic work ..)
  std::optional<double> dissipated;
  /// What is stored elsewhere, together [J].
  double elsewhere() const {
    double sum = 0;
    for (const auto& e : more) sum += e.value;
    return sum;
  }
  double total() const { return kinetic + strain + elsewhere(); }
};

}  // namespace plumb
