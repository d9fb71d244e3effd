#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "lib/geometry/facets.hpp"

namespace plumb {

/// How much of a piece of the surface a particle has; negative behind the first layer, where a value at the surface is extrapolated.
struct AreaShare {
  Index particle;
  double share;
};

/// A flat side of a body, and the particles near it that share its area.
template <int d>
struct FlatSide {
  Vec<d> normal;                               ///< outward, of length 1
  Vec<d> point;                                ///< some point of it [m]
  std::vector<Index> facets;                   ///< their numbers
  std::vector<double> size;                    ///< of each facet [m^(d-1)]
  std::vector<std::vector<AreaShare>> shares;  ///< of each facet; they add up to 1
  std::vector<AreaShare> correction;           ///< of the whole side [m^(d-1)]

  /// Areas of the particles [m^(d-1)], in their order, of those facets of the side that `on` says true of, by their number among
  /// all facets.
  template <class On>
  std::vector<AreaShare> areas(On&& on) const;
};

/// The sides that facets lie on; nullopt if they are many, as on a curved surface.
template <int d>
std::optional<std::vector<FlatSide<d>>> flat_sides(const std::vector<Facet<d>>& facets, double spacing);

/// Returns the areas of the particles for all facets of a side [m^(d-1)].
template <int d>
std::vector<AreaShare> all_areas(const FlatSide<d>& side) {
  return side.areas([](Index) { return true; });
}

template <int d>
template <class On>
std::vector<AreaShare> FlatSide<d>::areas(On&& on) const {
  std::vector<AreaShare> all;
  double chosen = 0, whole = 0;
  for (std::size_t n = 0; n < facets.size(); ++n) {
    whole += size[n];
    if (!on(facets[n])) continue;
    chosen += size[n];
    for (const AreaShare& s : shares[n]) all.push_back({s.particle, size[n] * s.share});
  }
  if (chosen > 0)
    for (const AreaShare& s : correction) all.push_back({s.particle, chosen / whole * s.share});
  std::stable_sort(all.begin(), all.end(),
                   [](const AreaShare& a, const AreaShare& b) { return a.particle < b.particle; });
  std::size_t end = 0;
  for (const AreaShare& s : all) {
    if (end > 0 && all[end - 1].particle == s.particle)
      all[end - 1].share += s.share;
    else
      all[end++] = s;
  }
  all.resize(end);
  return all;
}

}  // namespace plumb
