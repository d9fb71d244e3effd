#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/particles/block.hpp"
#include "lib/schemes/tlsph/loops/state.hpp"

namespace plumb {

/// First Piola-Kirchhoff stresses [Pa], row by row, of those blocks that forces have still to read.
///
/// A thread goes once through its share of the blocks, the force `reach` blocks behind the stress: of the
/// inside of a share only 2 reach + 1 blocks are alive at a time and take turns in the same memory, which so
/// stays in the cache and is never written out. The 2 reach blocks at an end that meets another share live
/// until both threads are there. Bodies too small for that keep everything. THEORY, section 10.
class StressWindow {
 public:
  StressWindow() = default;
  StressWindow(int components, Index blocks, Index reach, Index shares);

  Index shares() const { return shares_; }
  /// How many blocks to either side a force reads.
  Index reach() const { return reach_; }
  /// The first block of a share; the next share begins where it ends.
  Index begin_of(Index share) const { return blocks_ * share / shares_; }
  /// First and end of the blocks whose forces read nothing beyond their share.
  std::pair<Index, Index> inner(Index share) const {
    const Index begin = begin_of(share), end = begin_of(share + 1);
    const Index first = share == 0 ? begin : std::min(begin + reach_, end);
    return {first, share == shares_ - 1 ? end : std::max(end - reach_, first)};
  }

  /// Where a slot stands in every component, while it is alive; slots of one block stand side by side. Slots
  /// within `reach` blocks outside of the body hold zeros.
  Index place(Index slot) const {
    return slot + shift_[static_cast<std::size_t>(slot + outside_ * block_slots) / block_slots];
  }
  double* operator[](int component) { return values_[component]; }
  const double* operator[](int component) const { return values_[component]; }
  double at(int component, Index slot) const { return values_[component][place(slot)]; }
  /// W slots from any one on; they may belong to two blocks.
  template <int W>
  Pack<W> load(int component, Index slot) const {
    const Index first = place(slot);
    if (place(slot + W - 1) == first + W - 1) return Pack<W>::load(values_[component] + first);
    double lanes[W];
    for (int lane = 0; lane < W; ++lane) lanes[lane] = at(component, slot + lane);
    return Pack<W>::load(lanes);
  }

  /// Forgets what an evaluation that failed has left behind: times a weight of zero it would not be zero.
  void clear() { *this = StressWindow(values_.components(), blocks_, reach_, shares_); }
  std::size_t bytes() const { return values_.bytes() + shift_.size() * sizeof(std::int32_t); }

 private:
  Index blocks_ = 0, reach_ = 0, shares_ = 0;
  Index outside_ = 0;                ///< blocks before the body and behind it that can be asked for
  std::vector<std::int32_t> shift_;  ///< per block, from outside_ before the first: place minus slot
  Field values_;
};

}  // namespace plumb
