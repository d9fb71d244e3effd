#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lib/material/point.hpp"
#include "lib/scene/followed.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/traffic.hpp"

namespace plumb {
namespace {

/// What happens before the first step: the work of actions is read behind the budget.
template <int d>
void begin(Followed<d>& followed) {
  TlsphBody<d>& body = *followed.body;
  followed.work.emplace(body.solid, body.actions, body.integrator, body.state);
  if (followed.goes_on && !followed.work->restore(followed.work_before))
    throw InputError("the checkpoint has no work of loads and supports, or of others", "",
                     "start the run anew, without --resume");
  if (followed.budget) followed.budget->observe(body.solid, body.state);
}

/// After a step. One that broke a bound is not in the budget, whose last row is the last good state's.
template <int d>
void close_step(Followed<d>& followed, bool sound) {
  followed.work->close_step(followed.body->solid, followed.body->state);
  if (sound && followed.budget) followed.budget->observe(followed.body->solid, followed.body->state);
}

/// The deformation gradient in space; F_33 = 1.
template <int d>
Mat<3> gradient_in_space(const Solid<d>& solid, const State<d>& state, Index i) {
  Mat<3> F = Mat<3>::Identity();
  F.template topLeftCorner<d, d>() = deformation_gradient_of(solid, state, i);
  return F;
}

/// What a particle shows of its material: that of its elastic law, or of its history.
template <int d>
PointState point_state(const Solid<d>& solid, const State<d>& state, const MaterialPoint& point, Index i) {
  const Mat<3> F = gradient_in_space(solid, state, i);
  if (!solid.sweeps.history) return point(F);
  PointState shown;
  shown.F = F;
  shown.cauchy =
      solid.sweeps.history->first_piola(F, solid.bonds.slots.of(i)) * F.transpose() / F.determinant();
  return shown;
}

template <int d>
Counts counts_of(const TlsphBody<d>& body) {
  const auto& bonds = body.solid.bonds;
  return {body.solid.cloud.size(), bonds.pairs, bonds.most_neighbours, body.integrator.workspace->work,
          bytes_per_update(body.solid, body.integrator)};
}

template <int d>
PointView<d> view_of(const Solid<d>& solid, const State<d>& state, const MaterialPoint& point, Index i) {
  const Index slot = solid.bonds.slots.of(i);
  const PointState at = point_state(solid, state, point, i);
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
    const PointState at = point_state(solid, state, point, i);
    shown.F[i] = at.F;
    shown.cauchy[i] = at.cauchy;
    shown.mass[i] = solid.elastic.density * solid.cloud.V[i];
    shown.volume[i] = solid.cloud.V[i] * determinant<3, double>(at.F);
  }
  if (const auto& history = solid.sweeps.history)
    for (const HistoryValue& value : history->values)
      if (!value.tensor)
        shown.more.push_back(
            {value.name, value.unit, gathered(value.name, solid, history->field, value.first, 1).values});
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
  if (solid.sweeps.history) simulation.energy_names.push_back(solid.sweeps.history->plastic_work().name);
  simulation.spacing = solid.cloud.spacing;
  simulation.evaluations_per_step = body->integrator.evaluations_per_step;
  simulation.steps = steps_of(body->solid, body->state, body->integrator, body->control, followed->closest);
  simulation.snapshot = [body, material] { return snapshot_of(body->solid, body->state, material); };
  simulation.at = [body, point = make_point(material.law(), material.elastic())](Index i) {
    return view_of(body->solid, body->state, point, i);
  };
  simulation.energy = [body] { return energy_of(body->solid, body->state); };
  simulation.energy_round_off = [body] { return energy_round_off(body->solid); };
  simulation.momentum = [body] { return momentum_of(body->solid, body->state); };
  simulation.hourglass_share = [body] { return hourglass_share(body->solid, body->state); };
  simulation.external_work = [followed] {
    std::vector<NamedEnergy> works;
    if (followed->work)
      for (const auto& [action, done] : followed->work->done()) works.push_back({action, done});
    return works;
  };
  simulation.has_other_work = body->control.rest.has_value();
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
    followed->budget.emplace(file, of.solid, of.state, of.integrator.weights);
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
