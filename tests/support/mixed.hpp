#pragma once
#include <cmath>
#include <random>

#include "lib/schemes/mixed/mixed.hpp"

/// Bodies for the tests of the scheme of paper 003.
namespace plumb::testing {

inline const Elastic column_rubber{17e6, 0.3, 1100};

template <int d>
Cloud<d> nodes(const Vec<d>& origin, const Vec<d>& size, std::array<Index, d> cells) {
  return lattice<d>({origin, size}, cells, Layout::node);
}

/// A cube of 1 m about the origin with that many cells.
template <int d>
Cloud<d> cube(Index cells) {
  std::array<Index, d> counts;
  counts.fill(cells);
  return nodes<d>(Vec<d>::Constant(-0.5), Vec<d>::Ones(), counts);
}

template <int d>
Mixed<d> mixed_body(Cloud<d> cloud, const MixedOptions& options, const Actions<d>& actions = {},
                    const LawChoice& law = LawChoice("polyconvex"), const Elastic& elastic = column_rubber) {
  return Mixed<d>({std::move(cloud), law, elastic}, options, actions);
}

inline MixedOptions mixed_options(const std::string& upwind, const std::string& kinematics = "tied") {
  MixedOptions o;
  o.upwind = upwind;
  o.kinematics = kinematics;
  return o;
}

/// Numbers from -1 to 1, the same on every machine.
class Noise {
 public:
  double operator()() { return 2 * static_cast<double>(random_() >> 11) * 0x1p-53 - 1; }

 private:
  std::mt19937_64 random_{11};
};

/// A motion with strains of about `strain` and velocities of about `speed` that no particle shares.
template <int d>
InitialMotion<d> rough_motion(const Cloud<d>& cloud, double strain, double speed) {
  Noise noise;
  InitialMotion<d> motion;
  for (const Vec<d>& X : cloud.X) {
    Vec<d> u, v;
    for (int k = 0; k < d; ++k) {
      u[k] = strain * (std::sin(2 * X[k] + k) * (0.5 + X[(k + 1) % d]) + 0.1 * cloud.spacing * noise());
      v[k] = speed * noise();
    }
    motion.u.push_back(u);
    motion.v.push_back(v);
  }
  return motion;
}

/// Velocity of a rigid rotation about the origin in the x-y plane, at the positions X + u.
template <int d>
std::vector<Vec<d>> spinning(const std::vector<Vec<d>>& x, double omega) {
  std::vector<Vec<d>> v;
  for (const Vec<d>& at : x) {
    Vec<d> turned = Vec<d>::Zero();
    turned[0] = -omega * at[1];
    turned[1] = omega * at[0];
    v.push_back(turned);
  }
  return v;
}

/// Angular momentum about the origin, z component [kg m^2/s].
template <int d>
double spin_of(const Snapshot<d>& s) {
  double L = 0;
  for (std::size_t i = 0; i < s.x.size(); ++i)
    L += s.mass[i] * (s.x[i][0] * s.v[i][1] - s.x[i][1] * s.v[i][0]);
  return L;
}

/// Steps with the scheme's own limit up to `time`; the last one ends there. False in trouble.
template <int d, class After>
bool run_to(Mixed<d>& body, MixedState<d>& state, double time, After&& after) {
  while (state.time < time * (1 - 1e-12)) {
    const double limit = body.step_limit(state), left = time - state.time;
    if (body.advance(state, limit > left ? left : limit)) return false;
    after();
  }
  return true;
}
template <int d>
bool run_to(Mixed<d>& body, MixedState<d>& state, double time) {
  return run_to(body, state, time, [] {});
}

}  // namespace plumb::testing
