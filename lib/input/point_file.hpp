#pragma once
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// One quantity of every point: point after point, `components` numbers each (tensors row by row).
struct PointColumn {
  std::string name;  ///< without its unit in brackets
  int components = 1;
  std::vector<double> values;
};

/// Points with what is known of them, as other programs write them.
struct PointFile {
  std::size_t count = 0;
  int axes = 3;                   ///< coordinates that the file gives of a point: 1 to 3
  std::vector<double> positions;  ///< as the file has them: x, y, z of each point; z is 0 where there is none
  std::vector<PointColumn> columns;
  std::optional<double> time;  ///< where the file says it; its unit is that of the file

  /// The first column that has one of the names, capitals and small letters alike; null if none has.
  const PointColumn* find(const std::vector<std::string>& names) const;
  /// The names of all columns, for messages.
  std::vector<std::string> names() const;
};

/// Reads a table (.csv and all other names), VTK's .vtp or .vtu in any of its encodings, HDF5 with named data
/// sets, or a LAMMPS dump (the last two known by how they begin). A table with x and without y is a bar's. Of HDF5 the group is read that holds
/// positions; its data sets of as many rows are the columns. Tables have x, y (and z) in columns of those names, or in the first two or
/// three where there is no heading; neighbouring columns such as ux, uy or F:0 to F:3 become a vector or
/// tensor. Points are put in the order of their "id" where there is one. Throws InputError with the place for
/// what cannot be read, is not finite, or stands twice.
PointFile read_points(const std::string& path);

/// Reads points from the bytes of a file; its name decides the format.
PointFile parse_points(const std::string& bytes, const std::string& file_name);

}  // namespace plumb
