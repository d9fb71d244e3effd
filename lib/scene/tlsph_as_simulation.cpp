#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lib/material/point.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/schemes/tlsph/boundary/open_forces.hpp"
#include "lib/schemes/tlsph/boundary/relaxation.hpp"
#include "lib/schemes/tlsph/boundary/support_work.hpp"
#include "lib/schemes/tlsph/measures/budget_file.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/traffic.hpp"

namespace plumb {
namespace {

/// A body with what follows it through a run. It lives as long as the functions of the simulation.
template <int d>
struct Followed {
  std::shared_ptr<TlsphBody<d>> body;
  ClosestPairs<d> closest;
  std::shared_ptr<const OpenForces<d>> forces;  ///< null without supports or relaxation
  std::optional<Relaxation<d>> relaxation;
  std::optional<double> residual;  ///< of the last step, if it was looked at
  std::optional<BudgetFile<d>> budget;
  std::optional<SupportWork<d>> support_work;
  double support_work_before = 0, support_power_before = 0;  ///< of an earlier part of the run [J], [W]
};

/// Component by component on slots to particle by particle, and back.
template <int d>
SavedField gathered(const char* name, const Solid<d>& solid, const Field& field) {
  SavedField saved{name, d, std::vector<double>(static_cast<std::size_t>(solid.cloud.size()) * d)};
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d; ++k) saved.values[i * d + k] = field[k][solid.bonds.slots.of(i)];
  return saved;
}

template <int d>
void scatter(const Solid<d>& solid, const SavedField* saved, Field& field) {
  const auto needed = static_cast<std::size_t>(solid.cloud.size()) * d;
  if (!saved || saved->values.size() != needed)
    throw InputError(
        "the checkpoint has another number of particles",
        fmt::format("{}, the scene {}", saved ? saved->values.size() / d : 0, solid.cloud.size()), "");
  for (Index i = 0; i < solid.cloud.size(); ++i)
    for (int k = 0; k < d; ++k) field[k][solid.bonds.slots.of(i)] = saved->values[i * d + k];
}

template <int d>
SavedState save(const Followed<d>& followed) {
  const Solid<d>& solid = followed.body->solid;
  const State<d>& state = followed.body->state;
  SavedState saved{{state.time, state.step}, followed.body->stepper.workspace->work, {}};
  saved.fields.push_back(gathered("displacement", solid, state.u));
  saved.fields.push_back(gathered("velocity", solid, state.v));
  const auto& carried = followed.body->stepper.carried;
  if (const Field* field = carried ? carried() : nullptr)
    saved.fields.push_back(gathered("integrator", solid, *field));
  const auto& work = followed.support_work;
  saved.fields.push_back({"supports",
                          2,
                          {work ? work->done() : followed.support_work_before,
                           work ? work->power() : followed.support_power_before}});
  if (followed.relaxation) saved.fields.push_back({"relaxation", 1, {followed.relaxation->rate()}});
  return saved;
}

template <int d>
void restore(Followed<d>& followed, const SavedState& saved) {
  Solid<d>& solid = followed.body->solid;
  State<d>& state = followed.body->state;
  scatter(solid, field_named(saved.fields, "displacement"), state.u);
  scatter(solid, field_named(saved.fields, "velocity"), state.v);
  state.time = saved.now.time;
  state.step = saved.now.step;
  const SavedField* integrator = field_named(saved.fields, "integrator");
  if (integrator && followed.body->stepper.carry) {
    Field carried = solid.make_field(d);
    scatter(solid, integrator, carried);
    followed.body->stepper.carry(carried);
  }
  followed.body->stepper.workspace->work = saved.work;
  const SavedField* supports = field_named(saved.fields, "supports");
  if (!supports || supports->values.size() != 2)
    throw InputError("the checkpoint has no work of supports", "", "start the run anew, without --resume");
  const SavedField* relaxation = field_named(saved.fields, "relaxation");
  if (followed.relaxation && relaxation) followed.relaxation->set_rate(relaxation->values.at(0));
  followed.support_work_before = supports->values[0];
  followed.support_power_before = supports->values[1];
}

/// What happens before the first step: the work of supports is read behind the budget.
template <int d>
void begin(Followed<d>& followed) {
  TlsphBody<d>& body = *followed.body;
  followed.support_work.emplace(body.solid, body.supports, body.stepper);
  followed.support_work->resume(followed.support_work_before, followed.support_power_before);
  followed.support_work->observe(body.state);
  if (followed.budget) followed.budget->observe(body.solid, body.state);
}

/// After a step. One that broke a bound is not in the budget, whose last row is the last good state's.
template <int d>
void close_step(Followed<d>& followed, bool sound) {
  followed.support_work->observe(followed.body->state);
  if (sound && followed.budget) followed.budget->observe(followed.body->solid, followed.body->state);
}

template <int d>
SchemeEnergy scheme_energy(const Solid<d>& solid, const State<d>& state) {
  const Energy energy = energy_of(solid, state);
  SchemeEnergy shown{energy.kinetic, energy.strain, {}, {}};
  for (const auto& term : solid.terms)
    if (term.energy) shown.more.push_back({term.name, term.energy(solid, state)});
  return shown;
}

/// Whether loads, damping or supports that change their velocity do work, which the summary does not account
/// for ([output] budget does).
template <int d>
bool has_other_work(const TlsphBody<d>& body) {
  const auto& terms = body.solid.terms;
  return body.actions.has_loads() ||
         std::any_of(terms.begin(), terms.end(), [](const auto& term) { return term.name == "damping"; }) ||
         std::any_of(body.actions.held.begin(), body.actions.held.end(),
                     [](const auto& held) { return !held.steady; });
}

template <int d>
Counts counts_of(const TlsphBody<d>& body) {
  const auto& bonds = body.solid.bonds;
  return {body.solid.cloud.size(), bonds.pairs, bonds.most_neighbours, body.stepper.workspace->work,
          bytes_per_update(body.solid, body.stepper)};
}

/// The deformation gradient in space; F_33 = 1.
template <int d>
Mat<3> gradient_in_space(const Solid<d>& solid, const State<d>& state, Index i) {
  Mat<3> F = Mat<3>::Identity();
  F.template topLeftCorner<d, d>() = deformation_gradient_of(solid, state, i);
  return F;
}

template <int d>
PointView<d> view_of(const Solid<d>& solid, const State<d>& state, const MaterialPoint& point, Index i) {
  const Index slot = solid.bonds.slots.of(i);
  const PointState at = point(gradient_in_space(solid, state, i));
  return {solid.cloud.X[i],
          vector_at<d>(state.u, slot),
          position_of(solid, state, i),
          vector_at<d>(state.v, slot),
          at.F,
          at.cauchy,
          solid.cloud.V[i] * determinant<3, double>(at.F)};
}

template <int d>
void give_reactions(Simulation<d>& simulation, const std::shared_ptr<Followed<d>>& followed) {
  if (followed->body->supports.empty()) return;
  simulation.reactions = [followed] {
    TlsphBody<d>& body = *followed->body;
    std::vector<BoundaryForce<d>> named;
    Workspace<d> workspace;
    const auto open = followed->forces->at(body.solid, workspace, body.state);
    const Vec<d> unknown = Vec<d>::Constant(std::numeric_limits<double>::quiet_NaN());  // no force exists
    const auto forces = open ? followed->forces->reactions(body.solid, body.state, *open)
                             : std::vector<Vec<d>>(body.actions.held.size(), unknown);
    for (std::size_t n = 0; n < forces.size(); ++n) named.push_back({body.actions.held[n].name, forces[n]});
    return named;
  };
}

/// After every step the relaxation has a look.
template <int d>
void look_for_rest(Simulation<d>& simulation, const std::shared_ptr<Followed<d>>& followed) {
  if (!simulation.control.rest) return;
  followed->relaxation.emplace(followed->forces);
  simulation.steps.advance = [followed, step = simulation.steps.advance](double dt) {
    auto failure = step(dt);
    TlsphBody<d>& body = *followed->body;
    if (!failure) followed->residual = followed->relaxation->damp(body.solid, body.state, dt);
    return failure;
  };
  simulation.steps.residual = [followed] { return followed->residual; };
}

}  // namespace

