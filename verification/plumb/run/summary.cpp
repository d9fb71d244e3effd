#include "plumb/run/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "plumb/run/inventory.hpp"
#include "plumb/run/likely_cause.hpp"
#include "plumbline/output/progress.hpp"
#include "plumbline/output/terminal.hpp"
#include "plumbline/solid/traffic.hpp"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

template <int d>
Json list(const Vec<d>& v) {
  return std::vector<double>(v.data(), v.data() + d);
}

const char* status_of(const RunResult& result) {
  if (result.failure) return "unstable";
  return result.stopped ? "interrupted" : "completed";
}

/// |now - before| relative to the first scale that is not zero; 0 where there is no motion at all.
double drift(const std::array<double, 3>& now, const std::array<double, 3>& before, double scale,
             double other_scale) {
  const double distance = std::hypot(now[0] - before[0], now[1] - before[1], now[2] - before[2]);
  return distance == 0 ? 0 : distance / (scale > 0 ? scale : other_scale);
}

struct Drifts {
  double linear, angular;
};

Drifts drifts(const Momentum& now, const Momentum& before) {
  return {drift(now.linear, before.linear, before.linear_scale, now.linear_scale),
          drift(now.angular, before.angular, before.angular_scale, now.angular_scale)};
}

template <int d>
Json probes_json(const FinishedRun<d>& run) {
  Json probes = Json::object();
  for (const auto& probe : run.probes) {
    const Index slot = run.simulation.solid.bonds.slots.of(probe.particle);
    probes[probe.name] = {
        {"position", list<d>(position_of(run.simulation.solid, run.simulation.state, probe.particle))},
        {"displacement", list<d>(vector_at<d>(run.simulation.state.u, slot))},
        {"velocity", list<d>(vector_at<d>(run.simulation.state.v, slot))},
        {"particle", probe.particle}};
  }
  return probes;
}

Json failure_json(const std::optional<Failure>& failure) {
  if (!failure) return nullptr;
  return {{"time", failure->time},
          {"step", failure->step},
          {"cause", name_of(failure->cause)},
          {"particle", failure->particle < 0 ? Json() : Json(failure->particle)},
          {"quantity", failure->quantity},
          {"value", failure->value}};
}

Json energy_json(const Energy& now, const Energy& before) {
  Json energy{
      {"kinetic", now.kinetic}, {"strain", now.strain}, {"total", now.total()}, {"initial", before.total()}};
  // A body at rest has no energy to compare with.
  energy["relative_change"] = before.total() > 0 ? Json(now.total() / before.total() - 1) : Json();
  return energy;
}

template <int d>
Json momentum_json(const FinishedRun<d>& run) {
  const Momentum now = momentum_of(run.simulation.solid, run.simulation.state);
  const Drifts drift = drifts(now, run.book.initial_momentum);
  return {{"linear_momentum", std::vector<double>(now.linear.begin(), now.linear.begin() + d)},
          {"angular_momentum", now.angular},
          {"linear_drift", drift.linear},
          {"angular_drift", drift.angular}};
}

}  // namespace

