#pragma once
#include <string>
#include <string_view>

namespace plumb {

/// Bytes with a block of 512 bytes in front that states, as text, their length and their CRC-64: what was cut
/// off or changed anywhere is found before anything is read from it.
std::string sealed(std::string_view bytes);

/// The bytes behind the block. Throws InputError that says what is wrong: no block, cut off, or changed.
std::string_view unsealed(std::string_view bytes);

}  // namespace plumb
