#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lib/core/type_list.hpp"

namespace plumb::test {

/// One member of a catalogue in one dimension: the parameter of a typed law test.
template <class P, int dim>
struct In {
  using part = P;
  static constexpr int d = dim;
};

template <class List>
struct Dimensions;
template <class... Ps>
struct Dimensions<TypeList<Ps...>> {
  using from_1 = ::testing::Types<In<Ps, 1>..., In<Ps, 2>..., In<Ps, 3>...>;
  using from_2 = ::testing::Types<In<Ps, 2>..., In<Ps, 3>...>;
};

/// Every member of the catalogue in 1D, 2D and 3D (or in 2D and 3D), for TYPED_TEST_SUITE.
template <class List>
using AllDimensions = typename Dimensions<List>::from_1;
template <class List>
using TwoAndThree = typename Dimensions<List>::from_2;

/// Names a typed test: "wendland_c2_2D".
struct Names {
  template <class Case>
  static std::string GetName(int) {
    std::string name(Case::part::name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_" + std::to_string(Case::d) + "D";
  }
};

/// Dimensions alone, for tests without a catalogue.
struct Plain {
  static constexpr std::string_view name = "plain";
};

}  // namespace plumb::test
