#include "lib/input/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cmath>
#include <map>
#include <numeric>

#include "lib/core/error.hpp"
#include "lib/input/document.hpp"
#include "lib/input/number_table.hpp"
#include "lib/input/point_formats.hpp"

namespace plumb {
namespace {

/// Endings of the names of a vector's or tensor's columns.
const std::vector<std::vector<std::string>>& endings() {
  static const std::vector<std::vector<std::string>> all{
      {":0", ":1", ":2", ":3", ":4", ":5", ":6", ":7", ":8"},
      {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"},
      {"11", "12", "13", "21", "22", "23", "31", "32", "33"},
      {":0", ":1", ":2", ":3"},
      {"xx", "xy", "yx", "yy"},
      {"11", "12", "21", "22"},
      {":0", ":1", ":2"},
      {"x", "y", "z"},
      {"X", "Y", "Z"},
      {"1", "2", "3"},
      {":0", ":1"},
      {"x", "y"},
      {"X", "Y"},
      {"1", "2"}};
  return all;
}

/// What stands before the endings in the names from `first` on; nothing if they have others.
std::optional<std::string> common_stem(const std::vector<std::string>& names, std::size_t first,
                                       const std::vector<std::string>& all) {
  if (first + all.size() > names.size()) return std::nullopt;
  std::optional<std::string> stem;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string& name = names[first + k];
    if (!name.ends_with(all[k])) return std::nullopt;
    const std::string before = name.substr(0, name.size() - all[k].size());
    if (stem && *stem != before) return std::nullopt;
    stem = before;
  }
  if (stem->empty() && !boost::iequals(all.front(), "x")) return std::nullopt;  // columns without a heading
  if (stem->empty()) return all.front() == "x" ? "position" : "reference";
  boost::trim_right_if(*stem, boost::is_any_of("_. "));
  return stem;
}

/// The points in the order of their numbers.
void sort_by_id(PointFile& file, const std::string& name) {
  const PointColumn* id = file.find({"id"});
  if (id == nullptr || id->components != 1) return;
  std::vector<std::size_t> order(file.count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return id->values[a] < id->values[b]; });
  for (std::size_t k = 1; k < file.count; ++k)
    if (id->values[order[k - 1]] == id->values[order[k]])
      throw InputError(fmt::format("{}: two points have the id {:.0f}", name, id->values[order[k]]),
                       "ids tell points apart", "write each point once");
  const auto sorted = [&](std::vector<double>& values, std::size_t components) {
    std::vector<double> moved;
    moved.reserve(values.size());
    for (const std::size_t from : order)
      for (std::size_t c = 0; c < components; ++c) moved.push_back(values[from * components + c]);
    values = std::move(moved);
  };
  sorted(file.positions, 3);
  for (PointColumn& column : file.columns) sorted(column.values, static_cast<std::size_t>(column.components));
}

/// Positions out of the columns, for formats that hold them there.
void take_positions(PointFile& file, const std::string& name) {
  if (!file.positions.empty()) return;
  const PointColumn* at = file.find(position_names());
  if (at == nullptr || at->components > 3)
    throw InputError(fmt::format("{} has no positions", name), "they stand in columns x, y and, in 3D, z",
                     fmt::format("its columns are {}", join(file.names())));
  file.axes = at->components;
  for (std::size_t k = 0; k < file.count; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      file.positions.push_back(c < static_cast<std::size_t>(at->components)
                                   ? at->values[k * static_cast<std::size_t>(at->components) + c]
                                   : 0.0);
}

void require_finite(const PointFile& file, const std::string& name) {
  for (std::size_t k = 0; k < file.positions.size(); ++k)
    if (!std::isfinite(file.positions[k]))
      throw InputError(fmt::format("{}: the position of point {} is not finite", name, k / 3), "", "");
  for (const PointColumn& column : file.columns)
    for (std::size_t k = 0; k < column.values.size(); ++k)
      if (!std::isfinite(column.values[k]))
        throw InputError(fmt::format("{}: {} of point {} is not finite", name, column.name,
                                     k / static_cast<std::size_t>(column.components)),
                         "a broken run has no error norm", "leave it out");
}

}  // namespace

const std::vector<std::string>& position_names() {
  static const std::vector<std::string> names{"position", "positions", "points",   "coordinates",
                                              "coords",   "coord",     "reference"};
  return names;
}

const PointColumn* PointFile::find(const std::vector<std::string>& wanted) const {
  for (const std::string& name : wanted)
    for (const PointColumn& column : columns)
      if (boost::iequals(column.name, name)) return &column;
  return nullptr;
}

std::vector<std::string> PointFile::names() const {
  std::vector<std::string> all;
  for (const PointColumn& column : columns) all.push_back(column.name);
  return all;
}

/// Endings of the columns of a bar, whose vectors and tensors have one component.
const std::vector<std::vector<std::string>>& endings_of_bar() {
  static const std::vector<std::vector<std::string>> all{{"xx"}, {"11"}, {"x"}, {"X"}};
  return all;
}

/// Whether a table has an axis x and no other.
bool is_of_bar(const std::vector<std::string>& names) {
  const auto has = [&](const char* axis) {
    return std::any_of(names.begin(), names.end(),
                       [&](const auto& name) { return boost::iequals(name, axis); });
  };
  return has("x") && !has("y");
}

std::vector<PointColumn> grouped_columns(const std::vector<std::string>& names,
                                         const std::vector<std::vector<double>>& rows) {
  std::vector<PointColumn> columns;
  for (std::size_t first = 0; first < names.size();) {
    PointColumn column{names[first], 1, {}};
    for (const auto& all : is_of_bar(names) ? endings_of_bar() : endings())
      if (const auto stem = common_stem(names, first, all)) {
        column = {*stem, static_cast<int>(all.size()), {}};
        break;
      }
    for (const auto& row : rows)
      for (int c = 0; c < column.components; ++c)
        column.values.push_back(row[first + static_cast<std::size_t>(c)]);
    first += static_cast<std::size_t>(column.components);
    columns.push_back(std::move(column));
  }
  return columns;
}

PointFile parse_point_table(const std::string& text, const std::string& file_name) {
  NumberTable table = parse_numbers(text, file_name);
  if (!table.names.empty() && table.names.front() == "1") {  // no heading
    const std::vector<std::string> axes{"x", "y", "z"};
    for (std::size_t k = 0; k < std::min<std::size_t>(3, table.names.size()); ++k) table.names[k] = axes[k];
  }
  PointFile file;
  file.count = table.rows.size();
  file.columns = grouped_columns(table.names, table.rows);
  return file;
}

PointFile parse_points(const std::string& bytes, const std::string& file_name) {
  const bool vtk = file_name.ends_with(".vtp") || file_name.ends_with(".vtu");
  PointFile file = vtk                           ? parse_vtk(bytes, file_name)
                   : is_hdf5(bytes)              ? parse_hdf5(bytes, file_name)
                   : bytes.starts_with("ITEM: ") ? parse_dump(bytes, file_name)
                                                 : parse_point_table(bytes, file_name);
  take_positions(file, file_name);
  require_finite(file, file_name);
  sort_by_id(file, file_name);
  if (file.count == 0) throw InputError(file_name + " holds no points", "", "");
  return file;
}

PointFile read_points(const std::string& path) {
  return parse_points(read_text(path), path);
}

}  // namespace plumb
