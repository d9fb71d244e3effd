#include "lib/schemes/tlsph/loops/mirror.hpp"

namespace plumb {
namespace {

/// The force per unit volume that images exert on one pack, in f: P_i s_i + sum R P_j R a_ij.
template <int d, int W>
void image_force(const MirrorBonds<d>& bonds, Index row, const StressWindow& P, Index pack, Pack<W>* f) {
  using Real = Pack<W>;
  const Index i = pack * W;
  for (int a = 0; a < d; ++a) {
    f[a] = Real(0);
    for (int b = 0; b < d; ++b)
      f[a] += P.load<W>(a * d + b, i) * Real::load(bonds.own_force.data() + (row * d + b) * W);
  }
  for (std::int64_t n = bonds.begin[row]; n < bonds.begin[row + 1]; ++n)
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        f[a] += Real(bonds.signs[n][a] * bonds.signs[n][b]) * P.load<W>(a * d + b, i + bonds.offset[n]) *
                Real::load(bonds.force.data() + (n * d + b) * W);
}

template <int d, int W>
void add_image_forces(const Solid<d>& solid, const StressWindow& P, const Block& block,
                      BlockForce<d>& force) {
  const MirrorBonds<d>& images = *solid.bonds.mirror;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index row = solid.bonds.row[pack], i = pack * W;
    if (images.begin[row] == images.begin[row + 1]) continue;
    Pack<W> f[d];
    image_force<d, W>(images, row, P, pack, f);
    for (int a = 0; a < d; ++a) (Pack<W>::load(force.at(a, i)) + f[a]).store(force.at(a, i));
  }
}

/// The bonds to images of rows of their own: constants, signs and offsets, for F and for the force.
template <int d>
double bytes_moved(const Solid<d>& solid) {
  if (solid.bonds.width > 1) return 0;
  constexpr double real = sizeof(double), offset = sizeof(std::int32_t);
  const double per_image = 2 * (2 * real * d + offset);
  return per_image * static_cast<double>(solid.bonds.mirror->offset.size()) /
         static_cast<double>(solid.cloud.size());
}

}  // namespace

template <int d>
Term<d> mirror_term(const Solid<d>& solid) {
  Term<d> term;
  term.name = "mirror";
  term.bytes = solid.bonds.mirror->bytes();
  term.bytes_per_update = bytes_moved(solid);
  term.internal = true;
  term.second =
      solid.bonds.width == 1
          ? [](const Solid<d>& body, const Block& block, const Instant<d>& now,
               BlockForce<d>& force) { add_image_forces<d, 1>(body, now.workspace.P, block, force); }
          : [](const Solid<d>& body, const Block& block, const Instant<d>& now, BlockForce<d>& force) {
              add_image_forces<d, native_width>(body, now.workspace.P, block, force);
            };
  return term;
}

template Term<1> mirror_term<1>(const Solid<1>&);
template Term<2> mirror_term<2>(const Solid<2>&);
template Term<3> mirror_term<3>(const Solid<3>&);

}  // namespace plumb
