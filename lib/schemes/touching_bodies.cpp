#include "lib/schemes/touching_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/schemes/moving_pairs.hpp"
#include "lib/schemes/point_fields.hpp"

namespace plumb {
namespace {

/// The weight of another body's particle at a distance of t reaches, (1 - t)^4 (4 t + 1).
double weight(double t) {
  const double rest = std::max(0.0, 1 - t);
  return rest * rest * rest * rest * (4 * t + 1);
}
/// Minus its slope.
double steepness(double t) {
  const double rest = std::max(0.0, 1 - t);
  return 20 * t * rest * rest * rest;
}

/// Sums over a half-space of a lattice whose first layer is one spacing away.
struct Beside {
  double phi = 0, slope = 0;  ///< the sum, and how it grows with the depth in spacings
};
template <int d>
Beside beside_half_space(double reach) {
  Beside sums;
  const int far = static_cast<int>(reach);
  for (int a = 1; a <= far; ++a)
    for (int b = d > 1 ? -far : 0; b <= (d > 1 ? far : 0); ++b)
      for (int c = d == 3 ? -far : 0; c <= (d == 3 ? far : 0); ++c) {
        const double r = std::sqrt(a * a + b * b + c * c);
        sums.phi += weight(r / reach);
        sums.slope += steepness(r / reach) / reach * a / r;
      }
  return sums;
}

constexpr double list_skin = 0.5;  // spacings

}  // namespace

template <int d>
TouchingBodies<d>::TouchingBodies(const Cloud<d>& cloud, double modulus, std::vector<double> friction)
    : neighbours_(reach * cloud.spacing, list_skin * cloud.spacing, cloud.body, PairsOf::different_bodies),
      friction_(std::move(friction)),
      bodies_(*std::max_element(cloud.body.begin(), cloud.body.end()) + 1),
      spacing_(cloud.spacing),
      modulus_(modulus) {
  const double cell = std::pow(spacing_, d);
  const Beside lattice = beside_half_space<d>(reach);
  level_ = lattice.phi;
  unit_ = modulus * cell / (2 * lattice.slope * lattice.slope);
  for (const double V : cloud.V) share_.push_back(V / cell);
  depth_.assign(cloud.X.size(), 0.0);
  force_.assign(cloud.X.size(), Vec<d>::Zero());
  if (rough()) {
    pull_ = force_;
    couple_.assign(cloud.X.size(), Mat<d>::Zero());
  }
  neighbours_.update(cloud.X);
  for (Index i = 0; i < count(); ++i)
    for (const auto j : neighbours_.list()->of(i))
      if ((cloud.X[i] - cloud.X[j]).norm() < 0.5 * spacing_)
        throw InputError(
            fmt::format("particles {} and {} of two bodies are {:.3g} spacings apart, at {}", i, j,
                        (cloud.X[i] - cloud.X[j]).norm() / spacing_, position_text<d>(cloud.X[i])),
            "bodies that touch are one spacing apart: these overlap", "move one of them");
}

template <int d>
void TouchingBodies<d>::find_depths(const std::vector<Vec<d>>& x) {
  neighbours_.update(x);
  const PairList& list = *neighbours_.list();
  touching_ = !list.other.empty();
  if (!touching_) return;
  const double per_reach = 1 / (reach * spacing_);
  for_particles(count(), [&](Index i) {
    double phi = 0;
    for (const auto j : list.of(i)) phi += share_[j] * weight((x[i] - x[j]).norm() * per_reach);
    depth_[i] = std::max(0.0, phi - level_);
  });
}

template <int d>
double TouchingBodies<d>::stored(const std::vector<Vec<d>>& x) {
  find_depths(x);
  double sum = 0;
  for (Index i = 0; i < count() && touching_; ++i) sum += share_[i] * depth_[i] * depth_[i];
  return 0.5 * unit_ * sum;
}

template <int d>
void TouchingBodies<d>::find_presses(const std::vector<Vec<d>>& x) {
  const PairList& list = *neighbours_.list();
  press_.resize(list.other.size());
  const double per_reach = 1 / (reach * spacing_);
  for_particles(count(), [&](Index i) {
    Vec<d> force = Vec<d>::Zero();
    for (auto n = list.begin[i]; n < list.begin[i + 1]; ++n) {
      const Index j = list.other[n];
      press_[n] = 0;
      if (depth_[i] + depth_[j] == 0) continue;
      const Vec<d> r = x[i] - x[j];
      const double distance = r.norm();
      if (distance == 0) continue;  // no direction, and no slope
      press_[n] = unit_ * share_[i] * share_[j] * steepness(distance * per_reach) * per_reach;
      force += (depth_[i] + depth_[j]) * press_[n] / distance * r;
    }
    force_[i] = force;
  });
}

template <int d>
Vec<d> TouchingBodies<d>::pull_of(Index i, const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion,
                                  Field& slip) const {
  const PairList& list = *neighbours_.list();
  Vec<d> press = Vec<d>::Zero(), rate = Vec<d>::Zero();
  double sum = 0;
  const auto pressed = [&](auto&& use) {
    for (auto n = list.begin[i]; n < list.begin[i + 1]; ++n)
      if (press_[n] > 0) use(list.other[n], depth_[i] * press_[n], Vec<d>(x[i] - x[list.other[n]]));
  };
  pressed([&](Index j, double f, const Vec<d>& r) {
    press += f / r.norm() * r;
    sum += f;
    // at the middle of the pair
    rate += f * (motion.v[i] - motion.v[j] - 0.5 * ((motion.L[i] + motion.L[j]) * r));
  });
  const double size = press.norm();
  if (!(size > 0)) {
    set_vector<d>(slip, i, Vec<d>::Zero());
    return Vec<d>::Zero();
  }
  const Vec<d> normal = press / size;
  double limit = 0;
  pressed([&](Index j, double f, const Vec<d>& r) {
    limit +=
        friction_[static_cast<std::size_t>(body_of(i) * bodies_ + body_of(j))] * f * r.dot(normal) / r.norm();
  });
  const double stiffness = 0.5 * along * modulus_ * share_[i] * std::pow(spacing_, d - 2);
  Vec<d> stretched = vector_at<d>(slip, i) + motion.time / sum * rate;
  stretched -= stretched.dot(normal) * normal;
  const double pulls = stiffness * stretched.norm();
  if (pulls > limit) stretched *= std::max(0.0, limit) / pulls;
  set_vector<d>(slip, i, stretched);
  return -stiffness * depth_[i] / sum * stretched;
}

template <int d>
void TouchingBodies<d>::find_friction(const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion,
                                      Field& slip) {
  const PairList& list = *neighbours_.list();
  for_particles(count(), [&](Index i) { pull_[i] = pull_of(i, x, motion, slip); });
  for_particles(count(), [&](Index i) {
    Vec<d> force = Vec<d>::Zero();
    Mat<d> couple = Mat<d>::Zero();
    for (auto n = list.begin[i]; n < list.begin[i + 1]; ++n) {
      const Vec<d> of_pair = press_[n] * (pull_[i] - pull_[list.other[n]]);
      force += of_pair;
      couple += 0.5 * of_pair * (x[i] - x[list.other[n]]).transpose();
    }
    force_[i] += force;
    couple_[i] = couple;
  });
}

template <int d>
void TouchingBodies<d>::find(const std::vector<Vec<d>>& x, const SurfaceMotion<d>& motion, Field& slip) {
  find_depths(x);
  if (touching_) {
    find_presses(x);
    if (rough()) find_friction(x, motion, slip);
    return;
  }
  std::fill(force_.begin(), force_.end(), Vec<d>::Zero());
  for (int k = 0; k < slip.components(); ++k) std::fill_n(slip[k], count(), 0.0);
}

template <int d>
double TouchingBodies<d>::step_limit(const std::vector<double>& mass) const {
  // two equal particles that press on each other; a slope of 1.33 of the flat contact's at most, squared
  const double stiffness = 2 * 1.33 * 1.33 * modulus_ * std::pow(spacing_, d - 2);
  return std::sqrt(*std::min_element(mass.begin(), mass.end()) / stiffness);
}

template class TouchingBodies<1>;
template class TouchingBodies<2>;
template class TouchingBodies<3>;

}  // namespace plumb
