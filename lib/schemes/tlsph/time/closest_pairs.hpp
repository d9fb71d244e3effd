#pragma once
#include <cstdint>
#include <vector>

#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Follows the smallest distance of neighbours, exactly, without a pass over all pairs at every step.
///
/// A pass over all pairs keeps those closer than `reach`, a third more than the smallest distance. As long as
/// the closest of them is nearer than reach - s, where s is the diagonal of the box of all displacements
/// since then (no pair can have come closer by more), no other pair can be the closest, and only the kept
/// ones are looked at. THEORY (10.5).
template <int d>
class ClosestPairs {
 public:
  /// Smallest current distance of neighbours [m]: the same bits as least_distance().
  double distance(const Solid<d>& solid, const State<d>& state);

  /// Returns the memory of its own arrays.
  std::size_t bytes() const;

 private:
  /// One bond of one pack.
  struct Candidate {
    std::int32_t pack;
    std::int32_t bond;  ///< of the pack's row
  };
  double collect(const Solid<d>& solid, const State<d>& state);

  std::vector<Candidate> candidates_;   ///< by block
  std::vector<std::int64_t> of_block_;  ///< per block: its first candidate; one more at the end
  std::vector<float> reference_;  ///< displacements when the candidates were collected [m], by component
  double rounding_ = 0;           ///< what rounding to float may hide of a motion [m]
  double reach_ = 0;              ///< [m]
  long uses_ = 0;                 ///< of the present candidates
  long plain_passes_ = 0;         ///< still to come before candidates are collected again
};

/// What following the closest pairs takes from the reference state on [bytes].
template <int d>
std::size_t closest_pairs_bytes(const Solid<d>& solid);

/// Smallest current distance of neighbours [m], by a pass over all pairs.
template <int d>
double least_distance(const Solid<d>& solid, const State<d>& state);

}  // namespace plumb
