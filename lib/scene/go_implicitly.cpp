#include "lib/scene/go_implicitly.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/actions/does_work.hpp"
#include "lib/core/error.hpp"
#include "lib/schemes/implicit/arc_length.hpp"
#include "lib/schemes/implicit/energy_momentum.hpp"
#include "lib/schemes/implicit/load_path.hpp"
#include "lib/schemes/implicit/midpoint.hpp"
#include "lib/schemes/implicit/misprints.hpp"
#include "lib/schemes/implicit/trapezoid.hpp"

namespace plumb {
namespace {

constexpr const char *load_field = "load factor", *step_field = "last step of the path";

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Index>(values.size()));
}

/// The body and its way, made when the first step is.
template <int d>
struct Way {
  ImplicitBody<d> body;
  double end_time;
  ImplicitOptions options;
  std::optional<LoadPath<d>> path;
  std::optional<ArcLengthPath<d>> arc;
  std::optional<SavedState>
      restored;              ///< where an earlier part of the run had come to on its path by arc length
  double restored_step = 0;  ///< [s]: the load step that an earlier part of the run would have tried; 0: none

  ArcLengthPath<d>& arc_path() {
    if (arc) return *arc;
    arc.emplace(body.energy(), body.actions(), options.tolerance);
    if (restored)
      arc->go_on_from({body.motion().u, field_named(restored->fields, load_field)->values.at(0), 0},
                      vector_of(field_named(restored->fields, step_field)->values));
    return *arc;
  }
  LoadPath<d>& load_path() {
    if (!path) {
      path.emplace(body.energy(), body.actions(), end_time, options, body.motion());
      if (restored_step > 0) path->set_next_step(restored_step);
    }
    return *path;
  }
};

/// nullopt: no search was made.
std::optional<double> last_of(const std::vector<double>& residuals) {
  return residuals.empty() ? std::nullopt : std::optional(residuals.back());
}

Failure no_equilibrium(const StaticFailure& failed, const Moment& now) {
  if (failed.cause == "inverted")
    return {now.time,
            now.step,
            Cause::inverted,
            failed.trouble->particle,
            failed.trouble->value,
            failed.trouble->quantity};
  const auto residual = last_of(failed.residuals);
  std::string what = "residual over the forces";
  if (failed.cause == "limit-point") what = "beyond a limit point; " + what;
  if (failed.cause == "unsolved")
    what = "conjugate gradients do not end, as where nothing resists a particle; " + what;
  const Cause cause = failed.cause == "non-finite" ? Cause::non_finite : Cause::no_convergence;
  return {now.time, now.step, cause, failed.most_moved, residual, what};
}

Failure no_step(const NewtonResult& search, const std::optional<Trouble>& trouble, const Moment& now) {
  if (search.end == NewtonEnd::inverted)
    return {now.time, now.step, Cause::inverted, trouble->particle, trouble->value, trouble->quantity};
  return {now.time,
          now.step,
          Cause::no_convergence,
          std::nullopt,
          last_of(search.residuals),
          "residual over the forces"};
}

void refuse_what_it_has_not(const Scene& scene) {
  if (!scene.end_time)
    throw InputError(fmt::format("scheme = \"{}\" needs end_time", scene.method.scheme),
                     "loads are brought on in the time until then", "add end_time = \"1 s\" to [scene]");
  if (scene.method.implicit.moves()) return;
  if (scene.initial && (!scene.initial->velocity.empty() || scene.initial->spin))
    throw InputError("[initial] gives the body a velocity", "an equilibrium has none",
                     "leave it out, or use scheme = \"tlsph\"");
}

/// What neither accounts for.
template <int d>
void leave_out_accounts(Simulation<d>& simulation, const Actions<d>& actions) {
  simulation.has_other_work = does_work(actions);
  simulation.begin = nullptr;
  simulation.close_step = nullptr;
  simulation.keep_budget = nullptr;
  simulation.external_work = nullptr;
}

/// Steps from equilibrium to equilibrium.
template <int d>
void go_by_loads(Simulation<d>& simulation, const std::shared_ptr<Way<d>>& way) {
  const auto now = simulation.steps.now;
  simulation.control.energy_bound.reset();
  simulation.control.fixed_step.reset();
  simulation.control.collapse = 0;  // the path itself says how short steps may become
  simulation.has_other_work = true;
  simulation.steps.allowed = [way] { return way->load_path().next_step(); };
  simulation.steps.advance = [way, now](double dt) -> std::optional<Failure> {
    BodyMotion motion = way->body.motion();
    const auto failed = way->load_path().go_to(now().time + dt, motion);
    way->body.move(motion);
    if (!failed) return std::nullopt;
    return no_equilibrium(*failed, now());
  };
  simulation.steps.out_of_bounds = [](const RunRecord&) { return std::optional<Failure>(); };
  simulation.reactions = [way] { return way->load_path().reactions(way->body.motion()); };
  simulation.save = [way, save = simulation.save] {
    SavedState saved = save();
    saved.fields.push_back({"load step", 1, {way->load_path().next_step()}});
    return saved;
  };
  simulation.restore = [way, restore = simulation.restore](const SavedState& saved) {
    restore(saved);
    if (const SavedField* step = field_named(saved.fields, "load step"))
      way->restored_step = step->values.at(0);
  };
}

