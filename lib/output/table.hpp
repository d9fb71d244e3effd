#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

namespace plumb {

/// One entry of a table: text, a whole number, a number, or nothing where there is none.
using Cell = std::variant<std::string, long long, double, std::monostate>;

/// A table for --csv and for people. Column names carry their unit: "time [s]". Every row has one cell a
/// column.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

/// The table of a JSON array of flat objects: the columns are the keys in order of first appearance; a
/// missing key is an empty cell, null is nothing ("nan" in CSV, "-" for people), an array or object is written as JSON text.
Table table_of(const nlohmann::ordered_json& rows);

/// RFC 4180 text with a heading line. Numbers have 17 significant digits; non-finite ones read nan, inf,
/// -inf.
std::string csv_text(const Table& table);

/// Aligned columns for a terminal, numbers with `digits` significant digits.
std::string plain_text(const Table& table, int digits = 6);

/// One cell as CSV, quoted when needed.
std::string csv_cell(const Cell& cell);

}  // namespace plumb
