#pragma once
#include "lib/geometry/cloud.hpp"

namespace plumb {

/// The small rigid motions of a body as displacements: d translations, then rotations about the middle of its
/// box in the planes xy, xz, yz, with displacements of order 1.
template <int d>
struct RigidMotions {
  static constexpr int count = d + d * (d - 1) / 2;
  using Displacements = Eigen::Matrix<double, d, count>;  ///< one motion per column

  Vec<d> centre;  ///< [m]
  double scale;   ///< of arms, 1/(diagonal of the box) [1/m]

  explicit RigidMotions(const Box<d>& box)
      : centre(box.origin + 0.5 * box.size), scale(1 / box.size.norm()) {}

  /// Returns what the motions do to the point X.
  Displacements at(const Vec<d>& X) const {
    Displacements u = Displacements::Zero();
    u.template leftCols<d>().setIdentity();
    int m = d;
    for (int from = 0; from < d; ++from)
      for (int to = from + 1; to < d; ++to, ++m) {
        u(from, m) = -(X[to] - centre[to]) * scale;
        u(to, m) = (X[from] - centre[from]) * scale;
      }
    return u;
  }
};

}  // namespace plumb
