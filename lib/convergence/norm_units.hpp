#pragma once
#include <string>
#include <string_view>

namespace plumb {

/// What the norms of an error are, in a sentence or two for tables, pictures and the report.
inline constexpr std::string_view norms_explained =
    "An L2 norm is the square root of the integral of the squared error over the reference volume, so "
    "its unit is that of the quantity times m^(d/2): m^2 in 2D and m^2.5 in 3D for a displacement. A "
    "relative error is the norm of the error over the same norm of the exact field, by the same quadrature.";

/// Gives the unit of a norm in d dimensions: of "l2" and "l2_gauss" m^2 in 2D and m^2.5 in 3D, of "h1" (the
/// gradient) m and m^1.5, of "linf" m, of "velocity_l2" m^2/s and m^2.5/s, of "stress_l2" Pa m and Pa m^1.5.
/// Empty for "relative_l2" and all others that have none.
std::string unit_of_norm(std::string_view norm, int dimension);

/// Gives the name with its unit, as heads of tables have it: "l2 [m^2]"; the name alone where there is none.
std::string with_unit(std::string_view norm, int dimension);

}  // namespace plumb
