#pragma once
#include <map>
#include <string>
#include <vector>

#include "verification/plumb/foreign/points.hpp"
#include "verification/plumb/foreign/solution_choice.hpp"

namespace plumb::app {

/// Errors of one file against a solution, by name: "l2", "linf", "relative_l2" of the displacement,
/// "l2_inside" and "l2_boundary" of its parts farther from the boundary and nearer to it than a tenth of the
/// domain; "velocity_l2", "h1" (of F), "stress_l2" (of P), "cauchy_l2" where the file has them.
struct ForeignErrors {
  std::string file;
  std::size_t points = 0;
  double spacing = 0;  ///< [m]
  double volume = 0;   ///< of all points [m^d]
  bool estimated_volumes = false;
  std::map<std::string, double> norms;
  std::vector<double> worst;           ///< where the displacement is farthest off: a reference position [m]
  std::vector<std::string> suspicion;  ///< what the error of this level alone looks like, most likely first
  std::string region;                  ///< where it lies
};

/// Compares the file at that time [s]. Throws InputError as foreign_field() does.
ForeignErrors errors_of(const std::string& file, const SolutionChoice& choice, double time,
                        const PointOptions& options);

}  // namespace plumb::app
