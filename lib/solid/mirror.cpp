#include "plumbline/solid/mirror.hpp"

namespace plumb {
namespace {

template <int d, int W>
void add_image_forces(const Solid<d>& solid, const Block& block, BlockForce<d>& force) {
  const MirrorBonds<d>& images = *solid.bonds.mirror;
  for (Index pack = block.first_pack; pack < block.end_pack; ++pack) {
    const Index row = solid.bonds.row[pack], i = pack * W;
    if (images.begin[row] == images.begin[row + 1]) continue;
    Pack<W> f[d];
    image_force<d, W>(images, row, solid.P, pack, f);
    for (int a = 0; a < d; ++a) (Pack<W>::load(force.at(a, i)) + f[a]).store(force.at(a, i));
  }
}

}  // namespace

template <int d>
Term<d> mirror_term(const Solid<d>& solid) {
  Term<d> term;
  term.name = "mirror";
  term.bytes = solid.bonds.mirror->bytes();
  term.internal = true;
  term.second = solid.bonds.width == 1
                    ? [](const Solid<d>& body, const Block& block, const State<d>&, double,
                         BlockForce<d>& force) { add_image_forces<d, 1>(body, block, force); }
                    : [](const Solid<d>& body, const Block& block, const State<d>&, double,
                         BlockForce<d>& force) { add_image_forces<d, native_width>(body, block, force); };
  return term;
}

template Term<1> mirror_term<1>(const Solid<1>&);
template Term<2> mirror_term<2>(const Solid<2>&);
template Term<3> mirror_term<3>(const Solid<3>&);

}  // namespace plumb