template <int d>
Snapshot<d> snapshot_of(const Solid<d>& solid, const State<d>& state, const MaterialChoice& material) {
  const Index count = solid.cloud.size();
  const MaterialPoint point = make_point(material.law(), material.elastic());
  Snapshot<d> shown;
  shown.time = state.time;
  shown.step = state.step;
  shown.X = solid.cloud.X;
  for (auto* vectors : {&shown.u, &shown.x, &shown.v}) vectors->resize(count);
  for (auto* scalars : {&shown.mass, &shown.volume}) scalars->resize(count);
  for (auto* tensors : {&shown.F, &shown.cauchy}) tensors->resize(count);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < count; ++i) {
    const Index slot = solid.bonds.slots.of(i);
    shown.u[i] = vector_at<d>(state.u, slot);
    shown.x[i] = position_of(solid, state, i);
    shown.v[i] = vector_at<d>(state.v, slot);
    const PointState at = point(gradient_in_space(solid, state, i));
    shown.F[i] = at.F;
    shown.cauchy[i] = at.cauchy;
    shown.mass[i] = solid.elastic.density * solid.cloud.V[i];
    shown.volume[i] = solid.cloud.V[i] * determinant<3, double>(at.F);
  }
  return shown;
}

template <int d>
Simulation<d> as_simulation(const std::shared_ptr<TlsphBody<d>>& body, const MaterialChoice& material) {
  const auto followed = std::make_shared<Followed<d>>();
  followed->body = body;
  if (!body->supports.empty() || body->control.rest)
    followed->forces = std::make_shared<const OpenForces<d>>(body->solid, body->actions);
  const Solid<d>& solid = body->solid;
  Simulation<d> simulation;
  simulation.scheme = "tlsph";
  simulation.control = body->control;
  simulation.warnings = body->warnings;
  for (const auto& term : solid.terms)
    if (term.energy) simulation.energy_names.push_back(term.name);
  simulation.spacing = solid.cloud.spacing;
  simulation.evaluations_per_step = body->stepper.evaluations_per_step;
  simulation.steps = steps_of(body->solid, body->state, body->stepper, body->control, followed->closest);
  simulation.snapshot = [body, material] { return snapshot_of(body->solid, body->state, material); };
  simulation.at = [body, point = make_point(material.law(), material.elastic())](Index i) {
    return view_of(body->solid, body->state, point, i);
  };
  simulation.energy = [body] { return scheme_energy(body->solid, body->state); };
  simulation.energy_round_off = [body] { return energy_round_off(body->solid); };
  simulation.momentum = [body] { return momentum_of(body->solid, body->state); };
  simulation.hourglass_share = [body] { return hourglass_share(body->solid, body->state); };
  simulation.support_work = [followed] {
    return followed->support_work ? followed->support_work->done() : followed->support_work_before;
  };
  simulation.moves_supports = std::any_of(body->supports.begin(), body->supports.end(),
                                          [](const auto& support) { return support.velocity != 0; });
  simulation.has_other_work = has_other_work(*body);
  give_reactions(simulation, followed);
  look_for_rest(simulation, followed);
  simulation.counts = [body] { return counts_of(*body); };
  simulation.arrays = [body] { return arrays_of(*body); };
  simulation.save = [followed] { return save(*followed); };
  simulation.restore = [followed](const SavedState& saved) { restore(*followed, saved); };
  simulation.begin = [followed] { begin(*followed); };
  simulation.close_step = [followed](bool sound) { close_step(*followed, sound); };
  simulation.keep_budget = [followed](const std::filesystem::path& file) {
    TlsphBody<d>& of = *followed->body;
    followed->budget.emplace(file, of.solid, of.state, of.stepper.weights);
  };
  return simulation;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                \
  template Snapshot<d> snapshot_of<d>(const Solid<d>&, const State<d>&, const MaterialChoice&); \
  template Simulation<d> as_simulation<d>(const std::shared_ptr<TlsphBody<d>>&, const MaterialChoice&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
