#include "lib/output/sealed.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <charconv>
#include <cstdint>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

constexpr std::size_t block = 512;
constexpr std::string_view magic = "plumbline checkpoint 1\n";

/// CRC-64/XZ.
std::uint64_t checksum(std::string_view bytes) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::string heading(std::string_view bytes) {
  return fmt::format("{}bytes {}\ncrc64 {:016x}\n", magic, bytes.size(), checksum(bytes));
}

}  // namespace

std::string sealed(std::string_view bytes) {
  std::string all = heading(bytes);
  all.resize(block, '\0');
  return all.append(bytes);
}

std::string_view unsealed(std::string_view bytes) {
  if (!bytes.starts_with(magic))
    throw InputError("it is not a checkpoint of this format", "its first line differs", "");
  if (bytes.size() < block)
    throw InputError("it is cut off", fmt::format("it has {} bytes", bytes.size()), "");
  const std::string_view content = bytes.substr(block);
  const std::string_view length = bytes.substr(magic.size() + 6, 20);
  std::uint64_t stated = 0;
  std::from_chars(length.data(), length.data() + length.size(), stated);
  if (content.size() != stated)
    throw InputError("it is cut off or has grown",
                     fmt::format("{} bytes instead of {}", content.size(), stated), "");
  std::string expected = heading(content);
  expected.resize(block, '\0');
  if (bytes.substr(0, block) != expected) throw InputError("it is damaged", "its checksum differs", "");
  return content;
}

}  // namespace plumb
