#include "mms/level.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

#include "lib/core/dimension.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "lib/scene/make_cloud.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"
#include "mms/annulus.hpp"
#include "mms/curved_surface.hpp"
#include "mms/drive.hpp"
#include "mms/mirrored.hpp"
#include "mms/pace.hpp"
#include "mms/scheme_level.hpp"

namespace plumb::mms {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A shape lies inside of the solution's domain, and is displaced on its whole surface.
template <int d>
void check_shape(const Study& study, const Domain<d>& domain, const Box<d>& box) {
  const std::string what = fmt::format("a body of shape \"{}\" in this study", study.body.shape);
  const double slack = 1e-9 * domain.box.size.maxCoeff();
  if (domain.shape != Domain<d>::Shape::box || ((domain.box.origin - box.origin).array() > slack).any() ||
      ((box.origin + box.size - domain.box.origin - domain.box.size).array() > slack).any())
    throw InputError(what, "it leaves the domain of the solution", "Use a smaller one, or move it.");
}

/// The box of the study must be the solution's domain: its face conditions hold nowhere else.
template <int d>
void check_domain(const Study& study, const Manufactured<d>& solution) {
  const Domain<d>& domain = solution.domain;
  if (domain.shape != Domain<d>::Shape::box && wants_gauss(study))
    throw InputError(fmt::format("Gauss norms of {}", solution.name),
                     "its domain is an annulus, the tiles are boxes", "Use quadrature = \"nodal\".");
  if (has_curved_surface(study) && study.method.scheme != "tlsph" && study.method.scheme != "implicit")
    throw InputError(fmt::format("scheme \"{}\" on a curved surface", study.method.scheme),
                     "no solution acts there on a body of its own",
                     "Use scheme = \"tlsph\", or a box without holes.");
  if (study.body.shape != "box") {
    const Box<d> box{Eigen::Map<const Vec<d>>(study.body.origin.data()),
                     Eigen::Map<const Vec<d>>(study.body.size.data())};
    return check_shape(study, domain, box);
  }
  for (int a = 0; a < d; ++a) {
    const double origin = study.body.origin.empty() ? 0 : study.body.origin[static_cast<std::size_t>(a)];
    const double size = study.body.size[static_cast<std::size_t>(a)];
    const double slack = 1e-9 * domain.box.size[a];
    if (std::abs(origin - domain.box.origin[a]) > slack || std::abs(size - domain.box.size[a]) > slack)
      throw InputError(fmt::format("body: axis {} runs from {:g} to {:g}", "XYZ"[a], origin, origin + size),
                       fmt::format("the domain of {} runs from {:g} to {:g}", solution.name,
                                   domain.box.origin[a], domain.box.origin[a] + domain.box.size[a]),
                       "Use the domain of the solution.");
  }
}

/// Walls with images behind them; none unless the layout is mirror.
template <int d>
std::vector<Wall> driven_walls(const Study& study, const Manufactured<d>& solution) {
  return study.body.layout == Layout::mirror ? mirror_walls(solution) : std::vector<Wall>{};
}

/// Whether an annulus is filled with rings of particles; else it clips a lattice or a random cloud.
bool has_rings(const Study& study) {
  return study.body.layout == Layout::node && study.body.cloud == "lattice" && !(study.body.jitter > 0);
}

/// The scene of one level, without initial state and with no boundaries but mirrors: the rest comes from the
/// solution.
Scene scene_of_level(const Study& study, const std::vector<Wall>& walls, double spacing, double end) {
  Scene scene;
  scene.name = study.name;
  scene.dimension = study.dimension();
  scene.end_time = end;
  scene.body = with_spacing(study.body, spacing);
  scene.material = study.material;
  scene.method = study.method;
  for (const Wall& wall : walls) {
    Boundary boundary;
    boundary.face = Face{wall.axis, wall.upper ? +1 : -1};
    boundary.kind = BoundaryKind::roller;
    scene.boundaries.push_back(boundary);
  }
  return scene;
}

}  // namespace

Scene scene_of_level(const Study& study, double spacing) {
  return scene_of_level(study, {}, spacing, end_time(study));
}

bool wants_gauss(const Study& study) {
  return study.quadrature != "nodal";
}
bool wants_nodal(const Study& study) {
  return study.quadrature != "gauss";
}

Loading loading_of(const Study& study) {
  return {.body_force = study.force == "finite-strain"};
}

double end_time(const Study& study) {
  if (study.time) return *study.time;
  return *study.periods *
         with_dimension(study.dimension(), [&]<int d>() { return solution_of<d>(study).period; });
}

template <int d>
Manufactured<d> solution_of(const Study& study) {
  Manufactured<d> solution =
      manufactured<d>(study.solution, study.parameters, study.material.elastic(), study.material.law());
  check_domain(study, solution);
  return solution;
}

template <int d>
ExactField<d> exact_field(const Manufactured<d>& solution, double time) {
  return
      [motion_at = solution.motion, stress = solution.first_piola, time](const Vec<d>& X) -> PointValue<d> {
        const Motion<d> motion = motion_at(X, time);
        return {motion.displacement, motion.F - Mat<d>::Identity(), motion.velocity, stress(motion.F)};
      };
}

template <int d>
Surface<d> surface_of(const Study& study, const Manufactured<d>& solution, const Cloud<d>& cloud) {
  if constexpr (d == 2) {
    const Domain<d>& domain = solution.domain;
    if (domain.shape == Domain<d>::Shape::annulus)
      return has_rings(study) ? polar_surface(cloud, domain.inner, domain.outer)
                              : clipped_surface<2>(cloud, annulus_shape(domain.inner, domain.outer));
  }
  const bool is_box = study.body.shape == "box" && study.body.holes.empty();
  return is_box ? box_surface<d>(cloud) : plumb::surface_of<d>(study.body, cloud);
}

