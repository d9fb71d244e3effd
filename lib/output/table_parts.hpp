#pragma once
#include "lib/output/table.hpp"

/// plain_text() of a table that is written in parts.
namespace plumb {

/// The widths that its columns have.
std::vector<std::size_t> column_widths(const Table& table, int digits = 6);

/// The heading and the rows, in columns of given widths.
std::string plain_heading(const Table& table, const std::vector<std::size_t>& widths);
std::string plain_rows(const Table& table, const std::vector<std::size_t>& widths, int digits = 6);

}  // namespace plumb
