#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/core/error.hpp"
#include "lib/core/field.hpp"
#include "lib/geometry/moving_neighbours.hpp"
#include "lib/run/outside_of_scheme.hpp"
#include "lib/run/simulation.hpp"

/// Makes a Simulation of any scheme, once per run.
namespace plumb {

/// Looks at each field of a state that a restart needs.
template <class State, class Use>
void for_each_kept_field(State& state, Use&& use) {
  state.fields([&](const FieldInfo& info, auto& field) {
    if (info.role != Role::cache) use(info, field);
  });
}

/// Copies the fields that a restart needs, in the order of the particles: `places` says where each one is.
template <class State>
std::vector<SavedField> saved_fields(State& state, const std::vector<Index>& places) {
  const auto particles = static_cast<Index>(places.size());
  std::vector<SavedField> saved;
  for_each_kept_field(state, [&](const FieldInfo& info, const Field& field) {
    const int components = field.components();
    SavedField out{std::string(info.name), components, std::vector<double>(particles * components),
                   std::string(info.unit)};
    for (Index i = 0; i < particles; ++i)
      for (int k = 0; k < components; ++k) out.values[i * components + k] = field[k][places[i]];
    saved.push_back(std::move(out));
  });
  return saved;
}

/// InputError if a field is missing or has another size.
template <class State>
void restore_fields(State& state, const std::vector<Index>& places, const std::vector<SavedField>& saved) {
  const auto particles = static_cast<Index>(places.size());
  for_each_kept_field(state, [&](const FieldInfo& info, Field& field) {
    const SavedField* from = field_named(saved, std::string(info.name));
    const int components = field.components();
    if (!from || from->values.size() != static_cast<std::size_t>(particles * components))
      throw InputError(
          fmt::format("the checkpoint does not fit: field \"{}\"", info.name),
          from ? fmt::format("it has {} numbers, the scene {}", from->values.size(), particles * components)
               : std::string("it is missing"),
          "start the run anew, without --resume");
    for (Index i = 0; i < particles; ++i)
      for (int k = 0; k < components; ++k) field[k][places[i]] = from->values[i * components + k];
  });
}

/// Adds what a state keeps of pairs and of the whole body, as fields of one record each.
template <class State>
void save_more(State& state, std::vector<SavedField>& saved) {
  const auto add = [&](std::string_view name, KeptFor of, std::vector<double> values) {
    if (!values.empty())
      saved.push_back({std::string(name), static_cast<int>(values.size()), std::move(values), {}, of});
  };
  if constexpr (requires { state.pair_fields([](std::string_view, PairHistory&) {}); })
    state.pair_fields(
        [&](std::string_view name, PairHistory& pairs) { add(name, KeptFor::pairs, pairs.triples()); });
  if constexpr (requires { state.whole_fields([](std::string_view, double&) {}); })
    state.whole_fields([&](std::string_view name, double& value) { add(name, KeptFor::body, {value}); });
}

/// InputError if a number of the whole body is missing. A history that is missing is empty.
template <class State>
void restore_more(State& state, Index particles, const std::vector<SavedField>& saved) {
  if constexpr (requires { state.pair_fields([](std::string_view, PairHistory&) {}); })
    state.pair_fields([&](std::string_view name, PairHistory& pairs) {
      const SavedField* from = field_named(saved, name);
      pairs = history_of(from ? from->values : std::vector<double>(), particles);
    });
  if constexpr (requires { state.whole_fields([](std::string_view, double&) {}); })
    state.whole_fields([&](std::string_view name, double& value) {
      const SavedField* from = field_named(saved, name);
      if (!from || from->values.size() != 1)
        throw InputError(fmt::format("the checkpoint does not fit: \"{}\"", name), "it is missing",
                         "start the run anew, without --resume");
      value = from->values[0];
    });
}

/// Adds what a scheme keeps at places that are no particles, as fields of one record each.
template <class M>
void save_points(M& scheme, std::vector<SavedField>& saved) {
  if constexpr (requires { scheme.fields_at_points([](const FieldInfo&, Field&, Index) {}); })
    scheme.fields_at_points([&](const FieldInfo& info, const Field& field, Index places) {
      SavedField out{std::string(info.name),
                     static_cast<int>(field.components() * places),
                     {},
                     std::string(info.unit),
                     KeptFor::points};
      for (int k = 0; k < field.components(); ++k)
        out.values.insert(out.values.end(), field[k], field[k] + places);
      saved.push_back(std::move(out));
    });
}

/// InputError if a field is missing or has another size.
template <class M>
void restore_points(M& scheme, const std::vector<SavedField>& saved) {
  if constexpr (requires { scheme.fields_at_points([](const FieldInfo&, Field&, Index) {}); })
    scheme.fields_at_points([&](const FieldInfo& info, Field& field, Index places) {
      const SavedField* from = field_named(saved, info.name);
      const auto size = static_cast<std::size_t>(field.components() * places);
      if (!from || from->values.size() != size)
        throw InputError(fmt::format("the checkpoint does not fit: field \"{}\"", info.name),
                         from ? fmt::format("it has {} numbers, the scene {}", from->values.size(), size)
                              : std::string("it is missing"),
                         "start the run anew, without --resume");
      for (int k = 0; k < field.components(); ++k)
        std::copy_n(from->values.data() + k * places, places, field[k]);
    });
}

/// The scheme and its state, which live as long as the functions of the simulation.
template <class M>
struct Moving {
  M scheme;
  typename M::State state;
  std::vector<Index> places;  ///< of the particles in the fields of the state
};

/// Where each particle stands in the fields of a state.
template <class M>
std::vector<Index> places_of(const M& scheme, std::size_t particles) {
  std::vector<Index> places(particles);
  for (std::size_t i = 0; i < particles; ++i)
    if constexpr (requires { scheme.layout(); })
      places[i] = scheme.layout().of(static_cast<Index>(i));
    else
      places[i] = static_cast<Index>(i);
  return places;
}

/// What there is to count, as far as the scheme tells.
template <class M>
Counts counts_of(const Moving<M>& moving) {
  Counts counts;
  counts.particles = static_cast<Index>(moving.places.size());
  if constexpr (requires { moving.scheme.neighbours(); }) {
    const NeighbourCounts neighbours = moving.scheme.neighbours();
    counts.pairs = neighbours.pairs;
    counts.most_neighbours = neighbours.most;
  }
  if constexpr (requires { M::evaluations_per_step; }) {
    const std::int64_t evaluations = M::evaluations_per_step * static_cast<std::int64_t>(moving.state.step);
    counts.work = {evaluations * counts.particles, evaluations * counts.pairs};
  }
  return counts;
}

/// Whether the energy has grown beyond the bound of the control.
template <class M>
std::optional<Failure> beyond_energy_bound(Moving<M>& moving, const StepControl& control,
                                           const RunRecord& record) {
  if (!control.energy_bound) return std::nullopt;
  const double energy = moving.scheme.energy(moving.state).total();
  if (energy <= (1 + *control.energy_bound) * record.initial_energy.value_or(energy)) return std::nullopt;
  return Failure{moving.state.time, moving.state.step, Cause::energy_growth, std::nullopt, energy,
                 "total energy"};
}

/// Says as a failure of a run what a scheme met in a step.
inline Failure failure_of(const Trouble& trouble, double time, long step) {
  const Cause cause = trouble.quantity == "residual" ? Cause::no_convergence
                      : std::isfinite(trouble.value) ? Cause::inverted
                                                     : Cause::non_finite;
  return {time, step, cause, trouble.particle, trouble.value, trouble.quantity};
}

/// Makes what the loop over time steps asks of a body out of a scheme and its state.
template <class M, int d>
Steps steps_of(const std::shared_ptr<Moving<M>>& moving, const StepControl& control) {
  return {
      [moving] {
        return Moment{moving->state.time, moving->state.step};
      },
      [moving](double time) { moving->state.time = time; },
      [moving, fixed = control.fixed_step] {
        return fixed ? *fixed : moving->scheme.step_limit(moving->state);
      },
      [moving](double dt) -> std::optional<Failure> {
        const auto trouble = moving->scheme.advance(moving->state, dt);
        if (!trouble) return std::nullopt;
        return failure_of(*trouble, moving->state.time, moving->state.step);
      },
      [moving, control](const RunRecord& record) { return beyond_energy_bound(*moving, control, record); }};
}

/// The particle of that number in the snapshot.
template <int d>
PointView<d> view_of(const Snapshot<d>& shown, Index i) {
  PointView<d> view{shown.X[i], shown.u[i], shown.x[i], shown.v[i]};
  view.volume = shown.volume[i];
  if (!shown.F.empty()) view.F = shown.F[i];
  if (!shown.cauchy.empty()) view.cauchy = shown.cauchy[i];
  return view;
}

/// The step that the control allows is the scheme's own limit, unless the scene fixes it.
template <int d, class M>
requires Scheme<M, d> Simulation<d> as_simulation(const std::shared_ptr<Moving<M>>& moving,
                                                  const StepControl& control) {
  moving->places = places_of(moving->scheme, moving->scheme.snapshot(moving->state).X.size());
  Simulation<d> simulation;
  simulation.scheme = std::string(M::name);
  simulation.control = control;
  for (const auto& energy : moving->scheme.energy(moving->state).more)
    simulation.energy_names.push_back(energy.name);
  simulation.steps = steps_of<M, d>(moving, control);
  simulation.snapshot = [moving] { return moving->scheme.snapshot(moving->state); };
  simulation.at = [moving](Index i) { return view_of(moving->scheme.snapshot(moving->state), i); };
  simulation.energy = [moving] { return moving->scheme.energy(moving->state); };
  simulation.momentum = [moving] { return momentum_of(moving->scheme.snapshot(moving->state)); };
  if constexpr (requires { moving->scheme.outside(); }) give_outside<d>(simulation, moving);
  if constexpr (requires { M::evaluations_per_step; })
    simulation.evaluations_per_step = M::evaluations_per_step;
  if constexpr (requires { moving->scheme.warnings(); }) simulation.warnings = moving->scheme.warnings();
  simulation.account = [moving] { return moving->scheme.account(); };
  simulation.counts = [moving] { return counts_of(*moving); };
  simulation.arrays = [moving] {
    std::vector<ArrayEntry> arrays;
    moving->state.fields([&](const FieldInfo& info, const Field& field) {
      arrays.push_back({std::string(info.name), field.bytes()});
    });
    if constexpr (requires { moving->scheme.fields_at_points([](const FieldInfo&, Field&, Index) {}); })
      moving->scheme.fields_at_points([&](const FieldInfo& info, const Field& field, Index) {
        arrays.push_back({std::string(info.name), field.bytes()});
      });
    if constexpr (requires { moving->state.pair_fields([](std::string_view, PairHistory&) {}); })
      moving->state.pair_fields([&](std::string_view name, PairHistory& pairs) {
        arrays.push_back({std::string(name), pairs.bytes()});
      });
    return arrays;
  };
  simulation.save = [moving] {
    SavedState saved{{moving->state.time, moving->state.step},
                     counts_of(*moving).work,
                     saved_fields(moving->state, moving->places)};
    save_more(moving->state, saved.fields);
    save_points(moving->scheme, saved.fields);
    return saved;
  };
  simulation.restore = [moving](const SavedState& saved) {
    restore_fields(moving->state, moving->places, saved.fields);
    restore_more(moving->state, static_cast<Index>(moving->places.size()), saved.fields);
    restore_points(moving->scheme, saved.fields);
    moving->state.time = saved.now.time;
    moving->state.step = saved.now.step;
  };
  return simulation;
}

/// Makes a Simulation of a scheme that starts with that motion.
template <int d, class M>
requires Scheme<M, d> Simulation<d> as_simulation(M scheme, const InitialMotion<d>& initial,
                                                  const StepControl& control) {
  auto state = scheme.start(initial);
  return as_simulation<d>(std::make_shared<Moving<M>>(Moving<M>{std::move(scheme), std::move(state), {}}),
                          control);
}

}  // namespace plumb
