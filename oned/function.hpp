#pragma once
#include <string>
#include <vector>

#include "lib/kernel/correction.hpp"
#include "oned/cloud.hpp"

namespace plumb::oned {

/// One line of `plumb oned function`.
struct FunctionRow {
  Correction pair;
  std::string field;
  double X;      ///< [m]
  double exact;  ///< f
  double value;  ///< sum_j V_j W~_ij f_j
  double error;  ///< value - exact
};

/// The function itself, f_i = sum_j V_j W~_ij f_j, at every particle: field by field, the kernels within. W0
/// has the kernel of W0raw. InputError as windows().
std::vector<FunctionRow> function_rows(const Discretisation& discretisation,
                                       const std::vector<TestField>& fields,
                                       const std::vector<Correction>& pairs);

}  // namespace plumb::oned
