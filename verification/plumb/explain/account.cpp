#include "verification/plumb/explain/account.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/core/error.hpp"
#include "lib/kernel/kernel.hpp"
#include "lib/scene/go_implicitly.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "verification/plumb/parts.hpp"

namespace plumb::app {
namespace {

/// The statement about a part of a catalogue; `more` equations go in front of its own.
Statement about(std::string_view kind, const std::string& name, const std::string& detail = "",
                const std::string& more = "") {
  Statement statement{std::string(kind), name, more.empty() ? "" : "THEORY " + more};
  for (const Part& part : parts) {
    if (part.kind != kind || part.name != name) continue;
    if (!part.meaning.empty()) statement.text += ": " + std::string(part.meaning);
    if (part.theory.empty()) continue;
    if (more.empty())
      statement.theory = part.theory;
    else
      statement.theory += ", " + std::string(part.theory.substr(part.theory.find('(')));
  }
  if (!detail.empty()) statement.text += "; " + detail;
  return statement;
}

std::string list(const auto& numbers, std::string_view between) {
  std::string text;
  for (const auto& number : numbers)
    text += fmt::format("{}{:g}", text.empty() ? "" : between, double(number));
  return text;
}

/// "(3, -9.81) m/s^2": formulas of numbers in one unit.
std::string list(const std::vector<Expression>& formulas, std::string_view unit) {
  std::string text;
  for (const auto& formula : formulas) text += (text.empty() ? "" : ", ") + formula.text();
  return fmt::format("({}) {}", text, unit);
}

std::string_view name_of(Layout layout) {
  return layout == Layout::node ? "node" : layout == Layout::cell ? "cell" : "mirror";
}

template <int d>
Statement body_of(const Scene& scene, const TlsphBody<d>& simulation) {
  const auto& solid = simulation.solid;
  const auto particles = static_cast<double>(solid.cloud.size());
  std::string text = fmt::format(
      "{} of {} m{}, {} particles {:.4g} m apart ({} layout{}), {:.1f} neighbours each, at most {}",
      scene.body.shape, list(scene.body.size, " x "),
      d == 3                                  ? ""
      : d == 1                                ? " in uniaxial strain"
      : scene.material.plane == Plane::stress ? " in plane stress"
                                              : " in plane strain",
      solid.cloud.size(), solid.cloud.spacing, name_of(scene.body.layout),
      (scene.body.finer ? fmt::format(", half of that where {}", scene.body.finer->text()) : "") +
          (scene.body.jitter > 0 ? fmt::format(", moved at random by up to {:g} of that", scene.body.jitter)
                                 : ""),
      static_cast<double>(solid.bonds.pairs) / particles, solid.bonds.most_neighbours);
  return {"body", text, ""};
}

Statement correction_of(const Scene& scene) {
  if (scene.method.pair == "none") {
    const std::string reach =
        scene.method.nearest > 0
            ? fmt::format(", in supports that reach to the {}th neighbour", scene.method.nearest)
        : scene.method.by_spacing ? ", in supports of each particle's own spacing"
                                  : "";
    return {"correction", "none: the kernel as it is, its gradient normalised by L^-1" + reach,
            "004 (10) to (12)"};
  }
  if (scene.method.pair == "W1")
    return {"correction", "W1: sums of constant and of linear fields are exact, at boundaries too",
            "THEORY (2.2), (2.7)"};
  return {"correction",
          scene.method.pair +
              ": Shepard kernel, sums of constant fields are exact; its gradient is "
              "corrected to be exact for linear ones",
          "THEORY (2.4), (2.6)"};
}

Statement gradient_of(const Scene& scene, const CompatibleReport* compatible) {
  if (!compatible) return about("gradient", scene.method.gradient, "", "(3.1)");
  const auto& how = scene.method.compatible;
  if (compatible->closed_form)
    return {"gradient",
            fmt::format("compatible: the {} table of an infinite lattice, closed at the faces by summation "
                        "by parts; nothing is solved at set-up",
                        how.start),
            "THEORY (11.9)-(11.12)"};
  return {"gradient",
          fmt::format("compatible: area vectors nearest to the {} table that are closed and exact, volumes "
                      "{}; projected at set-up, because {}",
                      how.start, how.volumes, compatible->why_projected),
          "THEORY (11.1), (11.4)"};
}

Statement loads_of(const LoadOptions& load) {
  std::string text;
  if (!load.gravity.empty()) text = "gravity " + list(load.gravity, "m/s^2");
  if (!load.body_force.empty())
    text += (text.empty() ? "" : ", ") + ("force per volume " + list(load.body_force, "N/m^3"));
  if (load.ramp) text += fmt::format(", ramped up in {:g} s", *load.ramp);
  return {"loads", text, "THEORY (5.7)"};
}

/// "moved with 1 m/s, 0": what a boundary does.
std::string in_words(const Boundary& boundary) {
  const std::string ramp = boundary.ramp ? fmt::format(", ramped up in {:g} s", *boundary.ramp) : "";
  switch (boundary.kind) {
    case BoundaryKind::clamped:
      return "clamped";
    case BoundaryKind::roller:
      return "on rollers";
    case BoundaryKind::velocity:
      return "moved with " + list(boundary.velocity, "m/s") + ramp;
    case BoundaryKind::displacement:
      return "displaced by " + list(boundary.displacement, "m") + ramp;
    case BoundaryKind::traction:
      return "under the traction " + list(boundary.traction, "Pa") + ramp;
    case BoundaryKind::pressure:
      return "under the pressure " + boundary.pressure->text() + " Pa" + ramp;
  }
  return {};
}

template <int d>
Statement held(const Scene& scene, const TlsphBody<d>& simulation) {
  std::string text;
  for (const auto& boundary : scene.boundaries) {
    text += text.empty() ? "" : ", ";
    text += boundary.face
                ? fmt::format("face {}{}", "xyz"[boundary.face->axis], boundary.face->side < 0 ? '-' : '+')
                : "where " + boundary.where->text();
    text += " " + in_words(boundary);
  }
  return {"supports", fmt::format("{} ({} components of particles held)", text, simulation.supports.size()),
          ""};
}

Statement start_of(const Scene& scene) {
  if (!scene.initial) return {"start", "at rest", ""};
  if (scene.initial->spin)
    return {"start",
            fmt::format("turning with ({}) rad/s about the centre", list(*scene.initial->spin, ", ")), ""};
  return {"start", "with velocity " + list(scene.initial->velocity, "m/s"), ""};
}

/// "t = 0.1 s, or after 100 steps".
Statement end_of(const Scene& scene) {
  std::string text = scene.end_time ? fmt::format("at t = {:g} s", *scene.end_time) : "";
  if (scene.max_steps) text += fmt::format("{}after {} steps", text.empty() ? "" : ", or ", *scene.max_steps);
  if (scene.relaxation)
    return {"ends",
            fmt::format("at rest: unbalanced forces of {:g} of those of loads and supports; it fails if that "
                        "is not reached {}",
                        scene.relaxation->residual, text),
            "THEORY (5.10)"};
  return {"ends", text, ""};
}

/// What a run would write.
Statement output_of(const Scene& scene) {
  if (!scene.output) return {"writes", "a summary only: there is no [output]", ""};
  const Output& output = *scene.output;
  std::vector<std::string> files;
  if (output.series) files.emplace_back("energies and momenta against time");
  for (const Probe& probe : output.probes) files.push_back("what happens at \"" + probe.name + "\"");
  if (output.vtk) files.emplace_back("particles for ParaView");
  if (output.budget) files.emplace_back("what changed momenta and energy, step by step");
  if (output.checkpoint) files.push_back(fmt::format("a checkpoint every {:g} s", *output.checkpoint));
  if (files.empty()) return {"writes", "a summary only: [output] asks for nothing", ""};
  return {"writes",
          join(files) + (output.every ? fmt::format(" (every {:g} s)", *output.every)
                                      : std::string(" (the first and the last state)")),
          ""};
}

/// ", ratio = 0.25, plane stress": what the law has beside E and nu.
std::string own_parameters(const MaterialChoice& material) {
  std::string text;
  for (const auto& [name, value] : material.parameters) text += fmt::format(", {} = {:.4g}", name, value);
  return material.plane == Plane::stress ? text + ", plane stress" : text;
}

/// The integrator and the loops that it runs.
template <int d>
void add_explicit_steps(const TlsphBody<d>& simulation, std::vector<Statement>& all) {
  all.push_back(about("integrator", std::string(simulation.integrator.name),
                      fmt::format("{} evaluation{} a step", simulation.integrator.evaluations_per_step,
                                  simulation.integrator.evaluations_per_step > 1 ? "s" : "")));
  all.push_back({"loops",
                 simulation.solid.cloud.line > 0
                     ? "those of lattices: equal neighbourhoods share their constants"
                     : "those of irregular particles: every bond has its own constants",
                 simulation.solid.cloud.line > 0 ? "THEORY (10.1), (10.4)" : "THEORY (10.1)"});
}

}  // namespace

template <int d>
std::vector<Statement> account_of(const Scene& scene, const TlsphBody<d>& simulation) {
  const Elastic elastic = scene.material.elastic();
  const double support = kernel_named<d>(scene.method.kernel).support;
  std::vector<Statement> all{body_of(scene, simulation)};
  all.push_back(
      about("material", scene.material.model,
            fmt::format("mu = {:.4g} Pa, kappa = {:.4g} Pa{}, waves of "
                        "{:.4g} m/s (pressure) and {:.4g} m/s (shear)",
                        elastic.shear_modulus(), elastic.bulk_modulus(), own_parameters(scene.material),
                        simulation.solid.elastic.wave_speed(), elastic.shear_wave_speed()),
            "(4.1)"));
  all.push_back(
      about("kernel", scene.method.kernel,
            fmt::format("h = {:.4g} m, beta = {:g}, so it reaches {:.3g} spacings",
                        simulation.solid.smoothing_length, scene.method.beta, support * scene.method.beta)));
  all.push_back(correction_of(scene));
  all.push_back(gradient_of(scene, simulation.compatible.get()));
  all.push_back(about("momentum", scene.method.momentum, "", "(5.1)"));
  for_each_part(scene.method, [&]<class Part>(const std::optional<Part>& part) {
    if (part) all.push_back({std::string(Part::subject), part->in_words(), std::string(Part::theory)});
  });
  if (scene.load) all.push_back(loads_of(*scene.load));
  if (solved_by_newton(scene.method))
    all.push_back(said_of(scene.method.implicit));
  else
    add_explicit_steps(simulation, all);
  if (!scene.boundaries.empty()) all.push_back(held(scene, simulation));
  all.push_back(start_of(scene));
  all.push_back(end_of(scene));
  all.push_back(output_of(scene));
  return all;
}

template <int d>
Statement step_reason(const Scene& scene, const TlsphBody<d>& simulation, double dt) {
  const StepControl& control = simulation.control;
  const double crossing = crossing_time(simulation.solid, simulation.state, control.wave_speed);
  if (control.fixed_step)
    return {"time step",
            fmt::format("fixed by the scene; {:.3g} of the time that a pressure wave needs between the "
                        "closest neighbours",
                        dt / crossing),
            "THEORY (7.3)"};
  if (dt > simulation.solid.step_limit * (1 - 1e-9))
    return {"time step", "the most that the dissipation bears; cfl would allow more", "THEORY (6.5)"};
  return {
      "time step",
      fmt::format("cfl = {:g} times {:.4g} s, which a wave of speed {} needs between the closest neighbours",
                  control.cfl, crossing,
                  scene.method.wave_speed == "linear"
                      ? fmt::format("{:.4g} m/s", simulation.solid.elastic.wave_speed())
                      : scene.method.wave_speed),
      "THEORY (7.3)"};
}

template std::vector<Statement> account_of<1>(const Scene&, const TlsphBody<1>&);
template std::vector<Statement> account_of<2>(const Scene&, const TlsphBody<2>&);
template std::vector<Statement> account_of<3>(const Scene&, const TlsphBody<3>&);
template Statement step_reason<1>(const Scene&, const TlsphBody<1>&, double);
template Statement step_reason<2>(const Scene&, const TlsphBody<2>&, double);
template Statement step_reason<3>(const Scene&, const TlsphBody<3>&, double);

}  // namespace plumb::app
