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
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep<d>& on_step) {
  StaticResult<d> result;
  Eigen::VectorXd u = displacements_of(solid, state);
  double share = state.time / end_time;
  Balance<d> balance(solid, actions, {share, end_time}, u);
  DescentSolver solver(balance.symmetric());
  require_support(balance, solver);
  balance.put_held(u);
  const double first = options.first_step(end_time);
  double length = first;
  bool tried_longer = false;  // in vain: then the next step does not grow
  while (share < 1) {
    const double next = share + length > 1 - 1e-12 ? 1 : share + length;
    balance.move_to(next);
    Eigen::VectorXd trial = u;
    const NewtonResult search = equilibrium_at(balance, solver, options.tolerance, trial);
    length = next - share;
    if (!search.converged()) {
      length /= 2;
      if (options.adaptive && length >= least_of_first * first) {
        ++result.rejected;
        tried_longer = true;
        continue;
      }
      result.failure = {cause_of(search), next, balance.energy().solid().unsound, search.residuals};
      break;
    }
    share = next;
    u = trial;
    result.steps.push_back({share, search});
    set_equilibrium(solid, u, share * end_time, state);
    if (on_step) on_step(state, result.steps.back());
    if (options.adaptive && !tried_longer && search.iterations() <= quick) length *= growth;
    tried_longer = false;
  }
  balance.move_to(share);
  if (const auto r = balance.residual(u)) result.reactions = reactions_of(actions, *r);
  return result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                           \
  template StaticResult<d> find_equilibrium<d>(const Solid<d>&, const Actions<d>&, double, \
                                               const ImplicitOptions&, State<d>&, const OnLoadStep<d>&);
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
