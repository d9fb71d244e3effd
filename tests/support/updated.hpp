#pragma once
#include "lib/schemes/updated/updated.hpp"
#include "tests/support/moving_bodies.hpp"

/// Bodies for the tests of the updated Lagrangian scheme of paper 002.
namespace plumb::testing {

inline const Elastic spinning_rubber{17e6, 0.45, 1100};

/// The printed balance with that form, a new geometry at every step.
inline UpdatedOptions printed(const std::string& form, const std::string& rotation = "mean") {
  UpdatedOptions o = UpdatedOptions::of_paper();
  o.form = form;
  o.rotation = rotation;
  o.geometry = "step";
  return o;
}

template <int d>
Updated<d> updated_body(Cloud<d> cloud, const UpdatedOptions& options,
                        const Elastic& elastic = spinning_rubber,
                        const LawChoice& law = LawChoice("linear-elastic")) {
  return Updated<d>({std::move(cloud), law, elastic}, options, {});
}

}  // namespace plumb::testing
