#pragma once
#include <string>
#include <vector>

#include "mms/exact_fields.hpp"
#include "verification/plumb/foreign/points.hpp"

namespace plumb::app {

/// Says what the error of a displacement looks like: another time, a factor (a slip of units where it is a
/// power of ten), exchanged components. Each sentence explains all of the error but a fifth; there may be
/// none. A level that is coarse can look so too: only where refinement does not lessen the error is it a
/// mistake.
template <int d>
std::vector<std::string> suspicion(const ForeignField<d>& field, const mms::ExactFields<d>& exact,
                                   double time);

/// Says how much of the squared error lies within two spacings of the boundary, and where to look.
template <int d>
std::string region(const ForeignField<d>& field, const mms::ExactFields<d>& exact, double time);

}  // namespace plumb::app
