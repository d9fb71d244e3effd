#pragma once
#include <optional>
#include <vector>

#include "lib/input/number_table.hpp"

namespace plumb::app {

/// All runs of one spacing.
struct RunsOfLevel {
  double spacing;              ///< [m], or another measure of the resolution
  std::vector<double> values;  ///< one per run, in the order of the file

  /// Mean of the values.
  double mean() const;
  /// Geometric mean of their sizes, with the sign of their mean: what an order is fitted to.
  double typical() const;
  /// Standard deviation of the values over their mean, none for a single run.
  std::optional<double> spread() const;
};

/// The runs of one column, from coarse to fine.
std::vector<RunsOfLevel> runs_of(const NumberTable& table, std::size_t spacing, std::size_t value);

}  // namespace plumb::app
