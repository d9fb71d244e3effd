#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

class Section;

/// Chooses a variant of the updated Lagrangian scheme of paper 002: section [updated] of a scene. The
/// defaults are the form that keeps both momenta, which is not in the paper.
struct UpdatedOptions {
  static constexpr std::string_view section = "updated";

  std::string form = "gno";              ///< og: no control of hourglass modes | eno: (25) | gno: (45)
  std::string penalty = "projected";     ///< projected on the pair (46) | vector (43); of gno
  std::optional<double> xi;              ///< absent: 3.5 in 2D and 4.2 in 3D of eno, 2 of gno
  std::string balance = "conservative";  ///< conservative: both momenta to round-off | printed
  std::string rotation = "none";        ///< of what has been summed up (34), (42): none | own | mean; printed
  std::string geometry = "step";        ///< new at every step | advection: frozen for the time (22); printed
  std::string dissipation = "riemann";  ///< riemann (17) | none
  bool reaction = true;                 ///< stress that answers for the velocity gradients in the penalty
  bool yield_ratio = true;              ///< the penalty falls with the stress that a return takes away
  std::string deviator = "plane-strain";  ///< of strains in 2D: plane-strain | two-dimensional (8)
  std::string stress_update = "rotate";   ///< R s R^T | jaumann: dt (s Omega^T + Omega s) (8)
  std::string speed = "pressure";         ///< of the step: pressure waves of the discrete body | bulk (23)
  double beta = 1.3;                      ///< h/dp
  double skin = 0.35;                     ///< dp: how much farther the list of neighbours looks
  double guard = 0.15;  ///< B is blended with I where det M falls below this share of its start; 0: never
  double advection_cfl = 0.2;             ///< of (22)
  std::optional<double> reference_speed;  ///< [m/s]: (22) takes no smaller one
  std::optional<double> tension_limit;    ///< [Pa]: the pressure falls no lower than minus this
  /// Equations that are taken with their misprints: "17" (pressure of a pair), "49" (V_i V_j for V_j);
  /// printed.
  std::vector<std::string> misprints;
  double cfl = 0.5;  ///< of (23); key [method] cfl

  /// What is not given is that of `printed`.
  static UpdatedOptions read(const Section& section, UpdatedOptions otherwise);
  /// Those of the paper, with its misprints mended.
  static UpdatedOptions of_paper();
  std::string in_words() const;
  std::vector<std::string> warnings() const;

  bool misprinted(std::string_view equation) const {
    return std::find(misprints.begin(), misprints.end(), equation) != misprints.end();
  }
  bool conservative() const { return balance == "conservative"; }
  bool has_bonds() const { return form != "og"; }  ///< a force between pairs that is summed up in time
  bool bonds_react() const { return form == "gno" && conservative() && reaction && strength(2) > 0; }
  double strength(int d) const {
    return xi.value_or(form == "eno" ? (d == 2 ? 3.5 : 4.2) : 2.0) * (form == "eno" ? 2 : 1);
  }
};

/// InputError where choices contradict each other.
void require_consistent(const UpdatedOptions& options);

}  // namespace plumb
