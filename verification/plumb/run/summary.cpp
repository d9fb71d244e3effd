#include "verification/plumb/run/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/output/progress.hpp"
#include "verification/plumb/run/inventory.hpp"
#include "verification/plumb/run/likely_cause.hpp"
#include "verification/plumb/run/summary_parts.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

template <int d>
Json list(const Vec<d>& v) {
  return std::vector<double>(v.data(), v.data() + d);
}

Json rows_of(const Mat<3>& tensor) {
  Json rows = Json::array();
  for (int a = 0; a < 3; ++a) rows.push_back({tensor(a, 0), tensor(a, 1), tensor(a, 2)});
  return rows;
}

/// |now - before| relative to the first scale that is not zero; 0 where there is no motion at all.
double drift(const std::array<double, 3>& now, const std::array<double, 3>& before, double scale,
             double other_scale) {
  const double distance = std::hypot(now[0] - before[0], now[1] - before[1], now[2] - before[2]);
  return distance == 0 ? 0 : distance / (scale > 0 ? scale : other_scale);
}

template <int d>
Json probes_json(const FinishedRun<d>& run) {
  Json probes = Json::object();
  for (const auto& probe : run.probes) {
    const PointView<d> at = run.simulation.at(probe.particle);
    probes[probe.name] = {{"position", list<d>(at.x)},  {"displacement", list<d>(at.u)},
                          {"velocity", list<d>(at.v)},  {"particle", probe.particle},
                          {"reference", list<d>(at.X)}, {"distance", probe.distance}};
    probes[probe.name]["F"] = at.F ? rows_of(*at.F) : Json();
    probes[probe.name]["stress"] = at.cauchy ? rows_of(*at.cauchy) : Json();
  }
  return probes;
}

/// What the displacements are off by, as nodal norms.
template <int d>
Json error_json(const FinishedRun<d>& run) {
  const Snapshot<d> shown = run.simulation.snapshot();
  const double time = run.simulation.steps.now().time;
  double error = 0, size = 0;
  for (std::size_t i = 0; i < shown.X.size(); ++i) {
    std::array<double, 3> X{};
    std::copy_n(shown.X[i].data(), d, X.begin());
    for (int k = 0; k < d; ++k) {
      const double exact = run.scene.exact[static_cast<std::size_t>(k)].at(X, time);
      error += (shown.u[i][k] - exact) * (shown.u[i][k] - exact);
      size += exact * exact;
    }
  }
  return {{"displacement", size > 0 ? Json(std::sqrt(error / size)) : Json()},
          {"displacement_m", std::sqrt(error / static_cast<double>(shown.X.size()))}};
}

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json failure_json(const std::optional<Failure>& failure) {
  if (!failure) return nullptr;
  return {{"time", failure->time},
          {"step", failure->step},
          {"cause", name_of(failure->cause)},
          {"particle", failure->particle ? Json(*failure->particle) : Json()},
          {"quantity", failure->quantity},
          {"value", number_or_null(failure->value)}};
}

template <int d>
Json energy_json(const FinishedRun<d>& run) {
  const EnergyBudget energy = energy_budget(run);
  const auto& simulation = run.simulation;
  const double round_off = simulation.energy_round_off ? simulation.energy_round_off() : 0;
  Json terms = Json::object();
  for (const auto& [name, value] : energy.terms) terms[name] = value;
  Json json = {
      {"kinetic", energy.kinetic},
      {"strain", energy.strain},
      {"total", energy.total},
      {"initial", energy.initial},
      // A body at rest has no energy to compare with.
      {"relative_change", energy.initial > round_off ? Json(energy.total / energy.initial - 1) : Json()},
      {"terms", terms},
      {"dissipated", number_or_null(energy.dissipated)},
      {"load_work", number_or_null(energy.load_work)},
      {"damping_work", number_or_null(energy.damping_work)},
      {"support_work", number_or_null(energy.support_work)},
      {"net_change", number_or_null(energy.net_change)}};
  if (energy.contact_work) json["contact_work"] = *energy.contact_work;
  return json;
}

template <int d>
Json momentum_json(const FinishedRun<d>& run) {
  const Momentum now = run.simulation.momentum();
  const Drifts drift = drifts_of(run);
  return {{"linear_momentum", std::vector<double>(now.linear.begin(), now.linear.begin() + d)},
          {"angular_momentum", now.angular},
          {"linear_drift", drift.linear},
          {"angular_drift", drift.angular}};
}

}  // namespace

