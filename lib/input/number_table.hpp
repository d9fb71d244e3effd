#pragma once
#include <string>
#include <vector>

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

}  // namespace plumb
