#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lib/core/field.hpp"
#include "lib/geometry/beside_surface.hpp"
#include "lib/schemes/moving_pairs.hpp"

/// Particles against rigid walls. THEORY chapter 19.
namespace plumb {

/// A rigid wall that moves without turning.
template <int d>
struct RigidWall {
  std::string name;
  /// Where a point is [m] beside the wall that has not moved. May be called by several threads.
  std::function<BesideSurface<d>(const Vec<d>&)> beside;
  std::function<Vec<d>(double time)> displacement;  ///< [m] at a time [s]; empty: it stays where it is
  double modulus = 0;                               ///< E* of Hertz [Pa]
  double friction = 0;                              ///< Coulomb's coefficient
  double reach = 0;              ///< distance from a particle to the surface of its body [m]
  std::optional<int> body = {};  ///< the one that touches it; nullopt: all do
};

/// A half-space: `point` lies on its surface, `normal` points out of it and has length 1.
template <int d>
std::function<BesideSurface<d>(const Vec<d>&)> half_space(const Vec<d>& point, const Vec<d>& normal) {
  return [point, normal](const Vec<d>& x) { return BesideSurface<d>{(x - point).dot(normal), normal}; };
}

/// The force between a particle and a wall, and how it grows with the overlap.
struct Press {
  double force;  ///< [N]; per metre in 2D, per square metre in 1D
  double slope;  ///< [N/m], likewise
};

/// Hertz's force of a sphere of that radius on a plane, THEORY (19.1); of a cylinder per metre in 2D, of a layer in 1D. `overlap`
/// > 0 [m].
template <int d>
Press press_of(double modulus, double radius, double overlap);

/// What walls do to the particles of a body. THEORY (19.1), (19.2)
template <int d>
class Contact {
 public:
  /// Share of the stiffness along the wall: Mindlin's 2 (1 - nu)/(2 - nu) of nu = 1/3.
  static constexpr double along = 0.8;

  Contact() = default;
  /// Particles at X [m] before any motion, with their masses [kg] and the radius of their spheres [m].
  Contact(std::vector<RigidWall<d>> walls, std::vector<Vec<d>> X, std::vector<double> mass, double radius);

  /// Tells whose the particles are, which forces of their own act between bodies, and a step [s] that those are stable with.
  void meet(std::vector<int> body, double step_limit);
  /// Whether neither walls nor other bodies are there.
  bool empty() const { return walls_.empty() && body_.empty(); }
  const std::vector<RigidWall<d>>& walls() const { return walls_; }
  /// Components of the field of anchors: where, in the frame of each wall with friction, the spring along it begins [m].
  int anchor_components() const { return d * rough_; }
  /// Anchors of particles that have slid nowhere yet.
  void start(const Field& u, Field& anchors) const;
  /// Finds the forces at the positions x [m] and a time [s], adds their accelerations to a field, and drags the anchors of
  /// what slides along.
  void add(double time, const std::vector<Vec<d>>& x, Field& anchors, Field& v_rate);
  /// Adds the accelerations of forces between bodies to what add() found, and to a field.
  void add_between(const Field& acceleration, Field& v_rate);
  /// The forces that add() and add_between() found, over the mass of each particle [m/s^2].
  const Field& acceleration() const { return acceleration_; }
  /// The sum of the forces of one wall on the body, as add() found them [N].
  const Vec<d>& force(std::size_t wall) const { return total_[wall]; }
  /// A step [s] that a particle pressed in by its radius is stable with: half of the limit of its spring.
  double step_limit() const { return step_limit_; }

 private:
  Index count() const { return static_cast<Index>(X_.size()); }
  /// The force of one wall on a particle at y in the frame of the wall. `anchor`: null without friction.
  Vec<d> force_on(const RigidWall<d>& wall, const Vec<d>& y, Vec<d>* anchor) const;

