#include "lib/schemes/tlsph/bonds/append_image_row.hpp"

#include <map>
#include <tuple>

namespace plumb {

template <int d>
void append_image_row(MirrorBonds<d>& mirror, int width, const std::vector<const SlotRow<d>*>& lanes,
                      bool laplacian) {
  using Place = std::pair<std::int32_t, std::array<double, d>>;  // offset and signs
  std::map<Place, std::vector<const SlotBond<d>*>> by_place;
  for (int lane = 0; lane < width; ++lane) {
    if (!lanes[lane]) continue;
    for (const auto& bond : lanes[lane]->images) {
      Place place{bond.offset, {}};
      for (int k = 0; k < d; ++k) place.second[k] = bond.signs[k];
      auto& entry = by_place[place];
      entry.resize(width, nullptr);
      entry[lane] = &bond;
    }
  }
  const auto put = [&](AlignedVector& to, auto&& value) {
    for (int lane = 0; lane < width; ++lane) to.push_back(value(lane));
  };
  for (const auto& place_and_entry : by_place) {
    const auto& entry = place_and_entry.second;
    const auto& [offset, signs] = place_and_entry.first;
    mirror.offset.push_back(offset);
    mirror.signs.push_back(Eigen::Map<const Vec<d>>(signs.data()));
    for (int k = 0; k < d; ++k) {
      put(mirror.stencil, [&](int l) { return entry[l] ? entry[l]->stencil[k] : 0.0; });
      put(mirror.force, [&](int l) { return entry[l] ? entry[l]->force[k] : 0.0; });
    }
    if (!laplacian) continue;
    put(mirror.laplacian, [&](int l) { return entry[l] ? entry[l]->laplacian : 0.0; });
    put(mirror.outer_laplacian, [&](int l) { return entry[l] ? entry[l]->outer_laplacian : 0.0; });
  }
  for (int k = 0; k < d; ++k)
    put(mirror.own_force, [&](int l) { return lanes[l] ? lanes[l]->image_force[k] : 0.0; });
  mirror.begin.push_back(static_cast<std::int64_t>(mirror.offset.size()));
}

template void append_image_row<1>(MirrorBonds<1>&, int, const std::vector<const SlotRow<1>*>&, bool);
template void append_image_row<2>(MirrorBonds<2>&, int, const std::vector<const SlotRow<2>*>&, bool);
template void append_image_row<3>(MirrorBonds<3>&, int, const std::vector<const SlotRow<3>*>&, bool);

}  // namespace plumb
