#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/material/law.hpp"
#include "mms/export/formula.hpp"

namespace plumb::mms {

/// A solution with its loads as formulas of X (variables 0 .. d-1) and t (variable d). Tensors row by row.
struct SolutionFormulas {
  Formulas list;
  std::vector<int> u, v, a, F, P, b;  ///< b: rho a - Div P per reference volume
};

/// Throws InputError as source_text() does.
SolutionFormulas formulas_of(std::string_view name, int dimension,
                             const std::map<std::string, double>& parameters, const Elastic& elastic,
                             const LawChoice& law);

}  // namespace plumb::mms
