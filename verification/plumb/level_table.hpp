#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plumbline/convergence/order_fit.hpp"

namespace plumb {

/// A table of numbers by columns, as people keep them: separated by commas, semicolons, tabs or blanks, with
/// a heading or not, with decimal commas where commas do not separate. "#" begins a comment.
struct NumberTable {
  std::vector<std::string> names;  ///< of the heading, without units in brackets; "1", "2", .. without one
  std::vector<std::vector<double>> rows;

  /// The place of a column. Throws InputError with the nearest name.
  std::size_t column(const std::string& name) const;
};

/// Reads a table. Throws InputError with the line for what is no number or not finite, for rows of another
/// length than the first, and for a table without rows.
NumberTable parse_numbers(const std::string& text, const std::string& file_name);

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

}  // namespace plumb
