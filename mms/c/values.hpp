#pragma once
#include <limits>
#include <vector>

#include "mms/c/plumbline.h"

namespace plumb::c {

/// What the library says of a number that is not there [-].
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A quantity of the solution at points, as plumb_evaluate() gives it. Throws InputError.
std::vector<double> values_of(const plumb_solution& solution, plumb_quantity quantity, std::size_t points,
                              const double* X, double time);

}  // namespace plumb::c
