#pragma once
#include <cstdint>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/geometry/ghosts.hpp"

namespace plumb {

/// Bonds from particles to mirror images behind rollers, in rows like those of the bond table. There are no
/// image particles: the image of j has the displacement R u_j and the stress R P_j R with the reflection R,
/// so that a bond keeps the place of j and the signs of R. THEORY (10.6), (10.7).
template <int d>
struct MirrorBonds {
  std::vector<Wall> walls;
  std::vector<std::int64_t> begin;   ///< per row of the bond table: its first bond; one more at the end
  std::vector<std::int32_t> offset;  ///< per bond: slot of j minus slot of i; 0: the particle's own image
  std::vector<Vec<d>> signs;         ///< per bond: diagonal of R
  AlignedVector stencil;             ///< per bond, d x width: c_ij [1/m]
  AlignedVector force;               ///< per bond, d x width: a_ij [1/m]
  AlignedVector own_force;           ///< per row, d x width: what these bonds add to s_i [1/m]
  AlignedVector laplacian, outer_laplacian;  ///< per bond, width [1/m^2]; as in the bond table

  std::size_t bytes() const {
    const std::size_t reals =
        stencil.size() + force.size() + own_force.size() + laplacian.size() + outer_laplacian.size();
    return reals * sizeof(double) + begin.size() * sizeof(std::int64_t) +
           offset.size() * (sizeof(std::int32_t) + sizeof(Vec<d>));
  }
};

/// Adds to the deformation gradients of one pack what images do: sum (R u_j - u_i) (x) c_ij.
template <int d, int W>
void add_image_gradient(const MirrorBonds<d>& bonds, Index row, const Field& u, Index pack,
                        Mat<d, Pack<W>>& F) {
  using Real = Pack<W>;
  const Index i = pack * W;
  for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n)
    for (int a = 0; a < d; ++a) {
      const Real du = Real(bonds.signs[n][a]) * Real::load(u[a] + i + bonds.offset[n]) - Real::load(u[a] + i);
      for (int b = 0; b < d; ++b) F(a, b) += du * Real::load(bonds.stencil.data() + (n * d + b) * W);
    }
}

}  // namespace plumb
