#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace plumb::mms {

/// Outcome of comparing the two derivations of one solution with one material in one dimension.
struct SolutionCheck {
  std::string solution, material;
  int dimension;
  std::size_t points;
  double force;     ///< worst |s_1 - s_2| / scale
  double traction;  ///< worst |(P_1 - P_2) N| / scale
  double velocity;  ///< worst |v_1 - v_2| T / |u|
  bool passed;      ///< all at most check_tolerance
};

/// 1e-10: round-off of the first derivation is below 1e-12 even for kappa/mu = 1e4; the truncation of the
/// second below 1e-12.
inline constexpr double check_tolerance = 1e-10;

/// Compares the automatic derivation with a second, independent one: central differences of eighth order in
/// long double, applied to u for F and to P(F(u)) for Div P, and to u twice for u_tt. Points, times and
/// parameters are drawn anew each time, and the elastic constants too (E 1e3..1e9 Pa, nu 0.. 0.4999, rho
/// 100..1e4 kg/m^3). Forces are compared relative to
///   rho |u_tt| + mu (|Grad F| + |F - I|/L + 0.01/L),  L the domain's length: not to |s|, which may vanish.
/// All materials of the library, all dimensions of the solution. InputError for an unknown name.
std::vector<SolutionCheck> check_solution(std::string_view name, std::size_t points = 1000,
                                          std::uint64_t seed = 1);

}  // namespace plumb::mms
