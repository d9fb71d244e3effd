#include "lib/scene/tlsph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/graded_lattice.hpp"
#include "lib/scene/actions_of_scene.hpp"
#include "lib/scene/compatible_table.hpp"
#include "lib/scene/initial_motion.hpp"
#include "lib/scene/make_cloud.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/warnings.hpp"
#include "lib/schemes/tlsph/bonds/own_supports.hpp"
#include "lib/schemes/tlsph/boundary/apply_actions.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"
#include "lib/schemes/tlsph/compatible/consistent_force.hpp"
#include "lib/schemes/tlsph/loops/make_solid.hpp"
#include "lib/schemes/tlsph/loops/part_site.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/time/with_history.hpp"

namespace plumb {
namespace {

/// A step that rounding swallows would never end.
void require_progress(double dt, const Scene& scene) {
  if (!(dt > 0) || !std::isfinite(dt))
    throw InputError(fmt::format("the time step would be {:g} s", dt),
                     "sizes or stiffness are beyond the range of numbers",
                     "check the units of body, material and method");
  constexpr double most_steps = 1e15;  // below 2^53: every step still changes the time
  if (scene.end_time && *scene.end_time / dt > most_steps)
    throw InputError(fmt::format("{:.3g} steps to the end", *scene.end_time / dt),
                     fmt::format("the time step is {:.3g} s, end_time {:.3g} s", dt, *scene.end_time),
                     "use a larger cfl or time_step, or an earlier end");
}

template <int d>
void set_initial_state(const Solid<d>& solid, const Scene& scene, State<d>& state) {
  const InitialMotion<d> start = initial_motion<d>(scene, solid.cloud);
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Index slot = solid.bonds.slots.of(i);
    if (!start.u.empty()) set_vector<d>(state.u, slot, start.u[i]);
    if (!start.v.empty()) set_vector<d>(state.v, slot, start.v[i]);
  }
}

/// Roller faces of a mirror layout.
std::vector<Wall> walls_of(const Scene& scene) {
  std::vector<Wall> walls;
  if (scene.body.layout != Layout::mirror) return walls;
  for (const auto& boundary : scene.boundaries)
    if (boundary.kind == BoundaryKind::roller)
      walls.push_back({boundary.face->axis, boundary.face->side > 0});
  return walls;
}

/// The surface that the particles themselves suggest; their volumes become those of the cells that it cuts.
template <int d>
Surface<d> guess_surface(Cloud<d>& cloud) {
  if constexpr (d == 1) {
    throw InputError("an estimated surface in one dimension", "the ends of a bar are known",
                     "use surface = \"shape\"");
  } else {
    const Shape<d> shape = shape_around(cloud);
    cloud.V = clipped_cells<d>(cloud.X, shape).volume;
    return clipped_surface<d>(cloud, shape);
  }
}

/// Radii of supports that each particle has for itself [m]; empty: all have the kernel's.
template <int d>
std::vector<double> own_radii(const Scene& scene, const Cloud<d>& cloud, const RadialKernel<d>& kernel) {
  if (scene.method.nearest > 0) return support_radii(cloud, scene.method.nearest);
  if (!scene.method.by_spacing || !scene.body.finer) return {};
  std::vector<double> radius = graded_spacings<d>(cloud, finer_of<d>(scene.body));
  for (double& r : radius) r *= scene.method.beta * kernel.support;
  return radius;
}

/// Changes of an area vector beyond this [spacing^(d-1)] are larger than any area a particle has.
constexpr double large_change = 3;

template <int d>
std::string large_change_text(double change) {
  return fmt::format(
      "area vectors of the compatible table change by up to {:.2g} spacings^{}: particles near "
      "the surface have too few neighbours, and stable steps are about as many times smaller "
      "than cfl says. Put particles on the surface (layout = \"node\") or use a larger beta",
      change, d - 1);
}

}  // namespace