template <int d>
EnergyBudget energy_budget(const FinishedRun<d>& run) {
  const auto& simulation = run.simulation;
  const Energy now = simulation.energy();
  const double initial = run.record.initial_energy.value();
  EnergyBudget budget;
  budget.kinetic = now.kinetic;
  budget.strain = now.strain;
  budget.total = now.total();
  budget.initial = initial;
  for (const auto& more : now.more) budget.terms[more.name] += more.value;
  budget.dissipated = now.dissipated;
  double scale = initial;
  if (simulation.external_work) {
    budget.load_work = budget.damping_work = budget.support_work = 0;
    for (const auto& [action, done] : simulation.external_work()) {
      budget.at_work.push_back(action);
      budget.work_of(action) = done;
      scale += std::abs(done);
    }
  }
  const double round_off = simulation.energy_round_off ? simulation.energy_round_off() : 0;
  if (scale > round_off && !simulation.has_other_work)
    budget.net_change = (now.total() - initial - budget.work()) / scale;
  return budget;
}

template <int d>
Drifts drifts_of(const FinishedRun<d>& run) {
  const Momentum now = run.simulation.momentum();
  const Momentum& before = run.record.initial_momentum;
  return {drift(now.linear, before.linear, before.linear_scale, now.linear_scale),
          drift(now.angular, before.angular, before.angular_scale, now.angular_scale)};
}

const char* status_of(const RunResult& result) {
  if (result.failure) return "unstable";
  return result.stopped ? "interrupted" : "completed";
}

template <int d>
Json summary(const FinishedRun<d>& run) {
  const Counts counts = run.simulation.counts();
  const Moment now = run.simulation.steps.now();
  const auto particles = static_cast<double>(counts.particles);
  const Extent<d> extent = extent_of(run.simulation.snapshot());
  const auto& dt = run.result.dt;
  Json json{{"scene", run.scene.name},
            {"dimension", d},
            {"scheme", run.simulation.scheme},
            {"particles", counts.particles},
            {"neighbours",
             {{"mean", static_cast<double>(counts.pairs) / particles}, {"max", counts.most_neighbours}}},
            {"status", status_of(run.result)},
            {"steps", now.step},
            {"time", now.time},
            {"residual", run.result.residual ? Json(*run.result.residual) : Json()},
            {"dt", {{"first", dt.first}, {"min", dt.least}, {"max", dt.most}, {"last", dt.last}}},
            {"energy", energy_json(run)}};
  json.update(momentum_json(run));
  json["extent"] = {{"min", list<d>(extent.lower)}, {"max", list<d>(extent.upper)}};
  json["hourglass_share"] = run.simulation.hourglass_share ? Json(run.simulation.hourglass_share()) : Json();
  if (run.simulation.reactions) {
    json["reactions"] = Json::object();
    for (const auto& [boundary, force] : run.simulation.reactions())
      json["reactions"][boundary] = list<d>(force);
  }
  if (run.simulation.load_factor) json["load_factor"] = run.simulation.load_factor();
  json["probes"] = probes_json(run);
  if (!run.scene.exact.empty()) json["error"] = error_json(run);
  json["failure"] = failure_json(run.result.failure);
  if (run.result.failure)
    json["failure"]["likely_cause"] = run.tlsph && run.scene.method.scheme == "tlsph"
                                          ? likely_cause<d>(run.scene, *run.tlsph, run.result.dt.first)
                                          : "";
  json["timing"] = {{"setup_s", run.record.setup_s},
                    {"wall_s", run.record.wall_s},
                    {"cpu_s", run.record.cpu_s},
                    {"computing_s", run.record.computing_s()},
                    {"writing_s", run.record.writing_s},
                    {"particle_evaluations_per_s",
                     static_cast<double>(counts.work.particle_evaluations) / run.record.computing_s()}};
  json["work"] = {{"particle_evaluations", counts.work.particle_evaluations},
                  {"pair_evaluations", counts.work.pair_evaluations},
                  {"bytes", std::llround(static_cast<double>(counts.work.particle_evaluations) *
                                         counts.bytes_per_update)}};
  const auto bytes = static_cast<double>(total_bytes(run.simulation.arrays()));
  json["memory"] = {{"bytes_per_particle", bytes / particles}, {"peak_rss", peak_resident_bytes()}};
  if (run.tlsph && run.tlsph->compatible) json["compatible"] = compatible_json(run.tlsph->compatible.get());
  const Parts parts = run.tlsph ? parts_of(run.scene, *run.tlsph) : Parts{};
  json["built"] = parts.built;
  json["left_out"] = parts.left_out;
  return json;
}

template Json summary<1>(const FinishedRun<1>&);
template Json summary<2>(const FinishedRun<2>&);
template Json summary<3>(const FinishedRun<3>&);
template EnergyBudget energy_budget<1>(const FinishedRun<1>&);
template EnergyBudget energy_budget<2>(const FinishedRun<2>&);
template EnergyBudget energy_budget<3>(const FinishedRun<3>&);
template Drifts drifts_of<1>(const FinishedRun<1>&);
template Drifts drifts_of<2>(const FinishedRun<2>&);
template Drifts drifts_of<3>(const FinishedRun<3>&);

}  // namespace plumb::app
