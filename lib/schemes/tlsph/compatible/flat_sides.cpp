#include "lib/schemes/tlsph/compatible/flat_sides.hpp"

#include <cmath>

namespace plumb {
namespace {

/// Normals of facets of one plane agree but for rounding, and so do distances from it (in spacings).
constexpr double same_normal = 1 - 1e-10, same_plane = 1e-6;
/// Bodies of more sides count as curved.
constexpr std::size_t most_sides = 32;

}  // namespace

template <int d>
std::optional<std::vector<FlatSide<d>>> flat_sides(const std::vector<Facet<d>>& facets, double spacing) {
  std::vector<FlatSide<d>> sides;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const double size = facets[f].area.norm();
    const Vec<d> normal = facets[f].area / size;
    auto side = std::find_if(sides.begin(), sides.end(), [&](const FlatSide<d>& s) {
      return s.normal.dot(normal) > same_normal &&
             std::abs(s.normal.dot(facets[f].centroid - s.point)) < same_plane * spacing;
    });
    if (side == sides.end()) {
      if (sides.size() == most_sides) return std::nullopt;
      sides.push_back({normal, facets[f].centroid, {}, {}, {}, {}});
      side = sides.end() - 1;
    }
    side->facets.push_back(static_cast<Index>(f));
    side->size.push_back(size);
  }
  return sides;
}

template std::optional<std::vector<FlatSide<1>>> flat_sides<1>(const std::vector<Facet<1>>&, double);
template std::optional<std::vector<FlatSide<2>>> flat_sides<2>(const std::vector<Facet<2>>&, double);
template std::optional<std::vector<FlatSide<3>>> flat_sides<3>(const std::vector<Facet<3>>&, double);

}  // namespace plumb