template <int d>
BondOptions<d> bond_options(const Scene& scene, double spacing) {
  BondOptions<d> options;
  options.kernel = kernel_named<d>(scene.method.kernel);
  options.smoothing_length = scene.method.beta * spacing;
  options.pair = pair_named(scene.method.pair);
  const bool compatible = scene.method.gradient == "compatible";
  options.estimator = estimator_named<d>(compatible ? scene.method.compatible.start : scene.method.gradient);
  if (options.pair == Correction::none) options.estimator = &normalised_kernel_gradient<d>;
  const bool variational = scene.method.momentum == "variational";
  options.momentum = momentum_form_named<d>(variational ? "adjoint" : scene.method.momentum);
  options.walls = walls_of(scene);
  for_each_part(scene.method, [&](const auto& part) {
    if constexpr (requires { part->ask_for_weights(options); })
      if (part) part->ask_for_weights(options);
  });
  return options;
}

namespace {

/// Commands that look into the body know that of total Lagrangian schemes only.
void refuse_own_body(const Scene& scene) {
  if (has_own_body(scene.method.scheme))
    throw InputError(fmt::format("scheme = \"{}\" does not go with this command", scene.method.scheme),
                     "it looks into the bonds and terms of scheme = \"tlsph\"",
                     "use plumb run, plumb explain or plumb mms, or another scheme");
}

}  // namespace

template <int d>
TlsphBody<d> make_tlsph(const Scene& scene) {
  Cloud<d> cloud = make_cloud<d>(scene.body);
  std::optional<Surface<d>> surface;
  if (needs_surface<d>(scene, cloud) && scene.method.compatible.surface == "shape")
    surface = surface_of<d>(scene.body, cloud);
  return make_tlsph<d>(scene, std::move(cloud), surface);
}

template <int d>
TlsphBody<d> make_tlsph(const Scene& scene, Cloud<d> cloud, std::optional<Surface<d>> surface) {
  refuse_own_body(scene);
  BondOptions<d> options = bond_options<d>(scene, cloud.spacing);
  const std::vector<double> radius = own_radii<d>(scene, cloud, options.kernel);
  if (!radius.empty()) use_own_supports(options, radius);
  TlsphBody<d> simulation;
  std::vector<std::string> warnings;
  if (needs_surface<d>(scene, cloud) && !surface) {
    surface = guess_surface(cloud);
    warnings.push_back(
        fmt::format("the surface is estimated from the particles, at about half a spacing beyond them: "
                    "volume {:.6g} m^{}",
                    surface->volume, d));
  }
  std::vector<FlatSide<d>> sides;
  const bool loaded = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                  [](const Boundary& boundary) { return is_load(boundary.kind); });
  if (surface && loaded)
    sides = boundary_vectors<d>(cloud, options.kernel, options.smoothing_length, *surface).sides;
  if (scene.method.gradient == "compatible")
    simulation.compatible = make_it_compatible<d>(options, scene, cloud, surface);
  if (scene.method.momentum == "variational") make_force_consistent(options, cloud, *surface);
  simulation.solid = make_solid<d>(std::move(cloud), scene.material.law(), scene.material.elastic(), options);
  if (simulation.compatible && simulation.compatible->largest_change > large_change)
    warnings.push_back(large_change_text<d>(simulation.compatible->largest_change));
  simulation.state = make_state(simulation.solid);
  simulation.control = step_control(scene);
  const auto facets = [&] {
    return surface ? surface->facets : surface_of<d>(scene.body, simulation.solid.cloud).facets;
  };
  const double time_scale = time_scale_of(scene);
  simulation.actions = actions_of_scene<d>(simulation.solid.cloud, scene, facets, time_scale,
                                           [&] { return std::move(sides); });
  simulation.supports = supports_of(simulation.actions);
  set_initial_state(simulation.solid, scene, simulation.state);
  impose(simulation.solid, simulation.actions, simulation.state);
  PartSite<d> site{simulation.solid, options.kernel, stability_limits(scene.method.integrator).real_axis,
                   radius};
  for_each_part(scene.method, [&](const auto& part) {
    if (part) part->add_to(site);
  });
  refuse_contradictions<d>(simulation.solid.cloud, simulation.actions, time_scale);
  const double step = time_step(simulation.solid, simulation.state, simulation.control);
  require_progress(step, scene);
  simulation.warnings =
      warnings_of<d>(scene, simulation.solid,
                     {step, crossing_time(simulation.solid, simulation.state, simulation.control.wave_speed),
                      stability_limits(scene.method.integrator).real_axis});
  simulation.warnings.insert(simulation.warnings.begin(), warnings.begin(), warnings.end());
  apply_actions(simulation.solid, simulation.actions);
  simulation.integrator =
      with_history(with_prescribed_motion(integrator_named<d>(scene.method.integrator, simulation.solid),
                                          simulation.actions),
                   simulation.solid);
  commit_history(simulation.solid, simulation.state);  // [initial] displacement
  prepare(*simulation.integrator.workspace, simulation.solid, simulation.solid.terms);
  return simulation;
}

