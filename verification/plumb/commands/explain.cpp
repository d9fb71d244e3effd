#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/output/listed.hpp"
#include "lib/output/terminal.hpp"
#include "lib/scene/limits.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/simulation.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/data_folder.hpp"
#include "verification/plumb/explain/account.hpp"
#include "verification/plumb/explain/cost.hpp"
#include "verification/plumb/explain/setup.hpp"
#include "verification/plumb/explain/tell.hpp"
#include "verification/plumb/run/inventory.hpp"
#include "verification/plumb/run/scene_options.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

/// Wall time of one step [s], measured on this machine: the mean over at least 0.1 s or `most` steps, after
/// one step that warms up. Advances the simulation, which is thrown away. Null if it fails at once.
template <int d>
std::optional<double> seconds_per_step(TlsphBody<d>& simulation, double dt, long most) {
  using Clock = std::chrono::steady_clock;
  if (!simulation.integrator.step(simulation.solid, simulation.state, dt)) return std::nullopt;
  const auto start = Clock::now();
  for (long steps = 1;; ++steps) {
    if (!simulation.integrator.step(simulation.solid, simulation.state, dt)) return std::nullopt;
    time_step(simulation.solid, simulation.state, simulation.control);  // a part of every step of a run
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (elapsed > 0.1 || steps >= most) return elapsed / static_cast<double>(steps);
  }
}

/// Steps to the end with a constant step; the run may differ if the body deforms.
long steps_to_end(const StepControl& control, double dt) {
  const auto steps_in = [dt](double time) { return std::ceil(time / dt * (1 - 1e-12)); };
  double by_time = 1e18;
  if (control.end_time) {  // every interval is filled with steps of its own
    const double end = *control.end_time, interval = control.interval.value_or(end);
    const double whole = std::floor(end / interval * (1 + 1e-12)), rest = end - whole * interval;
    by_time = whole * steps_in(interval) + (rest > 1e-12 * end ? steps_in(rest) : 0);
  }
  const double by_count = control.max_steps ? static_cast<double>(*control.max_steps) : 1e18;
  return static_cast<long>(std::min(by_time, by_count));
}

/// Unknowns up to which one step of Newton's method takes some seconds.
constexpr Index most_tried = 30000;

/// What a run steps through, by its first step: length, number, evaluations and the time that they will take.
void tell_steps(const Scene& scene, double dt, const StepControl& control, std::optional<int> evaluations,
                Explanation& made) {
  made.dt = dt;
  made.steps = steps_to_end(control, dt);
  made.evaluations_per_step = evaluations;
  if (solved_by_newton(scene.method)) made.dt_reason = {"time step", "as [implicit] asks for", ""};
}

void tell_time(std::optional<double> seconds_per_step, Explanation& made) {
  if (seconds_per_step)
    made.estimated_wall_s = *seconds_per_step * static_cast<double>(made.steps);
  else
    made.why_no_estimate = "the first steps fail: the run would end unstable at once";
}

