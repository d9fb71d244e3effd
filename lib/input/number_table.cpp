#include "lib/input/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

/// What separates the cells of a line: the first of these that it has, else blanks.
char separator_of(const std::string& line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string::npos) return c;
  return ' ';
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  if (separator == ' ')
    boost::split(cells, line, boost::is_space(), boost::token_compress_on);
  else
    boost::split(cells, line, [separator](char c) { return c == separator; });
  for (std::string& cell : cells) {
    boost::trim(cell);
    boost::trim_if(cell, boost::is_any_of("\""));
  }
  return cells;
}

/// The number that the whole cell is, with a decimal comma where a comma does not separate.
std::optional<double> number_of(std::string cell, char separator) {
  if (separator != ',') std::replace(cell.begin(), cell.end(), ',', '.');
  if (cell.starts_with('+')) cell.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

/// "h [m]" and "h (m)" are called "h".
std::string without_unit(const std::string& name) {
  return boost::trim_copy(name.substr(0, name.find_first_of("[(")));
}

std::vector<double> numbers_of(const std::vector<std::string>& cells, char separator,
                               const std::string& where) {
  std::vector<double> row;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto value = number_of(cells[k], separator);
    if (!value)
      throw InputError(fmt::format("{}: \"{}\" in column {} is no number", where, cells[k], k + 1), "",
                       "Write numbers as 1.25e-3; put \"#\" before comments.");
    if (!std::isfinite(*value))
      throw InputError(fmt::format("{}: {} in column {}", where, cells[k], k + 1),
                       "what is judged must be finite", "Leave broken runs out.");
    row.push_back(*value);
  }
  return row;
}

}  // namespace

std::size_t NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw unknown_name("column", name, names);
  return static_cast<std::size_t>(found - names.begin());
}

NumberTable parse_numbers(const std::string& text, const std::string& file_name) {
  NumberTable table;
  std::istringstream lines(text);
  char separator = 0;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    boost::trim(line);
    if (line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);  // a mark that some spreadsheets put first
    if (line.empty()) continue;
    const bool first = separator == 0;
    if (first) separator = separator_of(line);
    const auto cells = cells_of(line, separator);
    if (first) {
      const bool heading = std::none_of(cells.begin(), cells.end(), [&](const std::string& cell) {
        return number_of(cell, separator).has_value();
      });
      for (std::size_t k = 0; k < cells.size(); ++k)
        table.names.push_back(heading ? without_unit(cells[k]) : std::to_string(k + 1));
      if (heading) continue;
    }
    const std::string where = fmt::format("{}:{}", file_name, number);
    if (cells.size() != table.names.size())
      throw InputError(
          fmt::format("{}: {} cells, the first line has {}", where, cells.size(), table.names.size()),
          "every row has one number a column",
          "Use semicolons between cells if numbers have decimal commas.");
    table.rows.push_back(numbers_of(cells, separator, where));
  }
  if (table.rows.empty())
    throw InputError(fmt::format("{} holds no numbers", file_name), "", "Give a row for every level.");
  return table;
}

}  // namespace plumb
