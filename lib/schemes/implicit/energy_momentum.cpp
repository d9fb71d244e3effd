#include "lib/schemes/implicit/energy_momentum.hpp"

#include <cmath>

namespace plumb {
namespace {

constexpr int most_equation_solves = 60;
constexpr int most_halvings = 12;

template <int d>
Mat<d> tensor_at(const Eigen::VectorXd& all, Index place) {
  Mat<d> A;
  for (int n = 0; n < d * d; ++n) A(n / d, n % d) = all[d * d * place + n];
  return A;
}

/// Whether the last iteration gained less than a digit.
bool slow(const std::vector<double>& residuals) {
  return residuals.back() > 0.1 * residuals[residuals.size() - 2];
}

/// The share of a step to where every J is positive and, of the exact tangent, the residual is less than
/// `size`; the whole of it if there is none.
template <int d>
Eigen::VectorXd nearer(const Balance<d>& balance, const Eigen::VectorXd& from, const Eigen::VectorXd& step,
                       double size, bool less) {
  double share = 1;
  for (int k = 0; k < most_halvings; ++k, share /= 2) {
    const auto r = balance.residual(from + share * step);
    if (r && (!less || balance.free_part(*r).norm() < size)) break;
  }
  return share * step;
}

}  // namespace

template <int d>
struct EnergyMomentum<d>::Middle {
  std::shared_ptr<const EnergyOperators<d>> operators;
  PointLaw<d> law;
  Eigen::VectorXd before;  ///< F
  bool exact = false;      ///< the tangent is that of (15.15), not a symmetric one near it

  Eigen::VectorXd gradients(const Eigen::VectorXd& u) const { return operators->gradients(u); }
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
    return operators->forces(P, u);
  }
};

template <int d>
EnergyMomentum<d>::EnergyMomentum(const StoredEnergy<d>& energy, PointLaw<d> law, const Actions<d>& actions,
                                  double tolerance, const BodyMotion& from)
    : tolerance_(tolerance),
      middle_(std::make_shared<Middle>(Middle{energy.operators, std::move(law), {}})),
      balance_(
          [&] {
            StoredEnergy<d> with_steps = energy;
            const auto trouble = std::make_shared<std::optional<Trouble>>();
            with_steps.residual = [middle = middle_, trouble](const Eigen::VectorXd& u) {
              return middle->residual(u, *trouble);
            };
            with_steps.trouble = [trouble] { return *trouble; };
            with_steps.tangent = [middle = middle_](const Mat<d>& F, Index place) {
              const Mat<d> before = tensor_at<d>(middle->before, place);
              return middle->exact ? tangent_of_step<d>(middle->law, before, F)
                                   : symmetric_tangent_of_step<d>(middle->law, before, F);
            };
            return with_steps;
          }(),
          actions, {from.time, 1}, from.u),
      solver_(balance_.symmetric()),
      exact_solver_(false),
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
  middle_->exact = false;
  for (int n = 0; n <= most_equation_solves; ++n) {
    const auto all = balance_.residual(middle);
    result.end = NewtonEnd::inverted;
    if (!all) return result;
    const Eigen::VectorXd r = balance_.free_part(*all);
    const double scale = balance_.force_scale(middle, *all);
    result.residuals.push_back(scale > 0 ? r.norm() / scale : 0);
    result.end = NewtonEnd::not_a_number;
    if (!r.allFinite()) return result;
    middle_->exact = middle_->exact || (n > 0 && slow(result.residuals));
    balance_.linearise_at(middle);
    // F_1 = 2 F_m - F_0 has that of F_m twice and that of F_0
    const SparseMatrix K = balance_.tangent();
    const double round_off =
        3 * balance_.energy().residual_round_off(middle) + product_round_off(K, balance_.free_part(middle));
    if (r.norm() <= tolerance_ * scale || r.norm() <= round_off) {
      const Eigen::VectorXd moved = 2 * (middle - u);
      motion = {u + moved, 2 / dt * moved - v, motion.time + dt, motion.step + 1};
      result.end = NewtonEnd::converged;
      return result;
    }
    const auto solution = (middle_->exact ? exact_solver_ : solver_).solve(K, -r);
    if (!solution) return result;
    middle += nearer(balance_, middle, balance_.whole(solution->x), r.norm(), middle_->exact);
  }
  result.end = NewtonEnd::stalled;
  return result;
}

#define PLUMBLINE_INSTANTIATE(d) template class EnergyMomentum<d>;
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
