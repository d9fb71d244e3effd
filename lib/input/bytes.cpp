// Base64 and zlib, for VTK's files.
#include <zlib.h>

#include <array>
#include <cstdint>

#include "lib/input/point_formats.hpp"

namespace plumb {
namespace {

constexpr std::array<std::int8_t, 256> values_of_digits() {
  std::array<std::int8_t, 256> values{};
  for (auto& value : values) value = -1;
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < digits.size(); ++k)
    values[static_cast<unsigned char>(digits[k])] = static_cast<std::int8_t>(k);
  return values;
}

}  // namespace

bool decode_base64(std::string_view text, std::string& bytes) {
  static constexpr std::array<std::int8_t, 256> values = values_of_digits();
  std::uint32_t group = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int value = values[static_cast<unsigned char>(c)];
    if (c == '=')
      ++padding;
    else if (value < 0 || padding > 0)
      return false;
    group = group << 6 | static_cast<std::uint32_t>(value < 0 ? 0 : value);
    if (++digits < 4) continue;
    if (padding > 2) return false;
    for (int k = 0; k < 3 - padding; ++k) bytes += static_cast<char>(group >> (16 - 8 * k) & 255);
    group = 0;
    digits = padding = 0;
  }
  return digits == 0;
}

bool inflate_exactly(std::string_view packed, std::size_t size, std::string& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + size);
  uLongf made = size;
  const int code =
      uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &made,
                 reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  return code == Z_OK && made == size;
}

}  // namespace plumb
