#include "lib/schemes/tlsph/compatible/solver/projection_cache.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstring>

namespace plumb {
namespace {

/// Changes whenever the projection would find another table from the same start.
constexpr std::string_view method = "compatible 2";

template <int d>
std::size_t bytes_of(const AreaTable<d>& table) {
  return sizeof(double) * (d * table.pairs.size() + table.volume.size());
}

}  // namespace

template <int d>
std::string projection_text(const AreaTable<d>& start, double volume_weight) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true> crc;
  const auto add = [&crc](const auto& value) { crc.process_bytes(&value, sizeof(value)); };
  crc.process_bytes(method.data(), method.size());
  add(volume_weight);
  for (const auto& pair : start.pairs) {
    add(pair.i);
    add(pair.j);
    for (int k = 0; k < d; ++k) add(pair.X[k]);
    for (int k = 0; k < d; ++k) add(pair.A[k]);
    add(pair.weight);
  }
  for (const double volume : start.volume) add(volume);
  for (const auto& B : start.boundary)
    for (int k = 0; k < d; ++k) add(B[k]);
  return fmt::format("{}d-{}-{}-{:016x}", d, start.particles(), start.pairs.size(), crc.checksum());
}

template <int d>
bool read_projection(std::string_view bytes, AreaTable<d>& table) {
  if (bytes.size() != bytes_of(table)) return false;
  const char* at = bytes.data();
  const auto next = [&at] {
    double value = 0;
    std::memcpy(&value, at, sizeof(value));
    at += sizeof(value);
    return value;
  };
  for (auto& pair : table.pairs)
    for (int k = 0; k < d; ++k) pair.A[k] = next();
  for (double& volume : table.volume) volume = next();
  return true;
}

template <int d>
std::string projection_bytes(const AreaTable<d>& table) {
  std::string bytes;
  bytes.reserve(bytes_of(table));
  const auto add = [&bytes](double value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (const auto& pair : table.pairs)
    for (int k = 0; k < d; ++k) add(pair.A[k]);
  for (const double volume : table.volume) add(volume);
  return bytes;
}

#define PLUMB_INSTANTIATE(d)                                            \
  template std::string projection_text<d>(const AreaTable<d>&, double); \
  template std::string projection_bytes<d>(const AreaTable<d>&);        \
  template bool read_projection<d>(std::string_view, AreaTable<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
