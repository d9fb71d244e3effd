#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"

#include <cmath>
#include <memory>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/neighbours.hpp"

namespace plumb {

template <int d>
Surface<d> clipped_surface(const Cloud<d>& cloud, const Shape<d>& shape) {
  const ClippedCells<d> cells = clipped_cells<d>(cloud.X, shape);
  Surface<d> surface{cells.facets, 0, Vec<d>::Zero()};
  Vec<d> moment = Vec<d>::Zero();
  for (Index i = 0; i < cloud.size(); ++i) {
    surface.volume += cells.volume[i];
    moment += cells.volume[i] * (cells.centroid[i] - cloud.X[0]);
  }
  surface.centroid = cloud.X[0] + moment / surface.volume;
  return surface;
}

template <int d>
Shape<d> shape_around(const Cloud<d>& cloud) {
  const double spacing = cloud.spacing, h = 1.2 * spacing;
  const RadialKernel<d> kernel = kernel_named<d>("cubic");
  Vec<d> lower = cloud.X[0], upper = cloud.X[0];
  for (const auto& X : cloud.X) {
    lower = lower.cwiseMin(X);
    upper = upper.cwiseMax(X);
  }
  const Vec<d> margin = Vec<d>::Constant(1.5 * spacing);
  Shape<d> shape;
  shape.box = {lower - margin, upper - lower + 2 * margin};
  // the sum falls by at most one over a spacing, so that this is at most the distance
  shape.clip = [&cloud, kernel, h, spacing,
                search = std::make_shared<NeighbourSearch<d>>(cloud.X)](const Vec<d>& X) {
    std::vector<Index> found;
    search->within(X, kernel.support * h, found);
    double sum = 0;
    for (const Index j : found) sum += kernel.w((cloud.X[j] - X).norm() / h);
    return spacing * (0.5 - sum * std::pow(spacing / h, d));
  };
  return shape;
}

template Surface<2> clipped_surface<2>(const Cloud<2>&, const Shape<2>&);
template Surface<3> clipped_surface<3>(const Cloud<3>&, const Shape<3>&);
template Shape<2> shape_around<2>(const Cloud<2>&);
template Shape<3> shape_around<3>(const Cloud<3>&);

}  // namespace plumb
