#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lib/scene/tlsph.hpp"

namespace plumb::app {

/// Sum of the entries [bytes].
std::size_t total_bytes(const std::vector<ArrayEntry>& arrays);

/// What the scene makes the program build, and what it leaves out: no code runs for that, no array is kept.
struct Parts {
  std::vector<std::string> built, left_out;
};
template <int d>
Parts parts_of(const Scene& scene, const TlsphBody<d>& simulation);

/// What a projected table says of itself (CompatibleReport); null without one.
nlohmann::ordered_json compatible_json(const CompatibleReport* report);
/// The same in a line of words; empty without one.
std::string compatible_text(const CompatibleReport* report);

/// Largest resident memory of this process so far [bytes].
std::size_t peak_resident_bytes();

/// Memory that the machine can still give without swapping [bytes]; 0 if it cannot be known.
std::size_t available_bytes();

}  // namespace plumb::app
