#pragma once
#include <Eigen/Core>

#include "lib/core/field.hpp"

namespace plumb {

/// Displacements [m] and velocities [m/s] of all unknowns at one time [s], numbered d x particle + component.
struct BodyMotion {
  Eigen::VectorXd u, v;
  double time = 0;
  long step = 0;
};

/// A state that keeps displacements and velocities in fields by slot.
template <class S>
concept StateOfMotion = requires(S& state) {
  state.u[0];
  state.v[0];
  state.time;
  state.step;
};

/// Reads the motion from a state with those slots, and writes it into one.
template <int d, StateOfMotion S>
BodyMotion motion_of(const Slots& slots, const S& state) {
  BodyMotion motion{Eigen::VectorXd(d * slots.particles), Eigen::VectorXd(d * slots.particles), state.time,
                    state.step};
  for (Index i = 0; i < slots.particles; ++i) {
    motion.u.template segment<d>(d * i) = vector_at<d>(state.u, slots.of(i));
    motion.v.template segment<d>(d * i) = vector_at<d>(state.v, slots.of(i));
  }
  return motion;
}
template <int d, StateOfMotion S>
void set_motion(const Slots& slots, const BodyMotion& motion, S& state) {
  for (Index i = 0; i < slots.particles; ++i) {
    set_vector<d>(state.u, slots.of(i), Vec<d>(motion.u.template segment<d>(d * i)));
    set_vector<d>(state.v, slots.of(i), Vec<d>(motion.v.template segment<d>(d * i)));
  }
  state.time = motion.time;
  state.step = motion.step;
}

}  // namespace plumb