/// Tries the first step of a scheme, which is thrown away: one of Newton's method only where that is soon done.
template <int d>
void try_a_step(const Scene& scene, Simulation<d>& simulation, Explanation& made) {
  const bool newton = solved_by_newton(scene.method);
  tell_steps(scene, simulation.steps.allowed(), simulation.control,
             newton ? std::nullopt : std::optional(simulation.evaluations_per_step), made);
  if (const Index unknowns = d * made.particles; newton && unknowns > most_tried) {
    made.why_no_estimate = fmt::format("no step was tried: {} unknowns", unknowns);
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool sound = !simulation.steps.advance(made.dt);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  tell_time(sound ? std::optional(seconds.count()) : std::nullopt, made);
}

/// What is said alike of every scheme.
template <int d>
Explanation begun(const Scene& scene, const std::string& shows, const Counts& counts,
                  std::vector<ArrayEntry> arrays) {
  const auto count = static_cast<double>(counts.particles);
  Explanation made{};
  made.scene = scene.name;
  made.shows = shows;
  made.dimension = d;
  made.scheme = scene.method.scheme;
  made.particles = counts.particles;
  made.neighbours = {static_cast<double>(counts.pairs) / count, counts.most_neighbours};
  const std::size_t bytes = total_bytes(arrays);
  made.arrays = std::move(arrays);
  made.memory = {bytes, static_cast<double>(bytes) / count, peak_resident_bytes()};
  return made;
}

template <int d>
Explanation explanation(const Scene& scene, const std::string& shows, TlsphBody<d>& simulation) {
  const BondTable<d>& bonds = simulation.solid.bonds;
  const Parts parts = parts_of(scene, simulation);
  Explanation made =
      begun<d>(scene, shows, {simulation.solid.cloud.size(), bonds.pairs, bonds.most_neighbours, {}},
               arrays_of(simulation));
  made.solves = account_of(scene, simulation);
  made.built = parts.built;
  made.left_out = parts.left_out;
  if (solved_by_newton(scene.method)) {
    auto implicit = make_simulation<d>(scene).simulation;
    try_a_step(scene, implicit, made);
    made.costs.particles = made.particles;  // what parts cost was measured of explicit steps only
  } else {
    const double dt = time_step(simulation.solid, simulation.state, simulation.control);
    tell_steps(scene, dt, simulation.control, simulation.integrator.evaluations_per_step, made);
    made.dt_reason = step_reason(scene, simulation, dt);
    tell_time(seconds_per_step(simulation, dt, made.steps), made);
    made.costs = measure_costs(scene);
  }
  made.memory.peak_rss = peak_resident_bytes();
  made.warnings = simulation.warnings;
  for (const auto& limit : limits_of(scene)) made.warnings.push_back(limit);
  return made;
}

/// The same of a scheme with a body of its own, by what the scheme says of itself.
template <int d>
Explanation explanation(const Scene& scene, const std::string& shows, Simulation<d>& simulation) {
  Explanation made = begun<d>(scene, shows, simulation.counts(), simulation.arrays());
  made.solves = simulation.account();
  made.built = {"scheme " + simulation.scheme};
  made.dt_reason = {"time step",
                    simulation.control.fixed_step ? "fixed by the scene" : "what the scheme allows", ""};
  try_a_step(scene, simulation, made);
  made.memory.peak_rss = peak_resident_bytes();
  made.costs.particles = made.particles;
  made.warnings = simulation.warnings;
  return made;
}

template <int d>
int explain_scheme(const Session& session, const Scene& scene, const std::string& shows) {
  Simulation<d> simulation = make_scheme_simulation<d>(scene);
  const Explanation made = explanation(scene, shows, simulation);
  tell(session.text(), made);
  session.write_json(to_json(made));
  return 0;
}

template <int d>
int explain(const Session& session, const Scene& scene, const std::string& shows) {
  if (has_own_body(scene.method.scheme)) return explain_scheme<d>(session, scene, shows);
  std::optional<ProjectionCost> projection;
  if (scene.method.gradient == "compatible")
    projection = projection_cost<d>(scene, make_cloud<d>(scene.body));
  session.text() << text_of(projection) << std::flush;  // before it is spent
  TlsphBody<d> simulation = make_tlsph<d>(scene);
  const Explanation made = explanation(scene, shows, simulation);
  tell(session.text(), made);
  if (simulation.compatible)
    session.text() << wrapped(compatible_text(simulation.compatible.get()),
                              static_cast<std::size_t>(terminal_columns(1)), 0, 2)
                   << '\n';
  auto json = to_json(made);
  if (simulation.compatible) json["compatible"] = compatible_json(simulation.compatible.get());
  if (projection) json["compatible"]["expected_cpu_s"] = projection->cpu_s;
  session.write_json(json);
  return 0;
}

}  // namespace

/// `plumb explain SCENE.toml`: reads and builds a scene as `run` does, and says what it would do.
void add_explain(CLI::App& program, Session& session) {
  const auto options = std::make_shared<SceneOptions>();
  const auto action = [&session, options] {
    const Scene scene = scene_of(*options);
    const std::string shows = what_it_shows(options->file);
    return with_dimension(scene, [&]<int d>() { return explain<d>(session, scene, shows); });
  };
  CLI::App& command = add_command(program, session,
                                  {"explain", "what a scene solves, costs and leaves out, without running it",
                                   "plumb explain verification/scenes/bending-column.toml"},
                                  {}, action);
  add_scene_options(command, *options);
}

}  // namespace plumb::app
