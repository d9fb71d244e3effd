#include <cmath>

#include "lib/geometry/facets.hpp"

namespace plumb {
namespace {

/// One axis of a lattice: where its particles lie and how much of the axis belongs to each.
struct Axis {
  double lower, step;
  Index count;
  bool on_nodes;
  double share(Index n) const { return on_nodes && (n == 0 || n == count - 1) ? 0.5 * step : step; }
};

template <int d>
Axis axis_of(const Cloud<d>& cloud, int k) {
  const double first = cloud.X[0][k] - cloud.box.origin[k];
  const bool on_nodes = first == 0;  // lattice() puts the first particle on the face or half a step inside
  const Index cells = cloud.count[k] - (on_nodes ? 1 : 0);
  return {cloud.box.origin[k], cloud.box.size[k] / static_cast<double>(cells), cloud.count[k], on_nodes};
}

}  // namespace

template <int d>
std::vector<Facet<d>> lattice_facets(const Cloud<d>& cloud) {
  std::vector<Facet<d>> facets;
  for (int k = 0; k < d; ++k)
    for (const int side : {-1, +1}) {
      const Index layer = side < 0 ? 0 : cloud.count[k] - 1;
      for (Index i = 0; i < cloud.size(); ++i) {
        if (i / cloud.stride[k] % cloud.count[k] != layer) continue;
        Facet<d> facet{i, cloud.X[i], Vec<d>::Zero()};
        facet.centroid[k] = cloud.box.origin[k] + (side > 0 ? cloud.box.size[k] : 0.0);
        facet.area[k] = side;
        facet.depth = std::abs(facet.centroid[k] - cloud.X[i][k]);
        for (int a = 0; a < d; ++a)
          if (a != k) facet.area[k] *= axis_of(cloud, a).share(i / cloud.stride[a] % cloud.count[a]);
        facets.push_back(facet);
      }
    }
  return facets;
}

template std::vector<Facet<1>> lattice_facets<1>(const Cloud<1>&);
template std::vector<Facet<2>> lattice_facets<2>(const Cloud<2>&);
template std::vector<Facet<3>> lattice_facets<3>(const Cloud<3>&);

}  // namespace plumb
