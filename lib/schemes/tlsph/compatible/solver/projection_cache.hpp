#pragma once
#include <filesystem>
#include <string>

#include "lib/schemes/tlsph/compatible/area_vectors.hpp"

namespace plumb {

/// A folder of projected tables, each under a name made from all that its projection depends on: positions,
/// start vectors, weights, volumes, boundary vectors (in units of the spacing) and how readily volumes
/// change. Another cloud, kernel or start table has another name; files may be removed at any time.

/// The name of the file for this start table: 64 bits of a checksum over its content, and its size.
template <int d>
std::string projection_name(const AreaTable<d>& start, double volume_weight);

/// Replaces area vectors and volumes by those in the file, if it is there, whole and of the same size.
template <int d>
bool read_projection(const std::filesystem::path& file, AreaTable<d>& table);

/// Writes them as one file (replace_file). Makes the folder; InputError if that cannot be done.
template <int d>
void write_projection(const std::filesystem::path& file, const AreaTable<d>& table);

}  // namespace plumb
