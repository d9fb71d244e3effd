#include "lib/schemes/tlsph/time/closest_pairs.hpp"

#include <cmath>

#include "lib/schemes/gather.hpp"
#include "lib/schemes/tlsph/loops/sweeps.hpp"

namespace plumb {
namespace {

/// On a lattice the second nearest pairs are 1.41 spacings apart: at 4/3 only the nearest are kept.
constexpr double reach_of_least = 4.0 / 3;
/// Collecting costs some three passes, so candidates that did not serve so often were not worth it; then the
/// body moves fast, and this many plain passes come first.
constexpr long worthwhile_uses = 4, passes_between_tries = 16;

std::vector<float> rounded(const Field& u, Index slots) {
  std::vector<float> result(u.components() * slots);
  for (int k = 0; k < u.components(); ++k)
    for (Index i = 0; i < slots; ++i) result[k * slots + i] = static_cast<float>(u[k][i]);
  return result;
}

/// Half a unit in the last place of the largest number, for either end of a difference, by component.
double lost_by_rounding(const std::vector<float>& reference) {
  float largest = 0;
  for (const float value : reference) largest = std::max(largest, std::abs(value));
  return static_cast<double>(largest) * std::numeric_limits<float>::epsilon();
}

/// Of some blocks: the smallest square of a distance, and the box that holds the displacements since the
/// reference. Smallest and largest are the same in any order.
template <int d>
struct Seen {
  double square = std::numeric_limits<double>::max();
  Vec<d> lower = Vec<d>::Constant(std::numeric_limits<double>::max()), upper = -lower;

  void take(const Seen& other) {
    square = std::min(square, other.square);
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
  }
  void take_motion(const Field& u, const std::vector<float>& reference, Index slots, const Block& block) {
    for (int k = 0; k < d; ++k) {
      double least = lower[k], most = upper[k];
      const double* now = u[k];
      const float* then = reference.data() + k * slots;
#pragma omp simd reduction(min : least) reduction(max : most)
      for (Index i = block.begin(); i < block.end(); ++i) {
        const double moved = now[i] - then[i];
        least = std::min(least, moved);
        most = std::max(most, moved);
      }
      lower[k] = least;
      upper[k] = most;
    }
  }
};

}  // namespace

template <int d>
double least_distance(const Solid<d>& solid, const State<d>& state) {
  const Index blocks = solid.blocks();
  double least = std::numeric_limits<double>::max();
  with_width(solid.bonds, [&]<int W>() {
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
  const BondTable<d>& bonds = solid.bonds;
  Seen<d> all;
  with_width(bonds, [&]<int W>() {
#pragma omp parallel if (solid.blocks() >= blocks_for_threads)
    {
      Seen<d> own;
#pragma omp for schedule(static) nowait
      for (Index b = 0; b < solid.blocks(); ++b) {
        own.take_motion(state.u, reference_, bonds.slots.count(), solid.block(b));
        for (std::int64_t c = of_block_[b]; c < of_block_[b + 1]; ++c) {
          const Candidate& at = candidates_[c];
          const std::int64_t bond = bonds.begin[bonds.row[at.pack]] + at.bond;
          own.square = std::min(own.square, least_lane(square_distance<d, W>(bonds, state.u, at.pack, bond)));
        }
      }
#pragma omp critical
      all.take(own);
    }
  });
  const double least = std::sqrt(all.square);
  const double motion = (all.upper - all.lower + Vec<d>::Constant(rounding_)).norm();
  if (least <= reach_ - motion) {
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
  rounding_ = lost_by_rounding(reference_);
  uses_ = 0;
  std::vector<std::vector<Candidate>> found(solid.blocks());
  with_width(bonds, [&]<int W>() {
#pragma omp parallel for schedule(static) if (solid.blocks() >= blocks_for_threads)
    for (Index b = 0; b < solid.blocks(); ++b)
      for (Index pack = solid.block(b).first_pack; pack < solid.block(b).end_pack; ++pack) {
        const std::int64_t first = bonds.begin[bonds.row[pack]], end = bonds.begin[bonds.row[pack] + 1];
        for (std::int64_t n = first; n < end; ++n)
          if (bonds.offset[n] > 0 &&
              least_lane(square_distance<d, W>(bonds, state.u, pack, n)) < reach_ * reach_)
            found[b].push_back({static_cast<std::int32_t>(pack), static_cast<std::int32_t>(n - first)});
      }
  });
  of_block_.assign(1, 0);
  for (const auto& block : found)
    of_block_.push_back(of_block_.back() + static_cast<std::int64_t>(block.size()));
  candidates_.reserve(of_block_.back());
  for (const auto& block : found) candidates_.insert(candidates_.end(), block.begin(), block.end());
  return least;
}

template <int d>
std::size_t ClosestPairs<d>::bytes() const {
  return candidates_.size() * sizeof(Candidate) + of_block_.size() * sizeof(std::int64_t) +
         reference_.size() * sizeof(float);
}

template <int d>
std::size_t closest_pairs_bytes(const Solid<d>& solid) {
  ClosestPairs<d> closest;
  closest.distance(solid, make_state(solid));
  return closest.bytes();
}

template double least_distance<1>(const Solid<1>&, const State<1>&);
template double least_distance<2>(const Solid<2>&, const State<2>&);
template double least_distance<3>(const Solid<3>&, const State<3>&);
template std::size_t closest_pairs_bytes<1>(const Solid<1>&);
template std::size_t closest_pairs_bytes<2>(const Solid<2>&);
template std::size_t closest_pairs_bytes<3>(const Solid<3>&);
template class ClosestPairs<1>;
template class ClosestPairs<2>;
template class ClosestPairs<3>;

}  // namespace plumb
