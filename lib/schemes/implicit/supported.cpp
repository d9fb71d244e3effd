#include "lib/schemes/implicit/supported.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "lib/core/error.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/geometry/rigid_motions.hpp"
#include "lib/linear/dense.hpp"

namespace plumb {
namespace {

/// Of motions of size 1: what a support resists is a share of at least 1/particles, far above.
constexpr double none = 1e-10;

/// The first particle of the part that each particle belongs to. Places couple the particles that they read, terms theirs.
template <int d>
std::vector<Index> parts_of(const EnergyOperators<d>& operators) {
  std::vector<Index> before(static_cast<std::size_t>(operators.gradient.particles()));
  std::iota(before.begin(), before.end(), Index{0});
  const auto first_of = [&](Index i) {
    while (before[static_cast<std::size_t>(i)] != i)
      i = before[static_cast<std::size_t>(i)] =
          before[static_cast<std::size_t>(before[static_cast<std::size_t>(i)])];
    return i;
  };
  const auto couple = [&](Index i, Index j) {
    i = first_of(i), j = first_of(j);
    before[static_cast<std::size_t>(std::max(i, j))] = std::min(i, j);
  };
  for (Index q = 0; q < operators.gradient.places(); ++q) {
    std::optional<Index> met;
    operators.gradient.for_each(q, [&](std::int64_t, const PlaceShare<d>& share) {
      if (share.slope.squaredNorm() == 0) return;
      if (met) couple(*met, share.particle);
      met = share.particle;
    });
  }
  for (Index c = 0; c < operators.half_of_terms.cols(); ++c)
    for (SparseMatrix::InnerIterator it(operators.half_of_terms, c); it; ++it)
      if (it.value() != 0) couple(c, it.row());
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = first_of(static_cast<Index>(i));
  return before;
}

/// Of rigid motions of some particles: what they are and what resists them, as sums over unknowns.
struct Resistance {
  Eigen::MatrixXd size, resisted;
};

/// The shares of rigid motions that nothing resists, one motion per column, of length 1; motions that leave all the particles where
/// they are (a turn of one particle about itself) do not count.
Eigen::MatrixXd free_motions(const Resistance& of) {
  const SymmetricPairs all = symmetric_pairs(of.size);
  const Eigen::Index count = of.size.rows();
  Eigen::Index still = 0;
  while (still < count && all.values[still] < none * all.values[count - 1]) ++still;
  const Eigen::MatrixXd moving = all.vectors.rightCols(count - still) *
                                 all.values.tail(count - still).cwiseSqrt().cwiseInverse().asDiagonal();
  const SymmetricPairs modes = symmetric_pairs(moving.transpose() * of.resisted * moving);
  Eigen::Index free = 0;
  while (free < count - still && modes.values[free] < none) ++free;
  if (free == 0) return {count, 0};
  return orthonormal_basis(moving * modes.vectors.leftCols(free), 0);
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

/// The resistance to rigid motions of each part, by its first particle.
template <int d>
std::map<Index, Resistance> resistances(const DiscreteEnergy<d>& energy, const std::vector<Index>& held,
                                        const std::vector<Index>& part) {
  constexpr int count = RigidMotions<d>::count;
  const Cloud<d>& cloud = energy.cloud();
  const RigidMotions<d> motions(cloud.box);
  Eigen::MatrixXd displacements(d * cloud.size(), count), forces(d * cloud.size(), count);
  for (Index i = 0; i < cloud.size(); ++i)
    displacements.middleRows<d>(d * i) = motions.at(cloud.X[static_cast<std::size_t>(i)]);
  for (int k = 0; k < count; ++k) forces.col(k) = energy.tangent_times(displacements.col(k));
  forces /= energy.elastic().young * std::pow(cloud.spacing, d - 2);
  std::map<Index, Resistance> of;
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, count);
  const auto at = [&](Index n) -> Resistance& {
    return of.try_emplace(part[static_cast<std::size_t>(n / d)], Resistance{zero, zero}).first->second;
  };
  for (Index n = 0; n < displacements.rows(); ++n) {
    at(n).size += displacements.row(n).transpose() * displacements.row(n);
    at(n).resisted += forces.row(n).transpose() * forces.row(n);
  }
  for (const Index n : held) at(n).resisted += displacements.row(n).transpose() * displacements.row(n);
  return of;
}

}  // namespace

template <int d>
std::optional<LoosePart> loose_part(const DiscreteEnergy<d>& energy, const std::vector<Index>& held) {
  const RigidMotions<d> motions(energy.cloud().box);
  const std::vector<Index> part = parts_of(energy.operators());
  for (const auto& [first, resistance] : resistances(energy, held, part)) {
    const Eigen::MatrixXd free = free_motions(resistance);
    if (free.cols() == 0) continue;
    const bool whole = std::all_of(part.begin(), part.end(), [](Index n) { return n == 0; });
    return LoosePart{whole ? std::nullopt : std::optional<Index>(first),
                     in_words(motions, chosen_motion(free, d))};
  }
  return std::nullopt;
}

template <int d>
void require_support(Balance<d>& balance, TangentSolver<d>& solver) {
  const DiscreteEnergy<d>& energy = balance.energy();
  if (energy.unknowns().empty()) return;
  const Cloud<d>& cloud = energy.cloud();
  const auto place = [&](Index particle) {
    return fmt::format("particle {} at {}", particle,
                       position_text<d>(cloud.X[static_cast<std::size_t>(particle)]));
  };
  solver.linearise_at(balance, Eigen::VectorXd::Zero(d * cloud.size()));
  if (const auto loose = loose_part(energy, balance.held())) {
    if (!loose->particle)
      throw InputError("the body can " + loose->motion,
                       "no support resists it, so that there is no one equilibrium",
                       "hold one more component, by a [[boundary]]");
    throw InputError(place(*loose->particle) + " can " + loose->motion + " with all that hangs on it",
                     "the body is in separate parts, and no support resists it there",
                     "give each part supports, or leave out particles that belong to none");
  }
  if (solver.iterates()) return;  // what else moves without a force shows in a search that does not end
  if (const auto particle = unresisted_particle(balance, solver.factors()))
    throw InputError(place(*particle) + " can move without a force", "the stiffness is singular",
                     "use a larger beta or [hourglass]");
}

#define PLUMBLINE_INSTANTIATE(d)                                                                        \
  template std::optional<LoosePart> loose_part<d>(const DiscreteEnergy<d>&, const std::vector<Index>&); \
  template void require_support<d>(Balance<d>&, TangentSolver<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
