#include "lib/output/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lib/output/table_parts.hpp"

namespace plumb {
namespace {

Cell cell_of(const nlohmann::ordered_json& value) {
  if (value.is_null()) return std::monostate{};
  if (value.is_boolean()) return std::string(value.get<bool>() ? "true" : "false");
  if (value.is_number_integer()) return value.get<long long>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return value.dump();
}

std::string short_text(const Cell& cell, int digits) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.{}g}", *number, digits);
  if (const auto* whole = std::get_if<long long>(&cell)) return std::to_string(*whole);
  if (std::holds_alternative<std::monostate>(cell)) return "-";
  return std::get<std::string>(cell);
}

/// Columns of a terminal that UTF-8 text takes: one per code point.
std::size_t width_of(const std::string& text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xc0') != '\x80'; });
}

/// One line of cells in columns.
std::string aligned(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += (k ? "  " : "") + cells[k] + std::string(widths[k] - width_of(cells[k]), ' ');
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

}  // namespace

Table table_of(const nlohmann::ordered_json& rows) {
  Table table;
  for (const auto& row : rows)
    for (const auto& item : row.items())
      if (std::find(table.columns.begin(), table.columns.end(), item.key()) == table.columns.end())
        table.columns.push_back(item.key());
  for (const auto& row : rows) {
    std::vector<Cell> cells;
    for (const auto& column : table.columns)
      cells.push_back(row.contains(column) ? cell_of(row[column]) : Cell(std::string()));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string csv_cell(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.17g}", *number);
  if (const auto* whole = std::get_if<long long>(&cell)) return std::to_string(*whole);
  if (std::holds_alternative<std::monostate>(cell)) return "nan";
  const auto& text = std::get<std::string>(cell);
  if (text.find_first_of("\",\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_text(const Table& table) {
  std::string text;
  const auto add_line = [&text](const auto& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) text += (k ? "," : "") + csv_cell(Cell(cells[k]));
    text += '\n';
  };
  add_line(table.columns);
  for (const auto& row : table.rows) add_line(row);
  return text;
}

std::vector<std::size_t> column_widths(const Table& table, int digits) {
  std::vector<std::size_t> widths;
  for (const auto& column : table.columns) widths.push_back(width_of(column));
  for (const auto& row : table.rows)
    for (std::size_t k = 0; k < row.size(); ++k)
      widths[k] = std::max(widths[k], width_of(short_text(row[k], digits)));
  return widths;
}

std::string plain_heading(const Table& table, const std::vector<std::size_t>& widths) {
  return aligned(table.columns, widths);
}

std::string plain_rows(const Table& table, const std::vector<std::size_t>& widths, int digits) {
  std::string text;
  std::vector<std::string> line;
  for (const auto& row : table.rows) {
    line.clear();
    for (const auto& cell : row) line.push_back(short_text(cell, digits));
    text += aligned(line, widths);
  }
  return text;
}

std::string plain_text(const Table& table, int digits) {
  const auto widths = column_widths(table, digits);
  return plain_heading(table, widths) + plain_rows(table, widths, digits);
}

}  // namespace plumb
