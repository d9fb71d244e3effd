#include "lib/schemes/implicit/energy_momentum.hpp"

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/material/laws.hpp"

namespace plumb {
namespace {

constexpr int most_equation_solves = 60;
constexpr int most_halvings = 12;

template <int d>
double volume_of(const Cloud<d>& cloud) {
  double sum = 0;
  for (const double V : cloud.V) sum += V;
  return sum;
}

template <int d>
Mat<d> tensor_at(const Eigen::VectorXd& all, Index place) {
  Mat<d> A;
  for (int n = 0; n < d * d; ++n) A(n / d, n % d) = all[d * d * place + n];
  return A;
}

// Below this a step changes W by less than its round-off; the correction is of third order.
constexpr double no_change = 1e-8;

/// C_1 - C_0.
template <int d>
Mat<d> change_of_stretch(const Mat<d>& before, const Mat<d>& middle) {
  const Mat<d> after = 2 * middle - before;
  return after.transpose() * after - before.transpose() * before;
}

/// P = F_m S with S_m of the middle and what makes S : dC/2 the change of W. THEORY (15.13).
template <int d>
Mat<d> stress_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle) {
  const Mat<d> after = 2 * middle - before;
  const Mat<d> twice = middle.inverse() * law.first_piola(middle);
  Mat<d> S = 0.5 * (twice + twice.transpose());
  const Mat<d> change = change_of_stretch<d>(before, middle);
  const double size = change.squaredNorm();
  if (size > no_change * no_change)
    S += (2 * (law.energy(after) - law.energy(before)) - S.cwiseProduct(change).sum()) / size * change;
  return middle * S;
}

}  // namespace

template <int d>
PointLaw<d> objective_law(const LawChoice& choice, const Elastic& elastic) {
  PointLaw<d> made;
  with_elastic_law<d>(choice, elastic, [&]<class M>(const M& law) {
    if (choice.name == "linear-elastic")
      throw InputError("dynamics = \"energy-momentum\" with model = \"linear-elastic\"",
                       "that law feels a rotation, so that its stress has a torque",
                       "use another law, or dynamics = \"midpoint\"");
    made = {[law](const Mat<d>& F) { return law.energy(F); },
            [law](const Mat<d>& F) -> Mat<d> { return law.first_piola(F); }};
  });
  return made;
}

template <int d>
struct EnergyMomentum<d>::Middle {
  LinearOperators operators;
  PointLaw<d> law;
  double energy_round_off;  ///< of W near the reference [Pa]
  Eigen::VectorXd before;   ///< F

  Eigen::VectorXd gradients(const Eigen::VectorXd& u) const {
    return operators.identity + operators.gradient * u;
  }
  /// What round-off of W leaves of the force, by way of the bracket of (15.13) [N].
  double residual_round_off(const Eigen::VectorXd& u) const {
    const Eigen::VectorXd F = gradients(u);
    Eigen::VectorXd P(F.size());
    for (Index q = 0; q < F.size() / (d * d); ++q) {
      const double change = change_of_stretch<d>(tensor_at<d>(before, q), tensor_at<d>(F, q)).norm();
      const double error = change > no_change ? 2 * energy_round_off / change : 0;
      P.segment(d * d * q, d * d) = error * F.segment(d * d * q, d * d).cwiseAbs();
    }
    return (operators.force.cwiseAbs() * P).norm();
  }
  /// Minus the internal force of the step [N]; nullopt if J is not positive at its middle or its end.
  std::optional<Eigen::VectorXd> residual(const Eigen::VectorXd& u, std::optional<Trouble>& trouble) const {
    const Eigen::VectorXd F = gradients(u);
    Eigen::VectorXd P(F.size());
    for (Index q = 0; q < F.size() / (d * d); ++q) {
      const Mat<d> middle = tensor_at<d>(F, q), first = tensor_at<d>(before, q);
      const double J = std::min(middle.determinant(), Mat<d>(2 * middle - first).determinant());
      if (!(J > 0)) {
        trouble = Trouble{q, "J = det F", J};
        return std::nullopt;
      }
      const Mat<d> stress = stress_of_step(law, first, middle);
      for (int n = 0; n < d * d; ++n) P[d * d * q + n] = stress(n / d, n % d);
    }
    return operators.force * P + operators.terms * u;
  }
};

template <int d>
EnergyMomentum<d>::EnergyMomentum(const StoredEnergy<d>& energy, PointLaw<d> law, const Actions<d>& actions,
                                  double tolerance, const BodyMotion& from)
    : tolerance_(tolerance),
      middle_(std::make_shared<Middle>(
          Middle{energy.operators, std::move(law), energy.round_off / volume_of(energy.cloud), {}})),
      balance_(
          [&] {
            StoredEnergy<d> with_steps = energy;
            const auto trouble = std::make_shared<std::optional<Trouble>>();
            with_steps.residual = [middle = middle_, trouble](const Eigen::VectorXd& u) {
              return middle->residual(u, *trouble);
            };
            with_steps.trouble = [trouble] { return *trouble; };
            return with_steps;
          }(),
          actions, {from.time, 1}, from.u),
      solver_(balance_.symmetric()),
      mass_(d * energy.cloud.size()) {
  for (Index i = 0; i < energy.cloud.size(); ++i)
    mass_.segment<d>(d * i).setConstant(energy.elastic.density * energy.cloud.V[i]);
}

template <int d>
NewtonResult EnergyMomentum<d>::step(BodyMotion& motion, double dt) {
  const Eigen::VectorXd &u = motion.u, &v = motion.v;
  middle_->before = middle_->gradients(u);
  Eigen::VectorXd end = u + dt * v;
  balance_.move_to({motion.time + dt, 1});
  balance_.put_held(end);
  balance_.move_to({motion.time + dt / 2, 1});
  balance_.set_inertia(4 / (dt * dt) * mass_, u + dt / 2 * v);
  Eigen::VectorXd middle = 0.5 * (u + end);
  NewtonResult result;
  for (int n = 0; n <= most_equation_solves; ++n) {
    const auto all = balance_.residual(middle);
    result.end = NewtonEnd::inverted;
    if (!all) return result;
    const Eigen::VectorXd r = balance_.free_part(*all);
    const double scale = balance_.force_scale(middle, *all);
    result.residuals.push_back(scale > 0 ? r.norm() / scale : 0);
    result.end = NewtonEnd::not_a_number;
    if (!r.allFinite()) return result;
    balance_.linearise_at(middle);
    const double round_off =
        balance_.energy().residual_round_off(middle) + middle_->residual_round_off(middle);
    if (r.norm() <= tolerance_ * scale || r.norm() <= round_off) {
      const Eigen::VectorXd moved = 2 * (middle - u);
      motion = {u + moved, 2 / dt * moved - v, motion.time + dt, motion.step + 1};
      result.end = NewtonEnd::converged;
      return result;
    }
    const auto solution = solver_.solve(balance_.tangent(), -r);
    if (!solution) return result;
    const Eigen::VectorXd step = balance_.whole(solution->x);
    double share = 1;
    for (int k = 0; k < most_halvings && !balance_.residual(middle + share * step); ++k) share /= 2;
    middle += share * step;
  }
  result.end = NewtonEnd::stalled;
  return result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                       \
  template PointLaw<d> objective_law<d>(const LawChoice& law, const Elastic& elastic); \
  template class EnergyMomentum<d>;
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
