#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "lib/schemes/scheme.hpp"
#include "tests/support/clouds.hpp"

/// Bodies and motions for the tests of schemes whose neighbours change.
namespace plumb::testing {

/// A box about the origin with cells of that size [m], one particle in each.
template <int d>
Cloud<d> cells(std::array<Index, d> count, double spacing) {
  Vec<d> size;
  for (int k = 0; k < d; ++k) size[k] = spacing * static_cast<double>(count[k]);
  return lattice<d>({-0.5 * size, size}, count, Layout::cell);
}

/// A motion without displacement: velocity(X) of every particle.
template <int d, class Velocity>
InitialMotion<d> moving(const Cloud<d>& cloud, Velocity&& velocity) {
  InitialMotion<d> motion;
  for (const Vec<d>& X : cloud.X) motion.v.push_back(velocity(X));
  return motion;
}

/// Rigid rotation about the origin in the x-y plane.
template <int d>
InitialMotion<d> turning(const Cloud<d>& cloud, double omega) {
  return moving<d>(cloud, [&](const Vec<d>& X) {
    Vec<d> v = Vec<d>::Zero();
    v[0] = -omega * X[1];
    v[1] = omega * X[0];
    return v;
  });
}

template <int d>
struct BodySums {
  Vec<d> momentum = Vec<d>::Zero();
  double spin = 0, inertia = 0, momentum_scale = 0;
};
/// Momenta and moment of inertia about the z axis.
template <int d>
BodySums<d> body_sums(const Snapshot<d>& s) {
  BodySums<d> sums;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    sums.momentum += s.mass[i] * s.v[i];
    sums.momentum_scale += s.mass[i] * s.v[i].norm();
    sums.spin += s.mass[i] * (s.x[i][0] * s.v[i][1] - s.x[i][1] * s.v[i][0]);
    sums.inertia += s.mass[i] * (s.x[i][0] * s.x[i][0] + s.x[i][1] * s.x[i][1]);
  }
  return sums;
}

/// The particle nearest to a point.
template <int d>
Index nearest(const Cloud<d>& cloud, const Vec<d>& point) {
  Index best = 0;
  for (Index i = 0; i < cloud.size(); ++i)
    if ((cloud.X[i] - point).norm() < (cloud.X[best] - point).norm()) best = i;
  return best;
}

template <class Body, class State>
void advance_by(Body& body, State& state, int steps) {
  for (int n = 0; n < steps; ++n) {
    const auto trouble = body.advance(state, body.step_limit(state));
    ASSERT_FALSE(trouble) << trouble->quantity << ' ' << trouble->value << " step " << n;
  }
}

}  // namespace plumb::testing
