#include "lib/schemes/mixed/kernel_sums.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/geometry/position_text.hpp"
#include "lib/kernel/correction.hpp"

namespace plumb {

template <int d>
KernelSums kernel_sums(const Cloud<d>& cloud, const Neighbours& list, bool equal_volumes) {
  KernelSums sums;
  sums.volume = equal_volumes ? std::vector<double>(cloud.X.size(), 1.0) : cloud.V;
  sums.h.resize(cloud.X.size());
  std::vector<Neighbour<d>> seen;
  for (Index a = 0; a < cloud.size(); ++a) {
    seen.clear();
    double farthest = 0;
    for (const auto b : list.of(a)) {
      seen.push_back({cloud.X[b] - cloud.X[a], cloud.V[b]});
      farthest = std::max(farthest, seen.back().separation.norm());
    }
    if (const int directions = independent_directions<d>(seen); directions < d)
      throw InputError(fmt::format("particle {} at {} m has a singular neighbourhood: {} neighbours span {} "
                                   "of {} directions",
                                   a, position_text<d>(cloud.X[a]), seen.size() - 1, directions, d),
                       "the neighbour list holds too few particles", "increase [mixed] list");
    sums.h[a] = smoothing_factor * farthest;
  }
  return sums;
}

template <int d>
std::vector<Vec<d>> corrected_gradients(const Cloud<d>& cloud, const Neighbours& list, const KernelSums& sums,
                                        Index a) {
  std::vector<Vec<d>> gradient;
  Mat<d> moment = Mat<d>::Zero();
  for (const auto b : list.of(a)) {
    gradient.push_back(Vec<d>::Zero());
    if (b == a) continue;
    const Vec<d> X = cloud.X[b] - cloud.X[a];
    gradient.back() =
        sums.volume[b] / std::pow(sums.h[b], d) * kernel_slope<double>(X.norm(), 1 / sums.h[b]) * X;
    moment += gradient.back() * X.transpose();
  }
  const Mat<d> correction = moment.inverse();
  for (auto& g : gradient) g = correction * g;
  return gradient;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                             \
  template KernelSums kernel_sums<d>(const Cloud<d>&, const Neighbours&, bool);                              \
  template std::vector<Vec<d>> corrected_gradients<d>(const Cloud<d>&, const Neighbours&, const KernelSums&, \
                                                      Index);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