template <int d>
std::vector<ArrayEntry> arrays_of(const TlsphBody<d>& simulation) {
  const Solid<d>& solid = simulation.solid;
  const Workspace<d>& workspace = *simulation.integrator.workspace;
  std::vector<ArrayEntry> arrays = {
      {"reference positions and volumes",
       solid.cloud.X.size() * sizeof(Vec<d>) + solid.cloud.V.size() * sizeof(double)},
      {"volumes per slot", solid.volume.size() * sizeof(double)},
      {"bond table", solid.bonds.bytes()},
      {"bond table, in the order of the loops", solid.sweeps.bytes},
      {"displacement", simulation.state.u.bytes()},
      {"velocity", simulation.state.v.bytes()},
      {"first Piola-Kirchhoff stress, a window", workspace.P.bytes()},
      {"integrator " + std::string(simulation.integrator.name), simulation.integrator.bytes}};
  if (stores_F(solid.terms)) arrays.push_back({"deformation gradient", workspace.F.bytes()});
  if (solid.sweeps.history) arrays.push_back({"history", solid.sweeps.history->field.bytes()});
  if (stores_force(solid.terms)) arrays.push_back({"force", workspace.stored_force.bytes()});
  for (const auto& term : solid.terms) arrays.push_back({term.name, term.bytes});
  arrays.push_back(
      {"prescribed velocities", simulation.supports.size() * (sizeof(Support<d>) + sizeof(HeldPlace<d>))});
  if (follows_closest_pairs(simulation.control))
    arrays.push_back({"closest pairs, for the time step", closest_pairs_bytes(solid)});
  std::erase_if(arrays, [](const ArrayEntry& entry) { return entry.bytes == 0; });
  return arrays;
}

template BondOptions<1> bond_options<1>(const Scene&, double);
template BondOptions<2> bond_options<2>(const Scene&, double);
template BondOptions<3> bond_options<3>(const Scene&, double);
template TlsphBody<1> make_tlsph<1>(const Scene&);
template TlsphBody<2> make_tlsph<2>(const Scene&);
template TlsphBody<3> make_tlsph<3>(const Scene&);
template TlsphBody<1> make_tlsph<1>(const Scene&, Cloud<1>, std::optional<Surface<1>>);
template TlsphBody<2> make_tlsph<2>(const Scene&, Cloud<2>, std::optional<Surface<2>>);
template TlsphBody<3> make_tlsph<3>(const Scene&, Cloud<3>, std::optional<Surface<3>>);
template std::vector<ArrayEntry> arrays_of<1>(const TlsphBody<1>&);
template std::vector<ArrayEntry> arrays_of<2>(const TlsphBody<2>&);
template std::vector<ArrayEntry> arrays_of<3>(const TlsphBody<3>&);

}  // namespace plumb
