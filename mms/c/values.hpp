#pragma once
#include <vector>

#include "mms/c/plumbline.h"

namespace plumb::c {

/// A quantity of the solution at points, as plumb_evaluate() gives it. Throws InputError.
std::vector<double> values_of(const plumb_solution& solution, plumb_quantity quantity, std::size_t points,
                              const double* X, double time);

}  // namespace plumb::c
