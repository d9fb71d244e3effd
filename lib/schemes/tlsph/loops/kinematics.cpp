#include "lib/schemes/tlsph/loops/kinematics.hpp"

#include "lib/schemes/tlsph/bonds/each_bond.hpp"

namespace plumb {

template <int d>
Mat<d> deformation_gradient_of(const Solid<d>& solid, const State<d>& state, Index particle) {
  const BondTable<d>& t = solid.bonds;
  const Index i = t.slots.of(particle);
  Mat<d> F = estimated_identity(t, i);
  for_each_bond(t, i, [&](const BondEntry<d>& bond, const Vec<d>&) {
    const Vec<d> c = bond.vector(t.stencil);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) F(a, b) += (state.u[a][bond.other] - state.u[a][i]) * c[b];
  });
  for_each_image(t, i, [&](const BondEntry<d>& bond, const Vec<d>& signs) {
    const Vec<d> c = bond.vector(t.mirror->stencil);
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b) F(a, b) += (signs[a] * state.u[a][bond.other] - state.u[a][i]) * c[b];
  });
  return F;
}

template Mat<1> deformation_gradient_of<1>(const Solid<1>&, const State<1>&, Index);
template Mat<2> deformation_gradient_of<2>(const Solid<2>&, const State<2>&, Index);
template Mat<3> deformation_gradient_of<3>(const Solid<3>&, const State<3>&, Index);

}  // namespace plumb
