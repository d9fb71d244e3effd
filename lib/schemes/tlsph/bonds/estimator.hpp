#pragma once
#include <string_view>
#include <vector>

#include "lib/core/error.hpp"
#include "lib/core/type_list.hpp"
#include "lib/kernel/correction.hpp"
#include "lib/schemes/tlsph/bonds/estimator_catalogue.hpp"  // made by CMake from estimators/*.hpp

namespace plumb {

/// A gradient estimator turns the corrected kernel of one particle into constant vectors c_ij [1/m], one per
/// neighbour, so that F_i = sum_j (x_j - x_i) (x) c_ij (THEORY (3.1)). The entry of the particle itself is
/// zero. One that does not reproduce affine maps says so: `template <int d> static constexpr bool affine`. A
/// new estimator is one file in estimators/.
template <class E, int d>
concept Estimator = requires(Neighbourhood<d> neighbours, const CorrectedKernel<d>& kernel) {
  { E::name } -> std::convertible_to<std::string_view>;
  { E::template stencil<d>(neighbours, kernel) } -> std::same_as<std::vector<Vec<d>>>;
};

/// An estimator chosen at run time; it acts at set-up only.
template <int d>
using StencilFunction = std::vector<Vec<d>> (*)(Neighbourhood<d>, const CorrectedKernel<d>&);

/// The estimator of that name from the catalogue; InputError names the nearest valid one.
template <int d>
StencilFunction<d> estimator_named(std::string_view name) {
  StencilFunction<d> function = nullptr;
  if (!with_named(EstimatorCatalogue{}, name, [&]<class E>(Type<E>) {
        static_assert(Estimator<E, d>);
        function = &E::template stencil<d>;
      }))
    throw unknown_name("gradient estimator", name, names_of(EstimatorCatalogue{}));
  return function;
}

}  // namespace plumb
