#pragma once
#include <cstdint>
#include <vector>

#include "plumbline/solid/solid.hpp"

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

 private:
  /// One bond of one pack.
  struct Candidate {
    std::int64_t bond;
    Index pack;
  };
  double collect(const Solid<d>& solid, const State<d>& state);

  std::vector<Candidate> candidates_;
  std::vector<float> reference_;  ///< displacements when the candidates were collected [m], by component
  double reach_ = 0;              ///< [m]
  long uses_ = 0;                 ///< of the present candidates
  long plain_passes_ = 0;         ///< still to come before candidates are collected again
};

/// Smallest current distance of neighbours [m], by a pass over all pairs.
template <int d>
double least_distance(const Solid<d>& solid, const State<d>& state);

}  // namespace plumb
