#pragma once
#include <concepts>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/quantity.hpp"
#include "lib/material/material.hpp"

/// What every law of the catalogue has beside its stress: parameters of its
/// own, read from a scene by name and unit. A law with parameters holds
///   struct Parameters { double ratio = 0.25; void fields(auto&& visit) {
///   visit(LawParameter{..}, ratio); }
///   };
/// and a constructor from Elastic and Parameters; one without has a constructor
/// from Elastic alone.
namespace plumb {

/// What holds in the third direction of a body in 2D: F_33 = 1, or F_33 such
/// that P_33 = 0.
enum class Plane { strain, stress };

/// The constants of small strains in d dimensions. Under plane stress those
/// with which plane strains give its stress, THEORY (4.11).
inline Elastic in_dimension(int d, const Elastic& e, Plane plane) {
  if (d != 2 || plane == Plane::strain) return e;
  return {e.young * (1 + 2 * e.poisson) / ((1 + e.poisson) * (1 + e.poisson)), e.poisson / (1 + e.poisson),
          e.density};
}

/// One number of a law as a scene gives it. E, nu and rho are not among them:
/// all laws share Elastic.
struct LawParameter {
  std::string_view name;     ///< its key in [material]
  Quantity quantity;         ///< its unit
  std::string_view meaning;  ///< for lists and messages
  Sign sign = Sign::any;
  double most = std::numeric_limits<double>::infinity();
  bool required = false;         ///< there is no default
  std::string_view symbol = {};  ///< the letter that the paper has for it, a second key; empty: none

  /// Returns the same parameter with that symbol.
  constexpr LawParameter called(std::string_view letter) const {
    LawParameter same = *this;
    same.symbol = letter;
    return same;
  }
};

/// A law by its name, with the values of its parameters in SI units; those left
/// out keep their defaults.
struct LawChoice {
  std::string name;
  std::map<std::string, double> parameters;
  Plane plane = Plane::strain;  ///< of bodies in 2D

  LawChoice(std::string law, std::map<std::string, double> values, Plane in_2d = Plane::strain)
      : name(std::move(law)), parameters(std::move(values)), plane(in_2d) {}
  explicit LawChoice(std::string law) : name(std::move(law)) {}
};

/// Stands for the parameters of a law that has none.
struct NoParameters {
  template <class Visit>
  void fields(Visit&&) {}
};

/// Finds the type of a law's own parameters: none, or its `Parameters`.
template <class M>
struct ParametersOfLaw {
  using type = NoParameters;
};
template <class M>
requires requires {
  typename M::Parameters;
}
struct ParametersOfLaw<M> {
  using type = typename M::Parameters;
};
template <class M>
using ParametersOf = typename ParametersOfLaw<M>::type;

/// The value if the parameter may have it; otherwise InputError.
double allowed(const LawParameter& about, double value);
/// InputError for names in the choice that are not among `known`.
void refuse_unknown_parameters(const LawChoice& choice, const std::vector<std::string>& known);
/// InputError: the law needs that parameter.
[[noreturn]] void refuse_missing(const LawChoice& choice, const LawParameter& about);

/// The parameters of law M: those of the choice, defaults for the rest.
/// InputError for a name that the law does not know, a value out of range, and
/// one that is required and not there.
template <class M>
ParametersOf<M> parameters_of(const LawChoice& choice) {
  ParametersOf<M> values;
  std::vector<std::string> known;
  values.fields([&](const LawParameter& about, auto& value) {
    const auto given = choice.parameters.find(std::string(about.name));
    if (given != choice.parameters.end())
      value = allowed(about, given->second);
    else if (about.required)
      refuse_missing(choice, about);
    known.emplace_back(about.name);
  });
  refuse_unknown_parameters(choice, known);
  return values;
}

/// Law M with these elastic constants and the parameters of the choice.
template <class M>
M make_law(const Elastic& elastic, const LawChoice& choice) {
  [[maybe_unused]] const ParametersOf<M> parameters = parameters_of<M>(choice);
  if constexpr (std::constructible_from<M, Elastic, ParametersOf<M>>)
    return M(elastic, parameters);
  else
    return M(elastic);
}

/// True unless a law says that superposed rotations change its stress: `static
/// constexpr bool objective = false`.
template <class M>
inline constexpr bool is_objective = true;
template <class M>
requires requires {
  M::objective;
}
inline constexpr bool is_objective<M> = M::objective;

/// What a law of the catalogue can be given. InputError for an unknown name.
std::vector<LawParameter> parameters_of_law(std::string_view name);
/// True if the stress of that law depends on what was before. InputError for an
/// unknown name.
bool has_history(std::string_view name);
/// InputError unless there is that law, with parameters that it accepts.
void require_law(const LawChoice& choice, const Elastic& elastic);

}  // namespace plumb
