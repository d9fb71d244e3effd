#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lib/material/law.hpp"
#include "mms/derive.hpp"
#include "mms/domain.hpp"
#include "mms/parameters.hpp"

namespace plumb::mms {

/// A solution of the catalogue with its parameters, and a material: what a study needs, for any choice at run
/// time.
template <int d>
struct Manufactured {
  std::string name;
  double density;  ///< rho_0 [kg/m^3]
  double period;   ///< characteristic time [s]
  Domain<d> domain;
  bool still = false;  ///< it does not move: a field at rest
  std::function<Motion<d>(const Vec<d>& X, double t)> motion;
  std::function<Mat<d>(const Mat<d>& F)> first_piola;                ///< P [Pa]
  std::function<Vec<d>(const Motion<d>& motion)> stress_divergence;  ///< Div P [Pa/m]

  Vec<d> displacement(const Vec<d>& X, double t) const { return motion(X, t).displacement; }  ///< u [m]
  Vec<d> velocity(const Vec<d>& X, double t) const { return motion(X, t).velocity; }          ///< u_t [m/s]
  /// s = rho u_tt - Div P(F(u)) per reference volume [N/m^3]: with this load u is the solution.
  Vec<d> body_force(const Vec<d>& X, double t) const {
    const Motion<d> m = motion(X, t);
    return density * m.acceleration - stress_divergence(m);
  }
  /// P N per reference area [Pa], for the outward unit normal N of the reference configuration.
  Vec<d> traction(const Vec<d>& X, double t, const Vec<d>& N) const {
    return first_piola(motion(X, t).F) * N;
  }
};

/// One entry of `plumb mms --list`.
struct SolutionEntry {
  std::string name, summary;
  std::vector<int> dimensions;
  Parameters parameters;
  Elastic material;
};

/// All solutions, by name.
std::vector<SolutionEntry> solution_list();
/// Returns the names that solution_list() has.
std::vector<std::string> solution_names();
/// One of them; InputError with the nearest name.
SolutionEntry solution_entry(std::string_view name);

/// The solution of that name with parameters (those left out keep their defaults) for a material of the
/// library. InputError for unknown names, values out of range, or a dimension that the solution does not
/// exist in. Under plane stress the solution's waves and periods are those of (4.11).
template <int d>
Manufactured<d> manufactured(std::string_view name, const std::map<std::string, double>& parameters,
                             const Elastic& elastic, const LawChoice& law = LawChoice("neo-hookean"));

}  // namespace plumb::mms