  std::vector<RigidWall<d>> walls_;
  std::vector<Vec<d>> X_, force_, total_;
  std::vector<double> mass_;
  double radius_ = 0, step_limit_ = 0;
  int rough_ = 0;          ///< walls with friction
  std::vector<int> body_;  ///< of each particle; empty: there is one
  Field acceleration_;
};

/// Reads the point of a wall to which friction holds particle i: components first to first + d - 1 [m].
template <int d>
Vec<d> anchor_of(const Field& anchors, int first, Index i) {
  Vec<d> at;
  for (int k = 0; k < d; ++k) at[k] = anchors[first + k][i];
  return at;
}

/// Writes the point that anchor_of() reads.
template <int d>
void set_anchor(Field& anchors, int first, Index i, const Vec<d>& at) {
  for (int k = 0; k < d; ++k) anchors[first + k][i] = at[k];
}

/// Returns how far the wall has moved at that time [m].
template <int d>
Vec<d> moved_by(const RigidWall<d>& wall, double time) {
  return wall.displacement ? wall.displacement(time) : Vec<d>(Vec<d>::Zero());
}

template <int d>
Press press_of(double modulus, double radius, double overlap) {
  if constexpr (d == 3) {
    const double root = std::sqrt(radius * overlap);
    return {4.0 / 3 * modulus * root * overlap, 2 * modulus * root};
  }
  const double slope = d == 2 ? std::acos(-1.0) / 4 * modulus : modulus / radius;
  return {slope * overlap, slope};
}

template <int d>
Contact<d>::Contact(std::vector<RigidWall<d>> walls, std::vector<Vec<d>> X, std::vector<double> mass,
                    double radius)
    : walls_(std::move(walls)),
      X_(std::move(X)),
      force_(X_.size(), Vec<d>::Zero()),
      total_(walls_.size(), Vec<d>::Zero()),
      mass_(std::move(mass)),
      radius_(radius),
      step_limit_(std::numeric_limits<double>::infinity()),
      acceleration_(d, static_cast<Index>(X_.size()), 0) {
  double modulus = 0;
  for (const RigidWall<d>& wall : walls_) {
    rough_ += wall.friction > 0;
    modulus += wall.modulus;  // of a particle that touches all of them
  }
  if (modulus > 0)
    step_limit_ =
        std::sqrt(*std::min_element(mass_.begin(), mass_.end()) / press_of<d>(modulus, radius, radius).slope);
}

template <int d>
void Contact<d>::meet(std::vector<int> body, double step_limit) {
  body_ = std::move(body);
  step_limit_ = std::min(step_limit_, step_limit);
}

template <int d>
void Contact<d>::add_between(const Field& acceleration, Field& v_rate) {
  for (int k = 0; k < d; ++k)
    for (Index i = 0; i < count(); ++i) {
      acceleration_[k][i] += acceleration[k][i];
      v_rate[k][i] += acceleration[k][i];
    }
}

template <int d>
void Contact<d>::start(const Field& u, Field& anchors) const {
  int first = 0;
  for (const RigidWall<d>& wall : walls_) {
    if (wall.friction == 0) continue;
    const Vec<d> at_start = moved_by(wall, 0);
    for (Index i = 0; i < count(); ++i)
      set_anchor<d>(anchors, first, i, X_[i] + vector_at<d>(u, i) - at_start);
    first += d;
  }
}

template <int d>
Vec<d> Contact<d>::force_on(const RigidWall<d>& wall, const Vec<d>& y, Vec<d>* anchor) const {
  const BesideSurface<d> beside = wall.beside(y);
  const double overlap = wall.reach - beside.distance;
  if (!(overlap > 0)) {
    if (anchor) *anchor = y;
    return Vec<d>::Zero();
  }
  const Press press = press_of<d>(wall.modulus, radius_, overlap);
  const Vec<d> normal = press.force * beside.away;
  if (!anchor) return normal;
  Vec<d> stretch = y - *anchor;
  stretch -= stretch.dot(beside.away) * beside.away;
  const double pull = along * press.slope * stretch.norm(), most = wall.friction * press.force;
  if (pull > most) {  // slides: the spring keeps what friction can hold
    stretch *= most / pull;
    *anchor = y - stretch;
  }
  return normal - along * press.slope * stretch;
}

template <int d>
void Contact<d>::add(double time, const std::vector<Vec<d>>& x, Field& anchors, Field& v_rate) {
  for (int k = 0; k < d; ++k) std::fill_n(acceleration_[k], count(), 0.0);
  int first = 0;
  for (std::size_t n = 0; n < walls_.size(); ++n) {
    const RigidWall<d>& wall = walls_[n];
    const Vec<d> shift = moved_by(wall, time);
    const bool rough = wall.friction > 0;
    for_particles(count(), [&](Index i) {
      Vec<d> anchor = rough ? anchor_of<d>(anchors, first, i) : Vec<d>(Vec<d>::Zero());
      const bool other = wall.body && !body_.empty() && body_[i] != *wall.body;
      force_[i] = other ? Vec<d>(Vec<d>::Zero()) : force_on(wall, x[i] - shift, rough ? &anchor : nullptr);
      if (rough) set_anchor<d>(anchors, first, i, anchor);
      for (int k = 0; k < d; ++k) acceleration_[k][i] += force_[i][k] / mass_[i];
    });
    total_[n] = Vec<d>::Zero();
    for (const Vec<d>& force : force_) total_[n] += force;
    if (rough) first += d;
  }
  for (int k = 0; k < d; ++k)
    for (Index i = 0; i < count(); ++i) v_rate[k][i] += acceleration_[k][i];
}

}  // namespace plumb
