#include "plumbline/time/closest_pairs.hpp"

#include <cmath>

#include "plumbline/solid/sweeps.hpp"

namespace plumb {
namespace {

/// On a lattice the second nearest pairs are 1.41 spacings apart: at 4/3 only the nearest are kept.
constexpr double reach_of_least = 4.0 / 3;
/// Collecting costs some three passes, so candidates that did not serve so often were not worth it; then the
/// body moves fast, and this many plain passes come first.
constexpr long worthwhile_uses = 4, passes_between_tries = 16;

/// Calls one of two functions, as the table has packs of one or of many.
template <int d, class F>
auto with_width(const BondTable<d>& bonds, F&& f) {
  if (bonds.width == 1) return f(std::integral_constant<int, 1>{});
  return f(std::integral_constant<int, native_width>{});
}

std::vector<float> rounded(const Field& u, Index slots) {
  std::vector<float> result(u.components() * slots);
  for (int k = 0; k < u.components(); ++k)
    for (Index i = 0; i < slots; ++i) result[k * slots + i] = static_cast<float>(u[k][i]);
  return result;
}

/// Diagonal of the box that holds the displacements since `reference` [m], with what rounding to float may
/// hide.
template <int d>
double relative_motion(const Solid<d>& solid, const Field& u, const std::vector<float>& reference) {
  const Index slots = solid.bonds.slots.count();
  double square = 0;
  for (int k = 0; k < d; ++k) {
    double lower = std::numeric_limits<double>::max(), upper = -lower, largest = 0;
    const double* now = u[k];
    const float* then = reference.data() + k * slots;
#pragma omp parallel for simd schedule(static) reduction(min      \
                                                         : lower) \
    reduction(max                                                 \
              : upper, largest) if (solid.blocks() >= blocks_for_threads)
    for (Index i = 0; i < slots; ++i) {
      const double old = then[i], moved = now[i] - old;
      lower = std::min(lower, moved);
      upper = std::max(upper, moved);
      largest = std::max(largest, std::abs(old));
    }
    const double side = upper - lower + largest * std::numeric_limits<float>::epsilon();
    square += side * side;
  }
  return std::sqrt(square);
}

}  // namespace

template <int d>
double least_distance(const Solid<d>& solid, const State<d>& state) {
  const Index blocks = solid.blocks();
  double least = std::numeric_limits<double>::max();
  with_width(solid.bonds, [&](auto width) {
    constexpr int W = width;
#pragma omp parallel for schedule(static) reduction(min : least) if (blocks >= blocks_for_threads)
    for (Index b = 0; b < blocks; ++b)
      least = std::min(least, distance_sweep<d, W>(solid.bonds, state.u, solid.block(b)));
  });
  return std::sqrt(least);
}

template <int d>
double ClosestPairs<d>::distance(const Solid<d>& solid, const State<d>& state) {
  if (plain_passes_ > 0) {
    --plain_passes_;
    return least_distance(solid, state);
  }
  if (candidates_.empty()) return collect(solid, state);
  double least = std::numeric_limits<double>::max();
  const auto count = static_cast<Index>(candidates_.size());
  with_width(solid.bonds, [&](auto width) {
    constexpr int W = width;
#pragma omp parallel for schedule(static) \
    reduction(min                         \
              : least) if (count >= blocks_for_threads * block_slots / W)
    for (Index c = 0; c < count; ++c)
      least = std::min(least, least_lane(square_distance<d, W>(solid.bonds, state.u, candidates_[c].pack,
                                                               candidates_[c].bond)));
  });
  least = std::sqrt(least);
  if (least <= reach_ - relative_motion(solid, state.u, reference_)) {
    ++uses_;
    return least;
  }
  if (uses_ < worthwhile_uses) plain_passes_ = passes_between_tries;
  candidates_.clear();
  return plain_passes_ > 0 ? least_distance(solid, state) : collect(solid, state);
}

template <int d>
double ClosestPairs<d>::collect(const Solid<d>& solid, const State<d>& state) {
  const double least = least_distance(solid, state);
  if (!std::isfinite(least)) return least;
  const BondTable<d>& bonds = solid.bonds;
  reach_ = reach_of_least * least;
  reference_ = rounded(state.u, bonds.slots.count());
  uses_ = 0;
  std::vector<std::vector<Candidate>> found(solid.blocks());
  with_width(bonds, [&](auto width) {
    constexpr int W = width;
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
    for (Index b = 0; b < solid.blocks(); ++b)
      for (Index pack = solid.block(b).first_pack; pack < solid.block(b).end_pack; ++pack)
        for (std::int64_t n = bonds.begin[bonds.row[pack]]; n < bonds.begin[bonds.row[pack] + 1]; ++n)
          if (bonds.offset[n] > 0 &&
              least_lane(square_distance<d, W>(bonds, state.u, pack, n)) < reach_ * reach_)
            found[b].push_back({n, pack});
  });
  for (const auto& of_block : found) candidates_.insert(candidates_.end(), of_block.begin(), of_block.end());
  return least;
}

template double least_distance<2>(const Solid<2>&, const State<2>&);
template double least_distance<3>(const Solid<3>&, const State<3>&);
template class ClosestPairs<2>;
template class ClosestPairs<3>;

}  // namespace plumb
