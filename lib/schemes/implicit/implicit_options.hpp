#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/schemes/implicit/linear_solver.hpp"

namespace plumb {

class Section;

/// Chooses how equilibria are sought on the way from no load to the load at the end time, or steps in time
/// are made. It is the section [implicit] of a scene; without the section these are the defaults.
struct ImplicitOptions {
  static constexpr std::string_view section = "implicit", subject = "steps",
                                    theory = "THEORY (15.1) to (15.6), (15.12) to (15.14)";

  long steps = 4;                   ///< load steps to the end time, if none has to be halved
  std::optional<double> time_step;  ///< [s]: gives the number of steps instead
  bool adaptive = true;             ///< steps are halved on failure, and grow where Newton's method is quick
  std::optional<double>
      arc_length;            ///< [m]: steps move the particles by that (root mean square); the load is found
  double tolerance = 1e-10;  ///< residual relative to the forces
  LinearSolver solver = LinearSolver::direct;  ///< with the tangent
  bool midpoint = false;                       ///< dynamics = "midpoint": steps in time instead of equilibria
  bool energy_momentum = false;                ///< dynamics = "energy-momentum": likewise, with exact energy
  bool trapezoid = false;                      ///< dynamics = "trapezoid": likewise, by the trapezoidal rule
  /// Equations of paper 004 that are taken with their misprints: "27" (sign of the hourglass forces), "29" (half of their
  /// stiffness), "61" (a term of the tangent of neo-hookean-logarithmic).
  std::vector<std::string> misprints;

  bool misprinted(std::string_view equation) const {
    return std::find(misprints.begin(), misprints.end(), equation) != misprints.end();
  }
  bool moves() const { return midpoint || trapezoid || energy_momentum; }  ///< in time, with inertia
  /// Reads the section. Throws SceneError.
  static ImplicitOptions read(const Section& section);
  /// Says for a reader what it is set to.
  std::string in_words() const;
  /// Returns the first load step as a share of the path to `end_time` [s].
  double first_step(double end_time) const;

 private:
  std::string steps_in_words() const;
};

}  // namespace plumb
