#include "lib/schemes/tlsph/time/closest_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

/// Puts the body where a motion has brought it after a phase: u = phase (G X + wobble).
void move(const Solid<3>& solid, State<3>& state, double phase, const Mat<3>& G, double wobble) {
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<3>& X = solid.cloud.X[i];
    Vec<3> u = phase * G * X;
    for (int k = 0; k < 3; ++k) u[k] += wobble * std::sin(9 * X[(k + 1) % 3] + 4 * phase) * phase;
    set_vector<3>(state.u, solid.bonds.slots.of(i), u);
  }
}

/// The closest pair changes from one direction to another and from particle to particle on the way.
TEST(ClosestPairs, AreThoseOfAPassOverAllPairs) {
  Mat<3> squeeze = Mat<3>::Zero(), spin = Mat<3>::Zero();
  squeeze.diagonal() = Vec<3>(0.3, -0.5, 0.1);
  squeeze(0, 1) = 0.9;
  spin(0, 1) = -3;
  spin(1, 0) = 3;
  for (const double jitter : {0.0, 0.2})
    for (const Mat<3>& G : {squeeze, spin}) {
      const Solid<3> solid = rubber_block<3>(7, Layout::node, jitter);
      State<3> state = make_state(solid);
      ClosestPairs<3> closest;
      for (int step = 0; step <= 120; ++step) {
        const double phase = step < 60 ? step / 60.0 : 2 - step / 60.0;  // there and back
        move(solid, state, phase, G, 0.02);
        // the same additions for the same pairs: not even the last bit may differ
        ASSERT_EQ(closest.distance(solid, state), least_distance(solid, state)) << "step " << step;
      }
    }
}

/// A pair that was far apart when the candidates were chosen comes closest later.
TEST(ClosestPairs, SeeAPairThatWasNotAmongThem) {
  const Solid<3> solid = rubber_block<3>(6, Layout::cell, 0);
  State<3> state = make_state(solid);
  ClosestPairs<3> closest;
  const double d = closest.distance(solid, state);
  // the two corners of one cell of the lattice approach along its diagonal, in steps that each keep the
  // candidates
  const Index corner = 0, opposite = solid.cloud.stride[0] + solid.cloud.stride[1] + solid.cloud.stride[2];
  const Vec<3> apart = solid.cloud.X[opposite] - solid.cloud.X[corner];
  for (int step = 1; step <= 16; ++step) {
    set_vector<3>(state.u, solid.bonds.slots.of(corner), Vec<3>(0.05 * step * apart));
    ASSERT_EQ(closest.distance(solid, state), least_distance(solid, state)) << "step " << step;
  }
  EXPECT_LT(closest.distance(solid, state), 0.5 * d);
}

}  // namespace
}  // namespace plumb::testing
