#pragma once
#include <concepts>
#include <string_view>

#include "lib/core/types.hpp"
#include "lib/material/material.hpp"
#include "mms/ad/jet.hpp"
#include "mms/domain.hpp"
#include "mms/parameters.hpp"

namespace plumb::mms {

/// A manufactured solution is a value: a displacement u(X, t) [m] for any scalar type, with its parameters,
/// its domain and what is known on each face. Nothing else is needed: body force and tractions follow for
/// every material (derive.hpp). A new solution is one file in solutions/, with
///   name, summary      for `plumb mms --list`
///   in_dimension<d>    true for the dimensions it exists in
///   defaults()         its parameters
///   material()         elastic constants used when a study names none
///   S(parameters, elastic)
///   displacement<d>(X, t), domain<d>(), period()   period: characteristic time [s]
/// and, if it is at rest at all times, so that only `plumb static` can follow it,
///   still              true
template <class S, int d>
concept Solution = std::constructible_from<S, const Parameters&, const Elastic&> &&
    requires(const S& s, const Vec<d>& X, double t, const Vec<d, Jet<d + 1>>& Xj, const Jet<d + 1>& tj) {
  { S::name } -> std::convertible_to<std::string_view>;
  { S::summary } -> std::convertible_to<std::string_view>;
  { S::defaults() } -> std::same_as<Parameters>;
  { S::material() } -> std::same_as<Elastic>;
  { s.template displacement<d>(X, t) } -> std::convertible_to<Vec<d>>;
  { s.template displacement<d>(Xj, tj) } -> std::convertible_to<Vec<d, Jet<d + 1>>>;
  { s.template domain<d>() } -> std::same_as<Domain<d>>;
  { s.period() } -> std::same_as<double>;
};

/// The rubber of paper 000 with nu = 0.3: the default where a paper states no material.
inline Elastic soft_rubber() {
  return {17e6, 0.3, 1100};
}

/// Is the circumference of a circle over its diameter.
inline constexpr double pi = 3.141592653589793238462643383279502884;

}  // namespace plumb::mms
