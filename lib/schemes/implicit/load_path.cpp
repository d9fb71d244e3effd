#include "plumbline/schemes/implicit/load_path.hpp"

#include <fmt/format.h>

#include <utility>

#include "plumbline/schemes/implicit/supported.hpp"

namespace plumb {
namespace {

constexpr double growth = 1.5;
constexpr int quick = 5;                       // iterations after which a step may grow
constexpr double least_of_first = 1.0 / 1024;  // a path that needs shorter steps does not go on
constexpr double rounding = 1e-12;             // of shares that are added up

std::string cause_of(const NewtonResult& newton) {
  if (newton.end == NewtonEnd::not_a_number) return "non-finite";
  if (newton.shifted > 0) return "limit-point";
  return newton.end == NewtonEnd::inverted ? "inverted" : "stalled";
}

/// The state at rest in an equilibrium.
template <int d>
void set_equilibrium(const Solid<d>& solid, const Eigen::VectorXd& u, double time, State<d>& state) {
  set_unknowns(solid, u, state.u);
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
LoadPath<d>::LoadPath(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                      const ImplicitOptions& options, const State<d>& state)
    : actions_(actions),
      end_time_(end_time),
      options_(options),
      balance_(solid, actions, {state.time, state.time / end_time}, unknowns_of(solid, state.u)),
      solver_(balance_.symmetric()),
      first_(options.first_step(end_time)),
      length_(first_) {
  require_support(balance_, solver_);
}

template <int d>
std::optional<StaticFailure> LoadPath<d>::go_to(double time, State<d>& state, const OnLoadStep<d>& on_step) {
  const Solid<d>& solid = balance_.energy().solid();
  const double end = time / end_time_;
  double share = state.time / end_time_;
  Eigen::VectorXd u = unknowns_of(solid, state.u);
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
      if (!options_.adaptive || shorter < least_of_first * first_)
        return StaticFailure{cause_of(found), next, solid.unsound, found.residuals};
      length_ = shorter;
      ++rejected_;
      tried_longer = true;
      continue;
    }
    share = next;
    u = trial;
    set_equilibrium(solid, u, share * end_time_, state);
    if (on_step) on_step(state, {share, found});
    if (options_.adaptive && !tried_longer && found.iterations() <= quick) length_ *= growth;
    tried_longer = false;
  }
  return std::nullopt;
}

template <int d>
std::vector<Reaction<d>> LoadPath<d>::reactions(const State<d>& state) {
  balance_.move_to(at(state.time / end_time_));
  const auto residual = balance_.residual(unknowns_of(balance_.energy().solid(), state.u));
  std::vector<Reaction<d>> reactions;
  if (!residual) return reactions;
  for (const Held<d>& held : actions_.held) reactions.push_back({held.name, Vec<d>::Zero()});
  Eigen::VectorXd left = *residual;  // of a component that two boundaries hold the later one has the force
  for (std::size_t n = reactions.size(); n-- > 0;)
    for (const HeldPlace<d>& place : actions_.held[n].places)
      reactions[n].force[place.component] += std::exchange(left[d * place.particle + place.component], 0.0);
  return reactions;
}

template class LoadPath<2>;
template class LoadPath<3>;

}  // namespace plumb
