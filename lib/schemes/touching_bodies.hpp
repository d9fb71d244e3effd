#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/geometry/cloud.hpp"
#include "lib/geometry/moving_neighbours.hpp"
#include "lib/material/material.hpp"

/// Bodies against each other. THEORY chapter 19.
namespace plumb {

/// What bodies do to each other where they touch.
struct TouchOptions {
  std::optional<double> modulus;  ///< E* of (19.3) [Pa]; absent: E/(1 - nu^2)
  std::vector<double> friction;   ///< Coulomb's coefficients by pairs of bodies, n x n; empty: none

  bool rough() const {
    return std::any_of(friction.begin(), friction.end(), [](double mu) { return mu > 0; });
  }
};

/// The motion that friction answers to.
template <int d>
struct SurfaceMotion {
  const std::vector<Vec<d>>& v;  ///< velocities [m/s]
  const std::vector<Mat<d>>& L;  ///< their gradients [1/s]
  double time;                   ///< how long the bodies have moved so since the last call [s]
};

/// Forces between the particles of different bodies: penalties that have a potential, and Coulomb's friction with a memory of
/// slip. All are equal and opposite; those of friction act in the middle of a pair. THEORY (19.3)-(19.6).
template <int d>
class TouchingBodies {
 public:
  /// Particles further apart than that many spacings do not know of each other.
  static constexpr double reach = 3;
  /// Share of the stiffness along the surface, as of walls (19.2).
  static constexpr double along = 0.8;

  /// A cloud of several bodies. InputError where particles of two bodies are nearer than half a spacing.
  TouchingBodies(const Cloud<d>& cloud, double modulus, std::vector<double> friction);

  bool rough() const { return !friction_.empty(); }
  /// Finds the forces at the places x [m]; `slip` [m], d numbers of each particle, follows the motion if bodies are rough.
  void find(const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion, Field& slip);
  const std::vector<Vec<d>>& forces() const { return force_; }  ///< [N]
  /// The couples of friction, which acts beside the particles: -sum f (x) (c - x) over the volume is a part of the stress of each
  /// particle. [N m]; nullptr where there are none now.
  const std::vector<Mat<d>>* couples() const { return rough() && touching_ ? &couple_ : nullptr; }
  /// What the penalties store at these places. [J]
  double stored(const std::vector<Vec<d>>& x);
  /// A step [s] that the springs of these masses [kg] are stable with: half of their limit.
  double step_limit(const std::vector<double>& mass) const;

 private:
  Index count() const { return static_cast<Index>(force_.size()); }
  int body_of(Index i) const { return neighbours_.body_of(i); }
  /// How deep the particles are in the others, by the sums of (19.3).
  void find_depths(const std::vector<Vec<d>>& x);
  void find_presses(const std::vector<Vec<d>>& x);
  void find_friction(const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion, Field& slip);
  /// The pull of a particle's spring of slip, (19.5), over the sum of what its depth presses with by that depth.
  Vec<d> pull_of(Index i, const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion, Field& slip) const;

  MovingNeighbours<d> neighbours_;
  std::vector<double> share_;  ///< V over that of a cell of the lattice
  std::vector<double> friction_;
  int bodies_ = 0;
  double spacing_ = 0, modulus_ = 0, unit_ = 0;  ///< unit_: of energy, kappa times the volume of a cell [J]
  double level_ = 0;                             ///< phi_0
  bool touching_ = false;

  std::vector<double> depth_;  ///< phi - phi_0 where it is positive
  std::vector<double> press_;  ///< by pairs: force by the depth of one of the two [N]
  std::vector<Vec<d>> force_, pull_;
  std::vector<Mat<d>> couple_;
};

/// Makes those of a cloud of several bodies of that material.
template <int d>
TouchingBodies<d> touching_bodies(const Cloud<d>& cloud, const Elastic& elastic, const TouchOptions& touch) {
  const double modulus = touch.modulus.value_or(elastic.young / (1 - elastic.poisson * elastic.poisson));
  return {cloud, modulus, touch.rough() ? touch.friction : std::vector<double>()};
}

}  // namespace plumb
