#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/material/law.hpp"

namespace plumb::mms {

/// The languages that a solution can be written in.
inline constexpr std::string_view source_languages[] = {"c", "fortran", "python"};

/// Writes a solution with its loads as a function in "c", "fortran" or "python": u, v, a, F, P and the body
/// force rho a - Div P per reference volume as functions of X and t. The text stands alone. The formulas are
/// those of the solution and the law themselves, which are templates, with derivatives of every operation;
/// numbers have 17 digits. Parameters and constants are written as their values. Throws InputError for laws
/// with history, for plane stress (F_33 is found by iterations) and as manufactured() does.
std::string source_text(std::string_view language, std::string_view name, int dimension,
                        const std::map<std::string, double>& parameters, const Elastic& elastic,
                        const LawChoice& law);

}  // namespace plumb::mms
