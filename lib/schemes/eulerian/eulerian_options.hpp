#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

class Section;

/// Chooses a variant of the Eulerian-kernel scheme of paper 001: section [eulerian] of a scene. The defaults
/// are a force and a damping that are not in the paper.
struct EulerianOptions {
  static constexpr std::string_view section = "eulerian";

  std::string force =
      "adjoint";  ///< adjoint: minus the power of the stress | printed: (10), (11) | plain: (11) without (10)
  std::string damping = "objective";    ///< objective: half of the stress increment | extrapolated | none
  std::string hourglass = "stiffness";  ///< stiffness (32) | viscous (33) | mixed (34) | none
  bool incremental_error = false;  ///< (31) since the latest reference only: errors before it are forgotten
  double xi = 0.5;                 ///< of (32)
  double xi_tension = 0;           ///< how tension raises xi, THEORY (18.11); not in the paper
  double zeta = 10;                ///< of (33)
  double chi = 0.5;                ///< of (34): share of (33)
  double viscosity_linear = 0;     ///< alpha of (17)
  double viscosity_quadratic = 0;  ///< beta of (17)
  double artificial_stress = 0;    ///< epsilon of (11)
  double artificial_exponent = 4;  ///< n of (11)
  double diffusion = 0;            ///< delta of (21)
  double beta = 1.3;               ///< h/dp
  double skin = 0.4;               ///< dp: how much farther the list of neighbours looks
  long rereference = 0;  ///< steps from one reference of (30) to the next; 0: one with each new list
  /// Equations that are taken as they are printed: "32" and "33", whose signs drive what they should stop.
  std::vector<std::string> misprints;
  double cfl = 0.5;  ///< dt c_p/h; key [method] cfl

  /// What is not given is that of `otherwise`.
  static EulerianOptions read(const Section& section, EulerianOptions otherwise);
  /// Those of the paper, with its misprints mended and the damping without which it does not run.
  static EulerianOptions of_paper();
  std::string in_words() const;
  std::vector<std::string> warnings() const;

  bool misprinted(std::string_view equation) const {
    return std::find(misprints.begin(), misprints.end(), equation) != misprints.end();
  }
  bool printed() const { return force == "printed"; }
  bool adjoint() const { return force == "adjoint"; }
  bool controls_hourglass() const { return hourglass != "none"; }
  bool has_viscosity() const { return viscosity_linear > 0 || viscosity_quadratic > 0; }
  /// Weight of (32) in the choice of hourglass control.
  double stiffness_share() const { return hourglass == "stiffness" ? 1 : hourglass == "mixed" ? 1 - chi : 0; }
  /// Factors of (32), without tension, and of (33), as the choice weighs them.
  double stiffness() const { return stiffness_share() * xi; }
  double viscous() const { return hourglass == "viscous" ? zeta : hourglass == "mixed" ? chi * zeta : 0; }
};

/// Reads the sections [viscosity] and [artificial_stress] of a scene, other names of keys of [eulerian].
void read_sections_beside(const Section& root, EulerianOptions& options);

}  // namespace plumb
