#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

class Section;
template <int d>
struct PartSite;

/// Chooses the projection of the force onto those without torque (paper 003, (64)-(67); THEORY (5.4)). It is
/// the section [projection] of a scene or study, which has no keys; without the section nothing of it is
/// built.
struct ProjectionOptions {
  static constexpr std::string_view section = "projection", subject = "projection",
                                    theory = "THEORY (5.4)-(5.6)";
  static constexpr std::string_view meaning = "takes the torque off the internal force";

  static std::optional<ProjectionOptions> read(const Section&) { return ProjectionOptions{}; }
  /// Says for a reader what it does.
  std::string in_words() const { return "the force loses its torque by the least change"; }
  /// Adds the term.
  template <int d>
  void add_to(PartSite<d>& site) const;
};

}  // namespace plumb
