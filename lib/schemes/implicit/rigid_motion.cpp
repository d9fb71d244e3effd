#include "plumbline/schemes/implicit/rigid_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "plumbline/geometry/position_text.hpp"

namespace plumb {
namespace {

/// Of displacements of order 1: what a support resists is a share of at least 1/particles, far above.
constexpr double none = 1e-10;

template <int d>
Vec<d> middle_of(const Cloud<d>& cloud) {
  Vec<d> sum = Vec<d>::Zero();
  for (const Vec<d>& X : cloud.X) sum += X;
  return sum / static_cast<double>(cloud.size());
}

template <int d>
double reach_of(const Cloud<d>& cloud, const Vec<d>& middle) {
  double reach = 0;
  for (const Vec<d>& X : cloud.X) reach = std::max(reach, (X - middle).norm());
  return reach;
}

/// The motion of the null space `free` (columns) that is named: a translation along an axis if there is one.
Eigen::VectorXd chosen_motion(const Eigen::MatrixXd& free, int translations) {
  for (int k = 0; k < translations; ++k) {
    const Eigen::VectorXd axis = Eigen::VectorXd::Unit(free.rows(), k);
    if ((free * free.transpose() * axis - axis).norm() < none) return axis;
  }
  return free.col(0);
}

/// A point or direction for messages: what is rounding of `size` is zero.
template <int d>
std::string place_text(Vec<d> at, double size) {
  for (int k = 0; k < d; ++k)
    if (std::abs(at[k]) < none * size) at[k] = 0;
  return position_text<d>(at);
}

/// In words. The rotation part of `motion` is in units of 1/reach.
template <int d>
std::string in_words(const Eigen::VectorXd& motion, const Vec<d>& middle, double reach) {
  const Vec<d> t = motion.head<d>();
  if (motion.tail(motion.size() - d).norm() < 1e-6 * motion.norm()) {
    for (int k = 0; k < d; ++k)
      if (std::abs(t[k]) > (1 - 1e-6) * t.norm()) return fmt::format("move along {}", "xyz"[k]);
    return "move along " + place_text<d>(t / t.norm(), 1);
  }
  if constexpr (d == 2) {
    const double w = motion[2] / reach;
    return "turn about " + place_text<2>(middle + Vec<2>(-t[1], t[0]) / w, reach);
  } else {
    const Vec<3> w = motion.tail<3>() / reach;
    const Vec<3> cross(w[1] * t[2] - w[2] * t[1], w[2] * t[0] - w[0] * t[2], w[0] * t[1] - w[1] * t[0]);
    return "turn about the direction " + place_text<3>(w / w.norm(), 1) + " through " +
           place_text<3>(middle + cross / w.squaredNorm(), reach);
  }
}

}  // namespace

template <int d>
Eigen::MatrixXd rigid_motions(const Cloud<d>& cloud) {
  constexpr int rotations = d == 2 ? 1 : 3;
  const Vec<d> middle = middle_of(cloud);
  const double reach = reach_of(cloud, middle);
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(d * cloud.size(), d + rotations);
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d> arm = (cloud.X[i] - middle) / reach;
    for (int k = 0; k < d; ++k) motions(d * i + k, k) = 1;
    for (int r = 0; r < rotations; ++r) {  // e_r x arm; about z in 2D
      const int a = d == 2 ? 0 : (r + 1) % 3, b = d == 2 ? 1 : (r + 2) % 3;
      motions(d * i + a, d + r) = -arm[b];
      motions(d * i + b, d + r) = arm[a];
    }
  }
  return motions;
}

template <int d>
std::optional<std::string> free_rigid_motion(const DiscreteEnergy<d>& energy,
                                             const std::vector<Index>& held) {
  const Cloud<d>& cloud = energy.solid().cloud;
  const Eigen::MatrixXd motions = rigid_motions(cloud);
  const Index count = motions.cols();
  Eigen::MatrixXd resisted = Eigen::MatrixXd::Zero(count, count);
  for (const Index n : held) resisted += motions.row(n).transpose() * motions.row(n);
  Eigen::MatrixXd forces(motions.rows(), count);
  for (Index k = 0; k < count; ++k) forces.col(k) = energy.tangent_times(motions.col(k));
  const double stiffness = energy.solid().elastic.young * std::pow(cloud.spacing, d - 2);
  resisted += forces.transpose() * forces / (stiffness * stiffness);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(resisted);
  Index free = 0;
  while (free < count && modes.eigenvalues()[free] < none) ++free;
  if (free == 0) return std::nullopt;
  const Vec<d> middle = middle_of(cloud);
  return in_words<d>(chosen_motion(modes.eigenvectors().leftCols(free), d), middle, reach_of(cloud, middle));
}

#define PLUMBLINE_INSTANTIATE(d)                                                     \
  template Eigen::MatrixXd rigid_motions<d>(const Cloud<d>&);                        \
  template std::optional<std::string> free_rigid_motion<d>(const DiscreteEnergy<d>&, \
                                                           const std::vector<Index>&);
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
