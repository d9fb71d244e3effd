#pragma once
#include <string_view>

#include "lib/input/point_file.hpp"

namespace plumb {

/// Readers of point_file.hpp, one for each format: columns as they stand there, positions among them or not.
PointFile parse_point_table(const std::string& text, const std::string& file_name);
PointFile parse_dump(const std::string& text, const std::string& file_name);
PointFile parse_vtk(const std::string& bytes, const std::string& file_name);
PointFile parse_hdf5(const std::string& bytes, const std::string& file_name);

/// Whether the bytes begin as those of an HDF5 file.
bool is_hdf5(const std::string& bytes);

/// Names under which positions are known, the first first.
const std::vector<std::string>& position_names();

/// Makes vectors and tensors of neighbouring columns: "ux", "uy" become "u", "F:0" to "F:8" become "F", "x",
/// "y" become "position" and "X", "Y" become "reference". One value per name and row.
std::vector<PointColumn> grouped_columns(const std::vector<std::string>& names,
                                         const std::vector<std::vector<double>>& rows);

/// The bytes that base64 text stands for; padding may stand between parts. False for what is no base64.
bool decode_base64(std::string_view text, std::string& bytes);

/// Inflates a zlib stream into exactly `size` bytes; false if it is another stream.
bool inflate_exactly(std::string_view packed, std::size_t size, std::string& bytes);

}  // namespace plumb
