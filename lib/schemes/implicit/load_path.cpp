#include "lib/schemes/implicit/load_path.hpp"

#include <fmt/format.h>

#include <utility>

#include "lib/schemes/implicit/supported.hpp"

namespace plumb {
namespace {

constexpr double growth = 1.5;
constexpr int quick = 5;                       // iterations after which a step may grow
constexpr double least_of_first = 1.0 / 1024;  // a path that needs shorter steps does not go on
constexpr double rounding = 1e-12;             // of shares that are added up

std::string cause_of(const NewtonResult& newton) {
  if (newton.end == NewtonEnd::not_a_number) return "non-finite";
  if (newton.end == NewtonEnd::unsolved) return "unsolved";
  if (newton.shifted > 0) return "limit-point";
  return newton.end == NewtonEnd::inverted ? "inverted" : "stalled";
}

}  // namespace

std::string StaticFailure::in_words() const {
  const std::string where = fmt::format("no equilibrium at {:.6g} of the load: ", share);
  if (cause == "inverted")
    return where + fmt::format("J = {:.3g} at particle {}", trouble->value, trouble->particle.value());
  if (cause == "unsolved")
    return where +
           fmt::format("conjugate gradients do not end; particle {} moves most, as where nothing resists it",
                       most_moved.value());
  if (cause == "non-finite") return where + "a force is not a number";
  if (cause == "limit-point")
    return where + "the stiffness is not positive there, as beyond a limit point or where a body buckles";
  return where + fmt::format("the residual stays at {:.3g} of the forces", residuals.back());
}

template <int d>
LoadPath<d>::LoadPath(StoredEnergy<d> energy, const Actions<d>& actions, double end_time,
                      const ImplicitOptions& options, const BodyMotion& from)
    : actions_(actions),
      end_time_(end_time),
      options_(options),
      balance_(std::move(energy), actions, {from.time, from.time / end_time}, from.u),
      solver_(balance_, options.solver),
      first_(options.first_step(end_time)),
      length_(first_) {
  require_support(balance_, solver_);
}

template <int d>
std::optional<StaticFailure> LoadPath<d>::go_to(double time, BodyMotion& motion, const OnLoadStep& on_step) {
  const double end = time / end_time_;
  double share = motion.time / end_time_;
  Eigen::VectorXd u = motion.u;
  balance_.move_to(at(share));
  balance_.put_held(u);
  bool tried_longer = false;  // in vain: then the next step does not grow
  while (share < end) {
    const double next = share + length_ > end - rounding ? end : share + length_;
    Eigen::VectorXd trial = u;
    balance_.move_to(at(next));
    const NewtonResult found = equilibrium_at(balance_, solver_, options_.tolerance, trial);
    if (!found.converged()) {
      const double shorter = (next - share) / 2;
      const bool in_vain = found.end == NewtonEnd::unsolved;  // shorter steps have the same tangent
      if (!options_.adaptive || in_vain || shorter < least_of_first * first_)
        return StaticFailure{cause_of(found), next, balance_.energy().trouble(), solver_.most_moved(),
                             found.residuals};
      length_ = shorter;
      ++rejected_;
      tried_longer = true;
      continue;
    }
    share = next;
    u = trial;
    balance_.energy().commit(u);
    motion = {u, Eigen::VectorXd::Zero(u.size()), share * end_time_, motion.step + 1};
    if (on_step) on_step(motion, {share, found});
    if (options_.adaptive && !tried_longer && found.iterations() <= quick) length_ *= growth;
    tried_longer = false;
  }
  return std::nullopt;
}

template <int d>
std::vector<BoundaryForce<d>> LoadPath<d>::reactions(const BodyMotion& equilibrium) {
  balance_.move_to(at(equilibrium.time / end_time_));
  const auto residual = balance_.residual(equilibrium.u);
  if (!residual) return {};
  return forces_of_supports<d>(actions_, *residual);
}

template class LoadPath<1>;
template class LoadPath<2>;
template class LoadPath<3>;

}  // namespace plumb
