// LAMMPS dumps: https://docs.lammps.org/dump.html, styles atom and custom.
#include <fmt/format.h>

#include <boost/algorithm/string.hpp>
#include <charconv>
#include <sstream>

#include "lib/core/error.hpp"
#include "lib/input/point_formats.hpp"

namespace plumb {
namespace {

struct Lines {
  std::istringstream text;
  std::string file_name;
  long number = 0;

  bool next(std::string& line) {
    if (!std::getline(text, line)) return false;
    ++number;
    boost::trim(line);
    return true;
  }
  [[noreturn]] void fail(const std::string& problem, const std::string& why) const {
    throw InputError(fmt::format("{}:{}: {}", file_name, number, problem), why, "");
  }
};

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  boost::split(words, line, boost::is_space(), boost::token_compress_on);
  return words;
}

/// The heading of the atoms in the names of tables.
std::vector<std::string> names_of_atoms(const Lines& lines, const std::string& line) {
  std::vector<std::string> names = words_of(boost::trim_copy(line.substr(std::string("ITEM: ATOMS").size())));
  for (std::string& name : names) {
    if (name == "xs" || name == "xsu")
      lines.fail("scaled positions", "they are shares of a box: dump x y z or xu yu zu");
    if (name == "xu" || name == "yu" || name == "zu") name.pop_back();
    // v_u[1] or c_s[2] of a vector
    if (name.size() > 3 && name.ends_with("]"))
      name = name.substr(0, name.size() - 3) + name.substr(name.size() - 2, 1);
    for (const char* style : {"v_", "c_", "f_", "i_", "d_"})
      if (name.starts_with(style)) name.erase(0, 2);
  }
  return names;
}

std::vector<double> row_of(const Lines& lines, const std::vector<std::string>& cells, std::size_t count) {
  if (cells.size() != count)
    lines.fail(fmt::format("{} values, the heading names {}", cells.size(), count), "");
  std::vector<double> row;
  for (const std::string& cell : cells) {
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool whole = error == std::errc() && end == cell.data() + cell.size();
    if (!whole &&
        cell.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz") != std::string::npos)
      lines.fail(fmt::format("\"{}\" is no number", cell), "");
    row.push_back(whole ? value : 0);  // the name of an element
  }
  return row;
}

}  // namespace

PointFile parse_dump(const std::string& text, const std::string& file_name) {
  Lines lines{std::istringstream(text), file_name};
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  std::string line;
  bool in_atoms = false;
  while (lines.next(line)) {
    if (line.starts_with("ITEM: ATOMS")) {
      if (!names.empty())
        lines.fail("a second snapshot", "a file is read as one instant: dump each into its own");
      names = names_of_atoms(lines, line);
      in_atoms = true;
    } else if (line.starts_with("ITEM:")) {
      in_atoms = false;
    } else if (in_atoms && !line.empty()) {
      rows.push_back(row_of(lines, words_of(line), names.size()));
    }
  }
  if (names.empty()) lines.fail("no ITEM: ATOMS", "a dump has one");
  PointFile file;
  file.count = rows.size();
  file.columns = grouped_columns(names, rows);
  return file;
}

}  // namespace plumb