template <int d>
Json summary(const FinishedRun<d>& run) {
  const auto& bonds = run.simulation.solid.bonds;
  const Index particles = run.simulation.solid.cloud.size();
  const Extent<d> extent = extent_of(run.simulation.solid, run.simulation.state);
  const Work& work = run.simulation.solid.work;
  const auto& dt = run.result.dt;
  Json json{{"scene", run.scene.name},
            {"dimension", d},
            {"particles", particles},
            {"neighbours",
             {{"mean", static_cast<double>(bonds.pairs) / static_cast<double>(particles)},
              {"max", bonds.most_neighbours}}},
            {"status", status_of(run.result)},
            {"steps", run.simulation.state.step},
            {"time", run.simulation.state.time},
            {"dt", {{"first", dt.first}, {"min", dt.least}, {"max", dt.most}, {"last", dt.last}}},
            {"energy",
             energy_json(energy_of(run.simulation.solid, run.simulation.state), run.book.initial_energy)}};
  json.update(momentum_json(run));
  json["extent"] = {{"min", list<d>(extent.lower)}, {"max", list<d>(extent.upper)}};
  json["hourglass_share"] = hourglass_share(run.simulation.solid, run.simulation.state);
  json["probes"] = probes_json(run);
  json["failure"] = failure_json(run.result.failure);
  if (run.result.failure)
    json["failure"]["likely_cause"] = likely_cause<d>(run.scene, run.simulation, run.result.dt.first);
  json["timing"] = {
      {"setup_s", run.book.timing.setup},
      {"wall_s", run.book.timing.wall},
      {"cpu_s", run.book.timing.cpu},
      {"particle_evaluations_per_s", static_cast<double>(work.particle_evaluations) / run.book.timing.wall}};
  json["work"] = {{"particle_evaluations", work.particle_evaluations},
                  {"pair_evaluations", work.pair_evaluations},
                  {"bytes", std::llround(static_cast<double>(work.particle_evaluations) *
                                         bytes_per_update(run.simulation.solid, run.simulation.stepper))}};
  const auto bytes = static_cast<double>(total_bytes(arrays_of(run.simulation)));
  json["memory"] = {{"bytes_per_particle", bytes / static_cast<double>(particles)},
                    {"peak_rss", peak_resident_bytes()}};
  if (run.simulation.compatible) json["compatible"] = compatible_json(run.simulation.compatible.get());
  const Parts parts = parts_of(run.scene, run.simulation);
  json["built"] = parts.built;
  json["left_out"] = parts.left_out;
  return json;
}

template <int d>
std::string summary_text(const FinishedRun<d>& run) {
  const Energy energy = energy_of(run.simulation.solid, run.simulation.state);
  const Drifts drift =
      drifts(momentum_of(run.simulation.solid, run.simulation.state), run.book.initial_momentum);
  const Extent<d> extent = extent_of(run.simulation.solid, run.simulation.state);
  const char* unit = d == 2 ? "J/m" : "J";
  std::string text = fmt::format("{}: {} at {:.6g} s, {} steps, {} particles, {} + {} set-up\n",
                                 run.scene.name, status_of(run.result), run.simulation.state.time,
                                 run.simulation.state.step, run.simulation.solid.cloud.size(),
                                 duration_text(run.book.timing.wall), duration_text(run.book.timing.setup));
  if (const auto& failure = run.result.failure) {
    text += fmt::format("  {}: {} = {:.6g}", name_of(failure->cause), failure->quantity, failure->value);
    if (failure->particle >= 0) text += fmt::format(" at particle {}", failure->particle);
    text += fmt::format(", step {}, t = {:.9g} s\n", failure->step, failure->time);
    const std::string cause = likely_cause<d>(run.scene, run.simulation, run.result.dt.first);
    if (!cause.empty())
      text +=
          "  likely cause: " + wrapped(cause, static_cast<std::size_t>(terminal_columns(1)), 16, 2) + "\n";
  }
  text += fmt::format("  energy {:.9g} {} (kinetic {:.6g}, strain {:.6g}; at the start {:.9g})\n",
                      energy.total(), unit, energy.kinetic, energy.strain, run.book.initial_energy.total());
  text += fmt::format(
      "  drift of linear momentum {:.3g}, of angular momentum {:.3g}, relative to the initial scale{}\n",
      drift.linear, drift.angular, run.scene.boundaries.empty() ? "" : " (the supports push the body)");
  for (int k = 0; k < d; ++k)
    text += fmt::format("  {} from {:.6g} to {:.6g} m\n", "xyz"[k], extent.lower[k], extent.upper[k]);
  if (run.simulation.compatible) text += "  " + compatible_text(run.simulation.compatible.get());
  return text;
}

template Json summary<2>(const FinishedRun<2>&);
template Json summary<3>(const FinishedRun<3>&);
template std::string summary_text<2>(const FinishedRun<2>&);
template std::string summary_text<3>(const FinishedRun<3>&);

}  // namespace plumb
