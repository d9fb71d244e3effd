#pragma once
#include "lib/schemes/outside.hpp"

namespace plumb {

/// Says how far a body is from rest, and how fast its motion about that is.
struct RestLook {
  double residual;   ///< forces on free components over those of loads and supports, THEORY (5.10)
  double frequency;  ///< of the present motion by Rayleigh's quotient [1/s]; 0 where forces drive it on
};

/// Compares the forces of a body at velocity zero before and after a step, THEORY (5.11).
template <int d>
RestLook look_for_rest(const OutsideForces<d>& outside, const OpenAcceleration& before, const Field& u_before,
                       const OpenAcceleration& after, const Field& u_after);

/// A step after which the forces are looked at. The others cost nothing; the motions that take long to settle
/// change little in between.
inline bool looks_after_step(long step) {
  return step % 10 == 0;
}

}  // namespace plumb
