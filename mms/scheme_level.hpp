#pragma once
#include "mms/level.hpp"

namespace plumb::mms {

/// Displacement, its gradient, velocity and first Piola-Kirchhoff stress of every particle, as the scheme
/// itself shows them.
template <int d>
NodalValues<d> nodal_values(const Snapshot<d>& shown);

/// run_level() for a study of a scheme other than "tlsph".
template <int d>
LevelRun<d> run_scheme_level(const Study& study, const Manufactured<d>& solution, double spacing,
                             const Loading& loading, Sitting& sitting);

}  // namespace plumb::mms
