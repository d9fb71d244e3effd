#pragma once
#include <string>
#include <string_view>

#include "lib/schemes/tlsph/compatible/area_vectors.hpp"

namespace plumb {

/// Says in a text all that a projection depends on: positions, start vectors, weights, volumes, boundary vectors (in
/// units of the spacing) and how readily volumes change, by 64 bits of a checksum and by their number. Another cloud,
/// kernel or start table has another text.
template <int d>
std::string projection_text(const AreaTable<d>& start, double volume_weight);

/// Returns area vectors and volumes as bytes.
template <int d>
std::string projection_bytes(const AreaTable<d>& table);

/// Replaces area vectors and volumes by those in the bytes; false if the bytes are of another size.
template <int d>
bool read_projection(std::string_view bytes, AreaTable<d>& table);

}  // namespace plumb
