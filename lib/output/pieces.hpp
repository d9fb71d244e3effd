#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

#include "lib/output/file.hpp"

namespace plumb {

/// Takes the next piece of a file.
using WritePiece = std::function<void(std::string_view)>;

/// As replace_file() for content that is made piece by piece, so that it need not fit into memory: `make` is
/// called once, with what takes the pieces.
void replace_file_in_pieces(const std::filesystem::path& path,
                            const std::function<void(const WritePiece& write)>& make,
                            Flush flush = Flush::now);

}  // namespace plumb
