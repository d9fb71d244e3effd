#pragma once
#include <string>
#include <vector>

#include "lib/particles/snapshot.hpp"
#include "lib/run/simulation.hpp"

/// What [output] fields can add to particle files and to the columns of probes.
namespace plumb {

/// Lists the names that [output] fields knows.
std::vector<std::string> output_field_names();

/// One field of all particles as files show it.
struct ShownField {
  std::string name, unit;               ///< unit: empty of a pure number
  std::vector<std::string> components;  ///< "xx", "xy" ..; one empty name for a scalar
  std::vector<double> values;           ///< particle after particle

  /// "stress [Pa]".
  std::string title() const;
  /// "stress xx [Pa]", one for each component.
  std::vector<std::string> columns() const;
  /// The numbers of one particle.
  std::vector<double> of(std::size_t particle) const;
};

/// The field of that name. Throws InputError if the scheme does not have it.
template <int d>
ShownField shown_field(const std::string& name, const Snapshot<d>& shown);

/// Columns of that field at a probe, and its numbers there, in the same order.
template <int d>
std::vector<std::string> probe_columns(const std::string& name);
template <int d>
std::vector<double> probe_values(const std::string& name, const PointView<d>& at);

}  // namespace plumb
