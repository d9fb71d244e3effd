#pragma once
#include <optional>
#include <string>
#include <vector>

#include "verification/plumb/foreign/points.hpp"

namespace plumb::app {

/// One instant of a run: a file, and its time where it is known.
struct Instant {
  std::string file;
  std::optional<double> time;  ///< [s]
};

/// The instants of a run: those that the .pvd of a folder names, else all .vtp and .vtu files of it by name;
/// or one file. Throws InputError if there is none.
std::vector<Instant> instants_of(const std::string& folder_or_file);

/// How far B is from A at one time. Weights are the volumes of A, or equal parts of 1.
struct Difference {
  std::optional<double> time;         ///< [s]
  double l2 = 0, linf = 0;            ///< of the displacements [m m^(d/2)], [m]
  double size = 0;                    ///< l2 of A's displacement
  std::optional<double> velocity_l2;  ///< where both have velocities
  std::size_t points = 0;             ///< of A that B covers
  bool same_points = false;           ///< A and B have the same points; else B is interpolated
  bool between = false;               ///< B is interpolated in time
};

/// Compares two runs at the times of A that lie within those of B, at the points of A. B's values there are
/// its own, or those of a linear fit to the nearest of its points; between its instants they are interpolated
/// linearly. Throws InputError if they have no time or no dimension in common.
std::vector<Difference> compare_runs(const std::string& a, const std::string& b, const PointOptions& options);

}  // namespace plumb::app
