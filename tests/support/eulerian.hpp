#pragma once
#include "lib/schemes/eulerian/eulerian.hpp"
#include "tests/support/moving_bodies.hpp"

/// Bodies for the tests of the Eulerian-kernel scheme of paper 001.
namespace plumb::testing {

/// Young's modulus that gives K = 3.25 MPa and mu = 0.715 MPa, the soft material of the paper's plate.
inline const Elastic soft{9 * 3.25e6 * 0.715e6 / (3 * 3.25e6 + 0.715e6),
                          (3 * 3.25 - 2 * 0.715) / (2 * (3 * 3.25 + 0.715)), 1000};

/// That force without damping and hourglass control.
inline EulerianOptions plain(const std::string& force) {
  EulerianOptions o;
  o.force = force;
  o.damping = "none";
  o.hourglass = "none";
  return o;
}

template <int d>
Eulerian<d> eulerian_body(Cloud<d> cloud, const EulerianOptions& options, const Elastic& elastic = soft,
                          const Actions<d>& actions = {}) {
  return Eulerian<d>({std::move(cloud), LawChoice("linear-elastic"), elastic}, options, actions);
}

/// A motion in which no two particles are alike: displacements of some percent, velocities of metres per second.
template <int d>
InitialMotion<d> rough_motion(const Cloud<d>& cloud) {
  test::Numbers numbers(7);
  InitialMotion<d> motion;
  for (const Vec<d>& X : cloud.X) {
    Vec<d> v, u;
    for (int k = 0; k < d; ++k) {
      v[k] = 2 * std::sin(3 * X[k] + k) + 0.3 * numbers.next();
      u[k] = 0.02 * std::sin(2 * X[(k + 1) % d]);
    }
    motion.v.push_back(v);
    motion.u.push_back(u);
  }
  return motion;
}

}  // namespace plumb::testing
