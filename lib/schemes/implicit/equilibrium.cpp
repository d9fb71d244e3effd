#include "plumbline/schemes/implicit/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plumbline/core/error.hpp"
#include "plumbline/geometry/position_text.hpp"
#include "plumbline/schemes/implicit/rigid_motion.hpp"

namespace plumb {
namespace {

constexpr double growth = 1.5;
constexpr int quick = 5;                       // iterations after which a step may grow
constexpr double least_of_first = 1.0 / 1024;  // a path that needs shorter steps does not go on

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

template <int d>
void require_support(Balance<d>& balance, DescentSolver& solver) {
  const DiscreteEnergy<d>& energy = balance.energy();
  const Cloud<d>& cloud = energy.solid().cloud;
  balance.linearise_at(Eigen::VectorXd::Zero(d * cloud.size()));
  if (const auto motion = free_rigid_motion(energy, balance.held()))
    throw InputError("the body can " + *motion, "no support resists it, so that there is no one equilibrium",
                     "hold one more component, by a [[boundary]]");
  if (const auto particle = unresisted_particle(balance, solver))
    throw InputError(fmt::format("particle {} at {} can move without a force", *particle,
                                 position_text<d>(cloud.X[static_cast<std::size_t>(*particle)])),
                     "the stiffness is singular",
                     "use a larger beta or [hourglass]; a body in separate parts needs supports for each");
}

template <int d>
std::vector<Reaction<d>> reactions_of(const Actions<d>& actions, const Eigen::VectorXd& residual) {
  std::vector<Reaction<d>> reactions;
  for (const Held<d>& held : actions.held) {
    Reaction<d> reaction{held.name, Vec<d>::Zero()};
    for (const HeldPlace<d>& place : held.places)
      reaction.force[place.component] += residual[d * place.particle + place.component];
    reactions.push_back(std::move(reaction));
  }
  return reactions;
}

std::string cause_of(const NewtonResult& newton) {
  if (newton.end == NewtonEnd::not_a_number) return "non-finite";
  if (newton.shifted > 0) return "limit-point";
  return newton.end == NewtonEnd::inverted ? "inverted" : "stalled";
}

/// The state at rest in an equilibrium.
template <int d>
void set_equilibrium(const Solid<d>& solid, const Eigen::VectorXd& u, double time, State<d>& state) {
  set_displacements(solid, u, state);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.v, solid.bonds.slots.of(i), Vec<d>::Zero());
  state.time = time;
  ++state.step;
}

}  // namespace

std::string StaticFailure::in_words() const {
  const std::string where = fmt::format("no equilibrium at {:.6g} of the load: ", share);
  if (cause == "inverted")
    return where + fmt::format("J = {:.3g} at particle {}", particle.determinant, particle.particle);
  if (cause == "non-finite") return where + "a force is not a number";
  if (cause == "limit-point")
    return where + "the stiffness is not positive there, as beyond a limit point or where a body buckles";
  return where + fmt::format("the residual stays at {:.3g} of the forces", residuals.back());
}

template <int d>
EquilibriumPath<d>::EquilibriumPath(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                    const ImplicitOptions& options, State<d>& state)
    : actions_(actions),
      options_(options),
      state_(state),
      end_time_(end_time),
      share_(state.time / end_time),
      first_(options.first_step(end_time)),
      length_(first_),
      u_(displacements_of(solid, state)),
      balance_(solid, actions, {share_, end_time}, u_),
      solver_(balance_.symmetric()) {
  require_support(balance_, solver_);
  balance_.put_held(u_);
}

template <int d>
std::optional<StaticFailure> EquilibriumPath<d>::move_to(double to, const OnLoadStep<d>& on_step) {
  while (share_ < to) {
    const bool cut = share_ + length_ > to - 1e-12;  // a step that ends there but for rounding counts
    const double next = cut ? to : share_ + length_;
    const double tried = next - share_;
    balance_.move_to(next);
    Eigen::VectorXd trial = u_;
    const NewtonResult search = equilibrium_at(balance_, solver_, options_.tolerance, trial);
    if (!search.converged()) {
      length_ = tried / 2;
      if (options_.adaptive && length_ >= least_of_first * first_) {
        ++rejected_;
        tried_longer_ = true;
        continue;
      }
      return StaticFailure{cause_of(search), next, balance_.energy().solid().unsound, search.residuals};
    }
    share_ = next;
    u_ = trial;
    steps_.push_back({share_, search});
    set_equilibrium(balance_.energy().solid(), u_, share_ * end_time_, state_);
    if (on_step) on_step(state_, steps_.back());
    if (options_.adaptive && !tried_longer_ && !cut && search.iterations() <= quick) length_ *= growth;
    tried_longer_ = false;
  }
  return std::nullopt;
}

template <int d>
std::vector<Reaction<d>> EquilibriumPath<d>::reactions() {
  balance_.move_to(share_);
  const auto residual = balance_.residual(u_);
  return residual ? reactions_of(actions_, *residual) : std::vector<Reaction<d>>{};
}

template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep<d>& on_step) {
  EquilibriumPath<d> path(solid, actions, end_time, options, state);
  StaticResult<d> result;
  result.failure = path.move_to(1, on_step);
  result.steps = path.steps();
  result.rejected = path.rejected();
  result.reactions = path.reactions();
  return result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                         \
  template StaticResult<d> find_equilibrium<d>(const Solid<d>&, const Actions<d>&, double,               \
                                               const ImplicitOptions&, State<d>&, const OnLoadStep<d>&); \
  template class EquilibriumPath<d>;
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
