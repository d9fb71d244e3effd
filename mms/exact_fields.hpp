#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "mms/manufactured.hpp"

namespace plumb::mms {

/// A solution of the catalogue with any law of the catalogue, as functions of the reference position X [m]
/// and the time t [s]: what a solver that is not Plumbline's needs.
template <int d>
struct ExactFields {
  double density = 0;  ///< rho_0 [kg/m^3]
  double period = 0;   ///< characteristic time [s]
  Domain<d> domain;
  std::function<Motion<d>(const Vec<d>& X, double t)> motion;
  std::function<Mat<d>(const Vec<d>& X, double t)> first_piola;        ///< P [Pa]
  std::function<Vec<d>(const Vec<d>& X, double t)> stress_divergence;  ///< Div P [Pa/m]

  /// Gives the Cauchy stress P F^T / J [Pa].
  Mat<d> cauchy(const Vec<d>& X, double t) const {
    const Mat<d> F = motion(X, t).F;
    return first_piola(X, t) * F.transpose() / F.determinant();
  }
  /// Gives rho u_tt - Div P per reference volume [N/m^d]: with this load u is the solution.
  Vec<d> body_force(const Vec<d>& X, double t) const {
    return density * motion(X, t).acceleration - stress_divergence(X, t);
  }
};

/// Makes the fields. Elastic laws are those of manufactured(): exact to round-off. The stress of a law with
/// history is that of the motion from 0 to t in `increments` equal steps, and its divergence is a central
/// difference of eighth order over 1/800 of the domain: to about 1e-10 of the stress over the length where
/// the stress is smooth, and less near the edge of a plastic zone. Throws InputError as manufactured() does.
template <int d>
ExactFields<d> exact_fields(std::string_view name, const std::map<std::string, double>& parameters,
                            const Elastic& elastic, const LawChoice& law, int increments = 100);

}  // namespace plumb::mms
