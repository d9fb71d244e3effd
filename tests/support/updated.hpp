#pragma once
#include <cmath>

#include "lib/schemes/updated/updated.hpp"
#include "tests/support/clouds.hpp"

/// Bodies for the tests of the updated Lagrangian scheme of paper 002.
namespace plumb::testing {

inline const Elastic spinning_rubber{17e6, 0.45, 1100};

/// A box about the origin with cells of that size [m], one particle in each.
template <int d>
Cloud<d> cells(std::array<Index, d> count, double spacing) {
  Vec<d> size;
  for (int k = 0; k < d; ++k) size[k] = spacing * static_cast<double>(count[k]);
  return lattice<d>({-0.5 * size, size}, count, Layout::cell);
}

/// The printed balance with that form, a new geometry at every step.
inline UpdatedOptions printed(const std::string& form, const std::string& rotation = "mean") {
  UpdatedOptions o = UpdatedOptions::of_paper();
  o.form = form;
  o.rotation = rotation;
  o.geometry = "step";
  return o;
}

template <int d>
Updated<d> updated_body(Cloud<d> cloud, const UpdatedOptions& options,
                        const Elastic& elastic = spinning_rubber,
                        const LawChoice& law = LawChoice("linear-elastic")) {
  return Updated<d>({std::move(cloud), law, elastic}, options, {});
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

template <int d>
void advance_by(Updated<d>& body, UpdatedState<d>& state, int steps) {
  for (int n = 0; n < steps; ++n) {
    const auto trouble = body.advance(state, body.step_limit(state));
    ASSERT_FALSE(trouble) << trouble->quantity << ' ' << trouble->value << " step " << n;
  }
}

}  // namespace plumb::testing
