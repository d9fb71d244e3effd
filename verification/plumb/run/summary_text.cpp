#include <fmt/format.h>

#include "lib/measures/body_units.hpp"
#include "lib/output/progress.hpp"
#include "lib/output/terminal.hpp"
#include "verification/plumb/run/inventory.hpp"
#include "verification/plumb/run/likely_cause.hpp"
#include "verification/plumb/run/summary.hpp"
#include "verification/plumb/run/summary_parts.hpp"

namespace plumb::app {
namespace {

std::string place_text(const double* values, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += fmt::format("{}{:.6g}", k ? ", " : "", values[k]);
  return "(" + text + ")";
}

std::string failure_text(const Failure& failure) {
  std::string text = fmt::format("  {}: {}", name_of(failure.cause), failure.quantity);
  if (failure.value) text += fmt::format(" = {:.6g}", *failure.value);
  if (failure.particle) text += fmt::format(" at particle {}", *failure.particle);
  return text + fmt::format(", step {}, t = {:.9g} s\n", failure.step, failure.time);
}

/// "energy 3 J = kinetic 1 + strain 2", and how it came about.
template <int d>
std::string energy_text(const FinishedRun<d>& run) {
  const char* unit = BodyUnits<d>::energy;
  EnergyBudget energy = energy_budget(run);
  std::string text = fmt::format("  energy {:.9g} {} = kinetic {:.9g} + strain {:.9g}", energy.total, unit,
                                 energy.kinetic, energy.strain);
  for (const auto& [name, value] : energy.terms) text += fmt::format(" + {} {:.9g}", name, value);
  text += fmt::format("\n  at the start {:.9g} {}", energy.initial, unit);
  for (const std::string& action : energy.at_work) {
    const double done = energy.work_of(action).value();
    text +=
        fmt::format(", work of {}{} {:.9g} {}", action == "supports" ? "moving " : "", action, done, unit);
  }
  if (energy.net_change)
    text += fmt::format(": a change of {:+.3g} %{}", 100 * *energy.net_change,
                        energy.at_work.empty() ? "" : " net of that work");
  if (energy.dissipated) text += fmt::format("; dissipated {:.9g} {}", *energy.dissipated, unit);
  return text + "\n";
}

template <int d>
std::string probe_text(const FinishedRun<d>& run, const BoundProbe& probe) {
  const PointView<d> at = run.simulation.at(probe.particle);
  std::string text = fmt::format("  probe \"{}\": particle {} at {} m", probe.name, probe.particle,
                                 place_text(at.X.data(), d));
  if (probe.distance > 1e-9 * run.simulation.spacing)
    text += fmt::format(", {:.3g} m from {}", probe.distance, place_text(probe.at.data(), d));
  return text + fmt::format(": displacement {} m, velocity {} m/s\n", place_text(at.u.data(), d),
                            place_text(at.v.data(), d));
}

}  // namespace

template <int d>
std::string summary_text(const FinishedRun<d>& run) {
  const Extent<d> extent = extent_of(run.simulation.snapshot());
  const RunRecord& record = run.record;
  const Moment now = run.simulation.steps.now();
  std::string text = fmt::format(
      "{}: {} at {:.6g} s, {} steps, {} particles\n  computing {}, writing {}, set-up {}\n", run.scene.name,
      status_of(run.result), now.time, now.step, run.simulation.counts().particles,
      duration_text(record.computing_s()), duration_text(record.writing_s), duration_text(record.setup_s));
  if (run.result.residual)
    text += fmt::format("  residual {:.3g} of the forces of loads and supports\n", *run.result.residual);
  if (run.result.failure) {
    text += failure_text(*run.result.failure);
    const std::string cause = run.tlsph && run.scene.method.scheme == "tlsph"
                                  ? likely_cause<d>(run.scene, *run.tlsph, run.result.dt.first)
                                  : std::string();
    if (!cause.empty())
      text +=
          "  likely cause: " + wrapped(cause, static_cast<std::size_t>(terminal_columns(1)), 16, 2) + "\n";
  }
  text += energy_text(run);
  if (is_free(run.scene)) {
    const Drifts drift = drifts_of(run);
    text += fmt::format("  drift of linear momentum {:.3g}{}, relative to the initial scale\n", drift.linear,
                        d > 1 ? fmt::format(", of angular momentum {:.3g}", drift.angular) : "");
  }
  for (int k = 0; k < d; ++k)
    text += fmt::format("  {} from {:.6g} to {:.6g} m\n", "xyz"[k], extent.lower[k], extent.upper[k]);
  if (run.simulation.reactions)
    for (const auto& [boundary, force] : run.simulation.reactions())
      text += fmt::format("  supports \"{}\" push with {} {}\n", boundary, place_text(force.data(), d),
                          BodyUnits<d>::force);
  for (const auto& probe : run.probes) text += probe_text(run, probe);
  if (run.tlsph && run.tlsph->compatible) text += "  " + compatible_text(run.tlsph->compatible.get());
  return text;
}

template std::string summary_text<1>(const FinishedRun<1>&);
template std::string summary_text<2>(const FinishedRun<2>&);
template std::string summary_text<3>(const FinishedRun<3>&);

}  // namespace plumb::app
