#pragma once
#include <cstdint>
#include <functional>

#include "lib/geometry/cloud.hpp"

namespace plumb {

/// Fills a box with nodes of cells of one spacing [m], and with those of half of it where `finer` holds at the middle of a cell. Particles
/// within 2:1 changes have the Voronoi volumes of all. `jitter`: inner ones are moved by up to that share of their cells' edges, seeded.
/// InputError if the spacing does not divide the box.
template <int d>
Cloud<d> graded_lattice(const Box<d>& box, double spacing, const std::function<bool(const Vec<d>&)>& finer,
                        double jitter = 0, std::uint64_t seed = 1);

/// Returns the distance of neighbours at each particle of such a cloud [m]: half the spacing but for those that a whole cell touches.
template <int d>
std::vector<double> graded_spacings(const Cloud<d>& cloud, const std::function<bool(const Vec<d>&)>& finer);

}  // namespace plumb
