#pragma once
#include <type_traits>

#include "lib/core/error.hpp"
#include "lib/material/catalogue.hpp"  // made by CMake from material/models/*.hpp
#include "lib/material/history.hpp"
#include "lib/material/plane_stress.hpp"

/// The laws of the catalogue by kind: elastic ones have an energy W(F), the others a history.
namespace plumb {

/// Joins lists of types, and picks from a list the laws that have an energy.
template <class... As, class... Bs>
TypeList<As..., Bs...> operator+(TypeList<As...>, TypeList<Bs...>) {
  return {};
}
template <class... Ms>
auto elastic_among(TypeList<Ms...>) {
  return (TypeList<>{} + ... + std::conditional_t<MaterialModel<Ms, 3>, TypeList<Ms>, TypeList<>>{});
}
using ElasticLaws = decltype(elastic_among(MaterialCatalogue{}));

/// Calls use(law) with the elastic law of that choice in d dimensions, under plane stress if it says so.
/// `use` returns nothing. InputError for an unknown name and for a law with history.
template <int d, class Use>
void with_elastic_law(const LawChoice& choice, const Elastic& elastic, Use&& use) {
  require_law(choice, elastic);
  const bool found = with_named(ElasticLaws{}, choice.name, [&]<class M>(Type<M>) {
    const M law = make_law<M>(elastic, choice);
    if constexpr (d == 2)
      if (choice.plane == Plane::stress) return use(PlaneStress<M>(law));
    use(law);
  });
  if (!found)
    throw InputError(choice.name + " has no energy W(F)", "its stress depends on what was before",
                     "name an elastic law, such as neo-hookean");
}

}  // namespace plumb
