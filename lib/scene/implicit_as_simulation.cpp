#include "plumbline/scene/implicit_as_simulation.hpp"

#include "plumbline/schemes/implicit/equilibrium.hpp"

namespace plumb {
namespace {

/// The body and its way, made when the first step is.
template <int d>
struct Way {
  std::shared_ptr<TlsphSimulation<d>> body;
  double end_time;
  ImplicitOptions options;
  std::optional<EquilibriumPath<d>> path;
  double length = 0;  ///< of the next step, as a share of the whole

  EquilibriumPath<d>& gone() {
    if (!path) {
      path.emplace(body->solid, body->actions, end_time, options, body->state);
      if (length > 0) path->set_length(length);
    }
    return *path;
  }
};

Failure failure_of(const StaticFailure& failed, const Moment& now) {
  const bool inverted = failed.cause == "inverted";
  const Cause cause = inverted                       ? Cause::inverted
                      : failed.cause == "non-finite" ? Cause::non_finite
                                                     : Cause::no_convergence;
  const double residual = failed.residuals.empty() ? 0 : failed.residuals.back();
  return {now.time,
          now.step,
          cause,
          inverted ? failed.particle.particle : -1,
          inverted ? failed.particle.determinant : residual,
          inverted                        ? "J = det F"
          : failed.cause == "limit-point" ? "stiffness not positive (a limit point); residual"
                                          : "residual over forces"};
}

void refuse_what_it_has_not(const Scene& scene) {
  if (!scene.end_time)
    throw InputError("scheme = \"implicit\" needs end_time", "loads are brought on in the time until then",
                     "add end_time = \"1 s\" to [scene]");
  if (scene.initial && (!scene.initial->velocity.empty() || scene.initial->spin))
    throw InputError("[initial] gives the body a velocity", "an equilibrium has none",
                     "leave it out, or use scheme = \"tlsph\"");
}

}  // namespace

template <int d>
Simulation<d> implicit_as_simulation(const std::shared_ptr<TlsphSimulation<d>>& body, const Scene& scene) {
  refuse_what_it_has_not(scene);
  const auto way = std::make_shared<Way<d>>(Way<d>{body, *scene.end_time, scene.method.implicit, {}, 0});
  Simulation<d> simulation = as_simulation(body, scene.material);
  simulation.scheme = "implicit";
  simulation.control.energy_bound.reset();
  simulation.control.fixed_step.reset();
  simulation.control.collapse = 0;  // the way itself says how short steps may become
  simulation.has_other_work = true;
  const auto now = simulation.steps.now;
  simulation.steps.allowed = [way] { return way->gone().length() * way->end_time; };
  simulation.steps.advance = [way, now](double dt) -> std::optional<Failure> {
    const double time = way->body->state.time;
    const double share = std::min(1.0, (time + dt) / way->end_time);
    const auto failed = way->gone().move_to(share);
    if (!failed) return std::nullopt;
    return failure_of(*failed, now());
  };
  simulation.steps.out_of_bounds = [](const RunHistory&) { return std::optional<Failure>(); };
  simulation.reactions = [way] {
    std::vector<BoundaryForce<d>> forces;
    for (auto& reaction : way->gone().reactions()) forces.push_back({reaction.boundary, reaction.force});
    return forces;
  };
  simulation.begin = nullptr;
  simulation.close_step = nullptr;
  simulation.keep_budget = nullptr;
  simulation.support_work = nullptr;
  simulation.save = [way, save = simulation.save] {
    SavedState saved = save();
    saved.fields.push_back({"load step", 1, {way->gone().length()}});
    return saved;
  };
  simulation.restore = [way, restore = simulation.restore](const SavedState& saved) {
    restore(saved);
    if (const SavedField* length = field_named(saved.fields, "load step")) way->length = length->values.at(0);
  };
  return simulation;
}

template Simulation<2> implicit_as_simulation<2>(const std::shared_ptr<TlsphSimulation<2>>&, const Scene&);
template Simulation<3> implicit_as_simulation<3>(const std::shared_ptr<TlsphSimulation<3>>&, const Scene&);

}  // namespace plumb
