#pragma once
#include "lib/schemes/tlsph/bonds/slot_row.hpp"

namespace plumb {

/// Appends the bonds to images of one pack: the union of its lanes', with zero weights where a lane lacks
/// one. A null lane is an empty slot.
template <int d>
void append_image_row(MirrorBonds<d>& mirror, int width, const std::vector<const SlotRow<d>*>& lanes,
                      bool laplacian);

}  // namespace plumb
