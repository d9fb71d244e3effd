#pragma once
#include "lib/geometry/facets.hpp"
#include "lib/kernel/correction.hpp"
#include "lib/schemes/tlsph/compatible/flat_sides.hpp"

namespace plumb {

/// What the projection must know of a body's shape.
template <int d>
struct Surface {
  std::vector<Facet<d>> facets;
  double volume;    ///< of the body [m^d]
  Vec<d> centroid;  ///< of the body [m]
};

/// The surface of the cloud's box.
template <int d>
Surface<d> box_surface(const Cloud<d>& cloud);

/// Outward boundary area vectors B_i [m^(d-1)], and how far they were from the divergence theorem.
template <int d>
struct BoundaryVectors {
  std::vector<Vec<d>> B;
  double defect = 0;     ///< largest relative error of a moment before the correction
  double remainder = 0;  ///< and after it: round-off if the theorem can hold
  /// The sides of a body with few flat sides: B_i is the sum of their normals times the areas of particle i. Empty otherwise.
  std::vector<FlatSide<d>> sides = {};
};

/// Area vectors that obey the divergence theorem for all quadratic fields q: sum_i q(X_i) . B_i = integral of
/// div q (THEORY (11.6)). A facet goes to its owner if that lies on it; otherwise to the particles around it,
/// by weights that extrapolate linear fields to its centroid. What is then missing in the moments is added by
/// the smallest change, weighted by |B_i|, that does it; on flat sides by the smallest change of areas that leaves each side its
/// area and its middle, so that a load of P N on every side balances a uniform stress P (THEORY (11.16)).
template <int d>
BoundaryVectors<d> boundary_vectors(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double h,
                                    const Surface<d>& surface);

}  // namespace plumb
