#pragma once
#include <string>

#include "verification/plumb/foreign/solution_choice.hpp"

namespace plumb::app {
struct Session;

/// Options of `plumb mms --export`.
struct ExportOptions {
  std::string format;  ///< c | fortran | python | csv; empty: nothing is exported
  std::string points;  ///< csv: a file of reference positions
  std::string time;    ///< csv: with or without unit
  std::string out;     ///< file; empty: standard output
  SolutionOptions solution;
};

/// Writes the solution as source text, or its values at points as a table.
int export_solution(const Session& session, const ExportOptions& options);

/// The values of a solution at points and a time as a table: X, Y, ux, uy, vx, .., ax, .., F11, .., P11, ..,
/// the body force bx, by per volume and gx, gy per mass, and the load of the equilibrium -Div P, sx, sy.
std::string values_at(const SolutionChoice& choice, const std::vector<double>& positions, double time);

}  // namespace plumb::app
