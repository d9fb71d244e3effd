#pragma once
#include <string>

namespace plumb::reports::theory {

/// One line of a formula of lib/THEORY.md ("F_i = sum_{j != i} (x_j - x_i) (x) c_ij") as a <math> element:
/// names of Greek letters, sum, grad, (x) and the like become signs, _ and ^ lower and raise, words stay
/// words. Nothing is left out and nothing is reordered: fractions keep their stroke. The line itself is the
/// alternative text.
std::string mathml(const std::string& line);

}  // namespace plumb::reports::theory
