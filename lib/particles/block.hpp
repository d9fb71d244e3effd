#pragma once
#include "lib/core/field.hpp"

namespace plumb {

/// A range of packs that one thread handles at a time; its force density stays in the first-level cache.
struct Block {
  Index first_pack, end_pack;
  int width;
  Index begin() const { return first_pack * width; }
  Index end() const { return end_pack * width; }
};

/// Slots per block. Blocks do not depend on the number of threads, and neither do sums over them.
inline constexpr Index block_slots = 256;
/// Below so many blocks one thread is faster: a block takes some 10 us, waking a second thread as much.
inline constexpr Index blocks_for_threads = 16;

/// Force per unit reference volume [N/m^d] of the slots of one block; component k of slot i is at (k, i).
template <int d>
class BlockForce {
 public:
  explicit BlockForce(const Block& block) : first_(block.begin()) {}  // cppcheck-suppress uninitMemberVar
  double* at(int component, Index slot) { return &values_[component][slot - first_]; }
  double& operator()(int component, Index slot) { return values_[component][slot - first_]; }

 private:
  Index first_;
  alignas(64) double values_[d][block_slots];
};

}  // namespace plumb
