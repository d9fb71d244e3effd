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

template <int d>
Explanation explanation(const Scene& scene, const std::string& shows, TlsphBody<d>& simulation) {
  const Index particles = simulation.solid.cloud.size();
  const auto count = static_cast<double>(particles);
  const Parts parts = parts_of(scene, simulation);
  Explanation made{};
  made.scene = scene.name;
  made.shows = shows;
  made.dimension = d;
  made.scheme = scene.method.scheme;
  made.particles = particles;
  made.neighbours = {static_cast<double>(simulation.solid.bonds.pairs) / count,
                     simulation.solid.bonds.most_neighbours};
  made.solves = account_of(scene, simulation);
  made.built = parts.built;
  made.left_out = parts.left_out;
  made.arrays = arrays_of(simulation);
  const std::size_t bytes = total_bytes(made.arrays);
  made.dt = time_step(simulation.solid, simulation.state, simulation.control);
  made.dt_reason = step_reason(scene, simulation, made.dt);
  made.steps = steps_to_end(simulation.control, made.dt);
  made.evaluations_per_step = simulation.integrator.evaluations_per_step;
  if (const auto seconds = seconds_per_step(simulation, made.dt, made.steps))
    made.estimated_wall_s = *seconds * static_cast<double>(made.steps);
  made.memory = {bytes, static_cast<double>(bytes) / count, peak_resident_bytes()};
  made.costs = measure_costs(scene);
  made.warnings = simulation.warnings;
  for (const auto& limit : limits_of(scene)) made.warnings.push_back(limit);
  return made;
}

/// The same of a scheme with a body of its own, by what the scheme says of itself.
template <int d>
Explanation explanation(const Scene& scene, const std::string& shows, Simulation<d>& simulation) {
  const Counts counts = simulation.counts();
  const auto count = static_cast<double>(counts.particles);
  Explanation made{};
  made.scene = scene.name;
  made.shows = shows;
  made.dimension = d;
  made.scheme = simulation.scheme;
  made.particles = counts.particles;
  made.neighbours = {static_cast<double>(counts.pairs) / count, counts.most_neighbours};
  made.solves = simulation.account();
  made.built = {"scheme " + simulation.scheme};
  made.arrays = simulation.arrays();
  const std::size_t bytes = total_bytes(made.arrays);
  made.dt = simulation.steps.allowed();
  made.dt_reason = {"time step",
                    simulation.control.fixed_step ? "fixed by the scene" : "what the scheme allows", ""};
  made.steps = steps_to_end(simulation.control, made.dt);
  made.evaluations_per_step = simulation.evaluations_per_step;
  const auto start = std::chrono::steady_clock::now();
  const bool sound = !simulation.steps.advance(made.dt);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (sound) made.estimated_wall_s = seconds.count() * static_cast<double>(made.steps);
  made.memory = {bytes, static_cast<double>(bytes) / count, peak_resident_bytes()};
  made.costs.particles = counts.particles;
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
