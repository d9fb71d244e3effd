#pragma once
#include "lib/material/law.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// The loops of that law; InputError names the nearest valid one, or says why a
/// body cannot have it.
template <int d>
Sweeps<d> sweeps_of_choice(const LawChoice& law, const Elastic& elastic, const BondTable<d>& bonds);

/// A body of that law: as make_solid() of a name, with parameters, and in 2D
/// under plane stress if it says so. Its `elastic` are then the constants of
/// small strains in the plane.
template <int d>
Solid<d> make_solid(Cloud<d> cloud, const LawChoice& law, const Elastic& elastic,
                    const BondOptions<d>& options);

}  // namespace plumb