/// Steps along a path on which the size of the loads is found; times count the steps.
template <int d>
void go_by_arc_length(Simulation<d>& simulation, const std::shared_ptr<Way<d>>& way) {
  simulation.control.energy_bound.reset();
  simulation.control.fixed_step.reset();
  simulation.has_other_work = true;
  const double dt = way->options.first_step(way->end_time) * way->end_time;
  simulation.steps.allowed = [dt] { return dt; };
  simulation.steps.advance = [way, now = simulation.steps.now](double step) -> std::optional<Failure> {
    const double particles = static_cast<double>(way->body.motion().u.size()) / d;
    const auto next = way->arc_path().step(*way->options.arc_length * std::sqrt(particles));
    if (!next)
      return Failure{now().time,
                     now().step,
                     Cause::no_convergence,
                     std::nullopt,
                     way->arc_path().point().load,
                     "no equilibrium at a thousandth of arc_length from the last one, whose load factor"};
    way->body.move({next->u, Eigen::VectorXd::Zero(next->u.size()), now().time + step, now().step + 1});
    return std::nullopt;
  };
  simulation.steps.out_of_bounds = [](const RunRecord&) { return std::optional<Failure>(); };
  simulation.reactions = [way] { return way->arc_path().reactions(); };
  simulation.load_factor = [way] { return way->arc_path().point().load; };
  simulation.save = [way, save = simulation.save] {
    SavedState saved = save();
    const Eigen::VectorXd last = way->arc_path().last_step();
    saved.fields.push_back({load_field, 1, {way->arc_path().point().load}});
    saved.fields.push_back({step_field, d, {last.data(), last.data() + last.size()}});
    return saved;
  };
  simulation.restore = [way, restore = simulation.restore](const SavedState& saved) {
    restore(saved);
    if (field_named(saved.fields, load_field) && field_named(saved.fields, step_field)) way->restored = saved;
    way->arc.reset();
  };
}

/// Steps in time by a rule that make() makes when the first step is.
template <class Rule, int d, class Make>
void go_in_time(Simulation<d>& simulation, const std::shared_ptr<Way<d>>& way, Make&& make) {
  const auto now = simulation.steps.now;
  const auto rule = std::make_shared<std::unique_ptr<Rule>>();
  const double dt = way->options.first_step(way->end_time) * way->end_time;
  simulation.steps.allowed = [dt] { return dt; };
  simulation.steps.advance = [way, rule, now, make](double step) -> std::optional<Failure> {
    BodyMotion motion = way->body.motion();
    if (!*rule) *rule = make(motion);
    const NewtonResult search = (*rule)->step(motion, step);
    if (!search.converged()) return no_step(search, (*rule)->energy().trouble(), now());
    way->body.move(motion);
    return std::nullopt;
  };
}

}  // namespace

Statement said_of(const ImplicitOptions& options) {
  return {std::string(ImplicitOptions::subject), options.in_words(), std::string(ImplicitOptions::theory)};
}

template <int d>
void go_implicitly(Simulation<d>& simulation, ImplicitBody<d> body, const Scene& scene) {
  refuse_what_it_has_not(scene);
  for (const std::string& sentence : scene.method.unused) simulation.warnings.push_back(sentence);
  if (!scene.method.implicit.misprints.empty())
    body.energy = [made = body.energy, options = scene.method.implicit] {
      return with_misprints<d>(made(), options);
    };
  const auto way = std::make_shared<Way<d>>(
      Way<d>{std::move(body), *scene.end_time, scene.method.implicit, {}, {}, {}, 0});
  leave_out_accounts(simulation, way->body.actions());
  if (simulation.account)
    simulation.account = [account = simulation.account, said = said_of(scene.method.implicit)] {
      auto all = account();
      all.push_back(said);
      return all;
    };
  const double tolerance = scene.method.implicit.tolerance;
  if (scene.method.implicit.midpoint)
    go_in_time<Midpoint<d>>(simulation, way, [way, tolerance](const BodyMotion& from) {
      return std::make_unique<Midpoint<d>>(way->body.energy(), way->body.actions(), tolerance, from,
                                           way->options.solver);
    });
  else if (scene.method.implicit.trapezoid)
    go_in_time<Trapezoid<d>>(simulation, way, [way, tolerance](const BodyMotion& from) {
      return std::make_unique<Trapezoid<d>>(way->body.energy(), way->body.actions(), tolerance, from,
                                            way->options.solver);
    });
  else if (scene.method.implicit.energy_momentum)
    go_in_time<EnergyMomentum<d>>(
        simulation, way,
        [way, tolerance,
         law = objective_law<d>(scene.material.law(), scene.material.elastic())](const BodyMotion& from) {
          return std::make_unique<EnergyMomentum<d>>(way->body.energy(), law, way->body.actions(), tolerance,
                                                     from);
        });
  else if (scene.method.implicit.arc_length)
    go_by_arc_length(simulation, way);
  else
    go_by_loads(simulation, way);
}

template void go_implicitly<1>(Simulation<1>&, ImplicitBody<1>, const Scene&);
template void go_implicitly<2>(Simulation<2>&, ImplicitBody<2>, const Scene&);
template void go_implicitly<3>(Simulation<3>&, ImplicitBody<3>, const Scene&);

}  // namespace plumb
