#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumb {

class Section;
template <int d>
struct PartSite;

/// Chooses the hourglass energy, THEORY (12.1) or (12.3). It is the section [hourglass] of a scene or study;
/// without the section nothing of it is built.
struct HourglassOptions {
  static constexpr std::string_view section = "hourglass", subject = "hourglass",
                                    theory = "THEORY (12.1), (12.2)";
  static constexpr std::string_view meaning = "hourglass energy of what no affine motion explains";

  std::string weight = "kernel";  ///< kernel | slope: W, or -W' r about the best affine motion (paper 004)
  /// Dimensionless; the larger, the less alternating motion and the stiffer a coarse bend. 2 completes the
  /// columns of paper 003 and the plate of large amplitude at nu 0.495, THEORY chapter 12.
  double alpha = 2;

  /// Reads the section; nullopt if alpha is 0. Throws SceneError.
  static std::optional<HourglassOptions> read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Adds the term.
  template <int d>
  void add_to(PartSite<d>& site) const;
};

}  // namespace plumb
