#pragma once
#include <string>

#include "lib/core/error.hpp"
#include "lib/input/point_file.hpp"

namespace plumb {

/// Points, or why there are none, as bytes that another process of this program reads.
std::string bytes_of(const PointFile& file);
std::string bytes_of(const InputError& error);

/// The points. Throws the error, if the bytes are one.
PointFile points_of(const std::string& bytes);

}  // namespace plumb
