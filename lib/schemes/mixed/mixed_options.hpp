#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

class Section;

/// Chooses among the variants of the scheme of paper 003. It is the section [mixed] of a scene.
struct MixedOptions {
  static constexpr std::string_view section = "mixed", subject = "mixed", theory = "THEORY (16.1)";

  std::string volumes = "equal";  ///< weights in the kernel sums: equal | tributary, as (41) has them
  std::string gradient =
      "corrected";  ///< corrected: kernel sums (41), (42) | compatible: the table of THEORY chapter 11
  std::string kinematics = "tied";  ///< tied: H = cof F, J = det F | evolved: by (55), (56)
  std::string upwind = "adjoint";   ///< none | constant | reconstructed, the paper's | adjoint
  bool diffuses_J =
      false;  ///< D^j of (59), (60): the jump of Sigma_J between pairs, constant states; kinematics evolved
  int option = 0;         ///< 0: the reference is never updated; 1 to 4: kernels of (49), (50), (51), (52)
  long update_every = 1;  ///< steps between updates of the reference, if option is not 0
  bool smooth_positions = false;  ///< particles move with the smoothed velocity, Algorithm 1, line 15
  double list = 1.75;             ///< radius of the neighbour list over the spacing
  bool projects =
      false;         ///< internal forces lose their torque, (64) to (67); the section [projection] of a scene
  double cfl = 0.9;  ///< alpha of (62); [method] cfl of a scene

  bool evolves_HJ() const { return kinematics == "evolved"; }
  /// F is an unknown of its own where it cannot be found from the positions.
  bool evolves_F() const { return evolves_HJ() || smooth_positions; }

  /// Reads the section; keys that it leaves out keep the values of `o`. Throws SceneError.
  static MixedOptions read(const Section& section, MixedOptions o);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Says what a user should know about this choice before a run; a sentence each.
  std::vector<std::string> warnings() const;
};

}  // namespace plumb
