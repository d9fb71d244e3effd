#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

class Section;
template <int d>
struct PartSite;

/// Chooses a damping that is proportional to the mass, f = -rho rate v, THEORY (6.6). It is the section
/// [damping] of a scene or study; without the section nothing of it is built. It needs no memory.
struct DampingOptions {
  static constexpr std::string_view section = "damping", subject = "damping", theory = "THEORY (6.6)";
  static constexpr std::string_view meaning = "damping proportional to the mass";

  double rate = 0;  ///< [1/s]: free motion decays by exp(-rate t/2)

  /// Reads the section; nullopt if the rate is 0. Throws SceneError.
  static std::optional<DampingOptions> read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Adds the term and its limit of the time step.
  template <int d>
  void add_to(PartSite<d>& site) const;
};

}  // namespace plumb
