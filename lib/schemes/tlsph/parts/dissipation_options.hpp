#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

class Section;
template <int d>
struct PartSite;

/// Chooses the dissipation between pairs, of fourth order and without a number that must be chosen: the form R^T S R of THEORY
/// (16.2), (16.3), for bodies whose force is the adjoint one. It is the section [dissipation] of a scene or study; without the
/// section nothing of it is built.
struct DissipationOptions {
  static constexpr std::string_view section = "dissipation", subject = "dissipation",
                                    theory = "THEORY (16.2), (16.3)";
  static constexpr std::string_view meaning = "dissipation between pairs";

  std::string kind = "upwind";

  /// Reads the section. Throws SceneError.
  static std::optional<DissipationOptions> read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Adds the term and its limit of the time step.
  template <int d>
  void add_to(PartSite<d>& site) const;
};

}  // namespace plumb