template <int d>
TlsphBody<d> driven_simulation(const Study& study, const Manufactured<d>& solution, double spacing) {
  const Scene scene = scene_of_level(study, driven_walls(study, solution), spacing, end_time(study));
  if constexpr (d == 2) {
    const Domain<d>& domain = solution.domain;
    if (domain.shape == Domain<d>::Shape::annulus) {
      Cloud<2> cloud = has_rings(study)
                           ? polar_cloud(domain.inner, domain.outer, spacing)
                           : shaped_cloud<2>(annulus_shape(domain.inner, domain.outer),
                                             {spacing, study.body.layout, study.body.cloud == "blue-noise",
                                              study.body.jitter, study.body.seed});
      const Surface<2> surface = surface_of<2>(study, solution, cloud);
      return make_tlsph<d>(scene, std::move(cloud), std::optional(surface));
    }
  }
  return make_tlsph<d>(scene);
}

template <int d>
DrivenBody<d> driven_body(const Study& study, const Manufactured<d>& solution, double spacing,
                          const Loading& loading) {
  require_motion(solution);
  if (study.method.scheme == "implicit")
    throw InputError("scheme = \"implicit\" does not follow a motion in time",
                     "it goes from equilibrium to equilibrium", "use scheme = \"tlsph\" or \"mixed\"");
  DrivenBody<d> body{driven_simulation<d>(study, solution, spacing), {}};
  TlsphBody<d>& simulation = body.simulation;
  CurvedSurface<d> curved;
  if (has_curved_surface(study)) curved = curved_surface<d>(study, solution, simulation.solid);
  body.integrator = drive(simulation.solid, simulation.state, simulation.integrator, solution,
                          {study.body.layout, loading.body_force, study.held_band, loading.at_step_start,
                           study.body.shape == "box"},
                          curved);
  return body;
}

template <int d>
NodalValues<d> values_of_body(const Study& study, const Solid<d>& solid, const State<d>& state,
                              const Manufactured<d>& solution) {
  auto values = nodal_values<d>(solid, state, solution.first_piola);
  const double speed = solid.elastic.wave_speed();
  require_same_law<d>(nodal_values<d>(snapshot_of<d>(solid, state, study.material)), values,
                      solid.elastic.density * speed * speed);
  return values;
}

template <int d>
LevelRun<d> run_level(const Study& study, const Manufactured<d>& solution, double spacing,
                      const Loading& loading, Sitting& sitting) {
  if (has_own_body(study.method.scheme))
    return run_scheme_level<d>(study, solution, spacing, loading, sitting);
  const std::clock_t begin = std::clock();
  DrivenBody<d> body = driven_body(study, solution, spacing, loading);
  TlsphBody<d>& simulation = body.simulation;
  Solid<d>& solid = simulation.solid;
  LevelRun<d> out;
  out.level.n = solid.cloud.size();
  out.level.spacing = spacing;
  const std::clock_t cpu = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  const Pace<d> pace(sitting, simulation);
  const RunResult result = run<d>(solid, simulation.state, body.integrator, simulation.control,
                                  [&](const Solid<d>&, const State<d>&) { return pace.tell(), true; });
  out.level.setup_s = static_cast<double>(cpu - begin) / CLOCKS_PER_SEC;
  out.level.cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  out.level.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  out.level.dt = result.dt.first;
  out.level.steps = simulation.state.step;
  out.level.pair_evaluations = body.integrator.workspace->work.pair_evaluations;
  if (result.failure)
    out.level.failure = fmt::format("{} at {:.6g} s", name_of(result.failure->cause), result.failure->time);
  out.values = values_of_body<d>(study, solid, simulation.state, solution);
  if (solid.bonds.mirror) out.walls = solid.bonds.mirror->walls;
  out.cloud = std::move(solid.cloud);
  return out;
}

template <int d>
void measure(const Study& study, const ExactField<d>& exact, LevelRun<d>& run) {
  StudyLevel& level = run.level;
  level.exact = nodal_size<d>(run.cloud, exact);
  if (wants_gauss(study)) level.exact_gauss = gauss_size<d>(run.cloud.box, exact);
  if (level.failure) {
    level.nodal = {nan, nan, nan, nan, nan};
    if (wants_gauss(study)) level.gauss = level.nodal;
    return;
  }
  level.nodal = nodal_norms<d>(run.cloud, run.values, exact);
  if (!wants_gauss(study)) return;
  const Interpolation<d> interpolation{kernel_named<d>(study.method.kernel),
                                       study.method.beta * level.spacing, pair_named(study.method.pair),
                                       run.walls};
  level.gauss = gauss_norms<d>(run.cloud, run.values, exact, interpolation);
}

#define PLUMBLINE_INSTANTIATE(d)                                                                             \
  template Manufactured<d> solution_of<d>(const Study&);                                                     \
  template ExactField<d> exact_field<d>(const Manufactured<d>&, double);                                     \
  template Surface<d> surface_of<d>(const Study&, const Manufactured<d>&, const Cloud<d>&);                  \
  template TlsphBody<d> driven_simulation<d>(const Study&, const Manufactured<d>&, double);                  \
  template DrivenBody<d> driven_body<d>(const Study&, const Manufactured<d>&, double, const Loading&);       \
  template NodalValues<d> values_of_body<d>(const Study&, const Solid<d>&, const State<d>&,                  \
                                            const Manufactured<d>&);                                         \
  template LevelRun<d> run_level<d>(const Study&, const Manufactured<d>&, double, const Loading&, Sitting&); \
  template void measure<d>(const Study&, const ExactField<d>&, LevelRun<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb::mms
