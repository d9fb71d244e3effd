#include "lib/schemes/implicit/supported.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/geometry/rigid_motions.hpp"

namespace plumb {
namespace {

/// Of displacements of order 1: what a support resists is a share of at least 1/particles, far above.
constexpr double none = 1e-10;

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

/// The motion with these shares of the rigid motions, u = t + w x (X - centre), in words.
template <int d>
std::string in_words(const RigidMotions<d>& motions, const Eigen::VectorXd& shares) {
  const Vec<d> t = motions.at(motions.centre) * shares;
  Mat<d> spin;
  for (int k = 0; k < d; ++k) spin.col(k) = motions.at(motions.centre + Vec<d>::Unit(k)) * shares - t;
  const double size = 1 / motions.scale;
  if (spin.norm() * size < none) {
    for (int k = 0; k < d; ++k)
      if (std::abs(t[k]) > (1 - none) * t.norm()) return fmt::format("move along {}", "xyz"[k]);
    return "move along " + place_text<d>(t / t.norm(), 1);
  }
  if constexpr (d == 2) {
    return "turn about " + place_text<2>(motions.centre + Vec<2>(-t[1], t[0]) / spin(1, 0), size);
  } else if constexpr (d == 3) {
    const Vec<3> w(spin(2, 1), spin(0, 2), spin(1, 0));
    const Vec<3> cross(w[1] * t[2] - w[2] * t[1], w[2] * t[0] - w[0] * t[2], w[0] * t[1] - w[1] * t[0]);
    return "turn about the direction " + place_text<3>(w / w.norm(), 1) + " through " +
           place_text<3>(motions.centre + cross / w.squaredNorm(), size);
  }
  return "move";  // not reached: nothing turns on a line
}

/// The particle that moves most in a motion which the tangent does not resist; nullopt if it resists all.
/// Inverse iteration: each step multiplies the softest motion by the ratio of two stiffnesses.
template <int d>
std::optional<Index> unresisted_particle(Balance<d>& balance, DescentSolver& solver) {
  const SparseMatrix K = balance.tangent();
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(K.rows(), 1, 2);
  const auto first = solver.solve(K, x);
  if (!first) return 0;
  x = first->x;
  for (int n = 0; n < 5; ++n) x = solver.again(x / x.norm());
  // the softest bending of a slender body is 1e-10 of the largest stiffness, rounding of K 1e-16
  constexpr double nothing = 1e-13;
  if ((K * x).norm() > nothing * K.diagonal().maxCoeff() * x.norm()) return std::nullopt;
  Index most = 0;
  x.cwiseAbs().maxCoeff(&most);
  return balance.energy().unknowns()[static_cast<std::size_t>(most)] / d;
}

}  // namespace

template <int d>
std::optional<std::string> free_rigid_motion(const DiscreteEnergy<d>& energy,
                                             const std::vector<Index>& held) {
  constexpr int count = RigidMotions<d>::count;
  const Cloud<d>& cloud = energy.cloud();
  const RigidMotions<d> motions(cloud.box);
  Eigen::MatrixXd displacements(d * cloud.size(), count);
  for (Index i = 0; i < cloud.size(); ++i)
    displacements.middleRows<d>(d * i) = motions.at(cloud.X[static_cast<std::size_t>(i)]);
  Eigen::MatrixXd resisted = Eigen::MatrixXd::Zero(count, count);
  for (const Index n : held) resisted += displacements.row(n).transpose() * displacements.row(n);
  Eigen::MatrixXd forces(displacements.rows(), count);
  for (int k = 0; k < count; ++k) forces.col(k) = energy.tangent_times(displacements.col(k));
  const double stiffness = energy.elastic().young * std::pow(cloud.spacing, d - 2);
  resisted += forces.transpose() * forces / (stiffness * stiffness);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(resisted);
  Index free = 0;
  while (free < count && modes.eigenvalues()[free] < none) ++free;
  if (free == 0) return std::nullopt;
  return in_words(motions, chosen_motion(modes.eigenvectors().leftCols(free), d));
}

template <int d>
void require_support(Balance<d>& balance, TangentSolver<d>& solver) {
  const DiscreteEnergy<d>& energy = balance.energy();
  if (energy.unknowns().empty()) return;
  const Cloud<d>& cloud = energy.cloud();
  solver.linearise_at(balance, Eigen::VectorXd::Zero(d * cloud.size()));
  if (const auto motion = free_rigid_motion(energy, balance.held()))
    throw InputError("the body can " + *motion, "no support resists it, so that there is no one equilibrium",
                     "hold one more component, by a [[boundary]]");
  if (solver.iterates()) return;  // a particle that moves without a force shows as a search that does not end
  if (const auto particle = unresisted_particle(balance, solver.factors()))
    throw InputError(fmt::format("particle {} at {} can move without a force", *particle,
                                 position_text<d>(cloud.X[static_cast<std::size_t>(*particle)])),
                     "the stiffness is singular",
                     "use a larger beta or [hourglass]; a body in separate parts needs supports for each");
}

#define PLUMBLINE_INSTANTIATE(d)                                                       \
  template std::optional<std::string> free_rigid_motion<d>(const DiscreteEnergy<d>&,   \
                                                           const std::vector<Index>&); \
  template void require_support<d>(Balance<d>&, TangentSolver<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
