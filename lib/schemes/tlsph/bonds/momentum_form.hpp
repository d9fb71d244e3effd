#pragma once
#include <string_view>

#include "lib/core/error.hpp"
#include "lib/core/type_list.hpp"
#include "lib/core/types.hpp"
#include "lib/schemes/tlsph/bonds/momentum_catalogue.hpp"  // made by CMake from forms/*.hpp
#include "lib/schemes/tlsph/bonds/pair_data.hpp"

namespace plumb {

/// A momentum form turns the pair data into constant vectors, once, at set-up, so that the internal force per
/// unit reference volume is f_i = P_i s_i + sum_{j != i} P_j a_ij (THEORY (5.1)), with s_i the sum of `own`
/// over all pairs. A new form is one file in forms/.
template <class M, int d>
concept MomentumForm = requires(const PairData<d>& pair) {
  { M::name } -> std::convertible_to<std::string_view>;
  { M::template other<d>(pair) } -> std::convertible_to<Vec<d>>;
  { M::template own<d>(pair) } -> std::convertible_to<Vec<d>>;
};

/// A form chosen at run time; it acts at set-up only.
template <int d>
struct MomentumWeights {
  Vec<d> (*other)(const PairData<d>&);
  Vec<d> (*own)(const PairData<d>&);
};

/// The form of that name from the catalogue; InputError names the nearest valid one.
template <int d>
MomentumWeights<d> momentum_form_named(std::string_view name) {
  MomentumWeights<d> weights{};
  if (!with_named(MomentumCatalogue{}, name, [&]<class M>(Type<M>) {
        static_assert(MomentumForm<M, d>);
        weights = {&M::template other<d>, &M::template own<d>};
      }))
    throw unknown_name("momentum form", name, names_of(MomentumCatalogue{}));
  return weights;
}

}  // namespace plumb
