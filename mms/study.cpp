#include "mms/study.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include "mms/annulus.hpp"
#include "mms/drive.hpp"
#include "plumbline/dissipation/jst.hpp"
#include "plumbline/scene/simulation.hpp"

namespace plumb::mms {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Elastic elastic_of(const Study& study) {
  return {study.material.young, study.material.poisson, study.material.density};
}

template <int d>
Manufactured<d> solution_of(const Study& study) {
  return manufactured<d>(study.solution, study.parameters, elastic_of(study), study.material.model);
}

bool wants_gauss(const Study& study) {
  return study.quadrature != "nodal";
}
bool wants_nodal(const Study& study) {
  return study.quadrature != "gauss";
}

/// The box of the study must be the solution's domain: its face conditions hold nowhere else.
template <int d>
void check_domain(const Study& study, const Manufactured<d>& solution) {
  const Domain<d>& domain = solution.domain;
  if (domain.shape != Domain<d>::Shape::box && wants_gauss(study))
    throw InputError(fmt::format("Gauss norms of {}", solution.name),
                     "its domain is an annulus, the tiles are boxes", "Use quadrature = \"nodal\".");
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

/// The scene of one level, without boundaries and initial state: those come from the solution.
Scene scene_of(const Study& study, double spacing, double end) {
  Scene scene;
  scene.name = study.name;
  scene.dimension = study.dimension();
  scene.end_time = end;
  scene.body = with_spacing(study.body, spacing);
  scene.material = study.material;
  scene.method = study.method;
  scene.jst = study.jst;
  scene.hourglass = study.hourglass;
  return scene;
}

/// Boxes are built as in any scene; annuli as rings (layout node) or as a clipped lattice (layout cell).
template <int d>
Simulation<d> simulation_of(const Study& study, const Manufactured<d>& solution, double spacing) {
  const Scene scene = scene_of(study, spacing, end_time(study));
  if constexpr (d == 2) {
    const Domain<d>& domain = solution.domain;
    if (domain.shape == Domain<d>::Shape::annulus) {
      const auto make = study.body.layout == Layout::node ? &polar_cloud : &clipped_cloud;
      return make_simulation<d>(scene, make(domain.inner, domain.outer, spacing));
    }
  }
  return make_simulation<d>(scene);
}

template <int d>
struct LevelRun {
  StudyLevel level;
  Cloud<d> cloud;
  NodalValues<d> values;
};

template <int d>
LevelRun<d> run_level(const Study& study, const Manufactured<d>& solution, double spacing, bool body_force) {
  Simulation<d> simulation = simulation_of(study, solution, spacing);
  Solid<d>& solid = simulation.solid;
  const Stepper<d> stepper = drive(solid, simulation.state, simulation.stepper, solution,
                                   {study.body.layout, body_force, study.held_band});
  LevelRun<d> out;
  out.level.n = solid.cloud.size();
  out.level.d = spacing;
  const std::clock_t cpu = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  const RunResult result = run(solid, simulation.state, stepper, simulation.control);
  out.level.cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  out.level.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  out.level.dt = result.dt.first;
  out.level.steps = simulation.state.step;
  out.level.pair_evaluations = solid.work.pair_evaluations;
  if (result.failure)
    out.level.failure = fmt::format("{} at {:.6g} s", name_of(result.failure->cause), result.failure->time);
  out.values = nodal_values(solid, simulation.state);
  out.cloud = std::move(solid.cloud);
  return out;
}

/// The norms of a field against the exact one; NaN for a broken run.
template <int d>
void measure(const Study& study, const ExactField<d>& exact, LevelRun<d>& run) {
  StudyLevel& level = run.level;
  if (level.failure) {
    level.nodal = {nan, nan, nan};
    if (wants_gauss(study)) level.gauss = level.nodal;
    return;
  }
  level.nodal = nodal_norms<d>(run.cloud, run.values, exact);
  if (!wants_gauss(study)) return;
  const Interpolation<d> interpolation{kernel_named<d>(study.method.kernel), study.method.beta * level.d,
                                       pair_named(study.method.pair)};
  level.gauss = gauss_norms<d>(run.cloud, run.values, exact, interpolation);
}

StudyFit fit_norm(const Study& study, const std::string& norm, const std::vector<StudyLevel>& levels,
                  const StudyLevel& floor, const StudyLevel& size) {
  StudyFit out;
  out.norm = norm;
  std::vector<Level> errors;
  for (const StudyLevel& level : levels) errors.push_back({level.d, norm_of(level, norm)});
  FitOptions options;
  options.modelling_floor = out.modelling_floor = norm_of(floor, norm);
  options.round_off *= norm_of(size, norm);
  out.fit = fit_order(errors, options);
  const bool gauss = norm.ends_with("_gauss");
  if (study.expect && (gauss ? wants_gauss(study) : wants_nodal(study)))
    out.declared = norm.starts_with("l2")   ? study.expect->l2
                   : norm.starts_with("h1") ? study.expect->h1
                                            : std::nullopt;
  out.verdict = out.declared ? name_of(judge(out.fit, *out.declared)) : name_of(classify(out.fit));
  return out;
}

std::string status_of(const std::vector<StudyFit>& fits) {
  bool all_pass = true, any = false;
  for (const StudyFit& fit : fits) {
    if (!fit.declared) continue;
    any = true;
    if (fit.verdict == name_of(Verdict::fail)) return "fail";
    all_pass = all_pass && fit.verdict == name_of(Verdict::pass);
  }
  return any && all_pass ? "pass" : "inconclusive";
}

/// Relative work of a level: particles times steps.
double work_of(const Study& study, double spacing) {
  return std::pow(spacing, -study.dimension() - 1);
}

/// Difference to the run with the finite-strain body force; zero where that is the run itself, or where one
/// broke.
template <int d>
LevelRun<d> modelling_error(const Study& study, const Manufactured<d>& solution, const LevelRun<d>& run) {
  LevelRun<d> out = run;
  out.level.failure.reset();
  out.values.assign(run.values.size(), PointValue<d>{});
  if (study.force == "finite-strain" || run.level.failure) return out;
  const LevelRun<d> loaded = run_level<d>(study, solution, run.level.d, true);
  if (!loaded.level.failure) out.values = difference<d>(run.values, loaded.values);
  return out;
}

template <int d>
StudyResult run_in(const Study& study, const StudyProgress& progress) {
  const Manufactured<d> solution = solution_of<d>(study);
  check_domain(study, solution);
  const double end = end_time(study);
  const ExactField<d> exact = [&](const Vec<d>& X) -> PointValue<d> {
    const Motion<d> motion = solution.motion(X, end);
    return {motion.displacement, motion.F - Mat<d>::Identity()};
  };
  const ExactField<d> zero = [](const Vec<d>&) { return PointValue<d>{}; };
  const bool loaded = study.force == "finite-strain";
  double total = 0, done = 0;
  for (const double spacing : study.spacings) total += work_of(study, spacing);

  StudyResult result;
  LevelRun<d> floor, size;  // the modelling error and the exact field
  const std::size_t floor_level = std::min<std::size_t>(1, study.spacings.size() - 1);
  for (const double spacing : study.spacings) {
    LevelRun<d> run = run_level<d>(study, solution, spacing, loaded);
    measure<d>(study, exact, run);
    if (result.levels.size() == floor_level) {
      floor = modelling_error<d>(study, solution, run);
      size = run;
      for (std::size_t i = 0; i < size.values.size(); ++i) size.values[i] = exact(size.cloud.X[i]);
      size.level.failure.reset();
      measure<d>(study, zero, floor);
      measure<d>(study, zero, size);
    }
    result.levels.push_back(run.level);
    done += work_of(study, spacing);
    if (progress) progress(done / total, fmt::format("d = {:g} m", spacing));
  }
  std::vector<std::string> norms{"l2", "h1", "linf"};
  if (wants_gauss(study)) norms.insert(norms.end(), {"l2_gauss", "h1_gauss"});
  for (const std::string& norm : norms)
    result.fits.push_back(fit_norm(study, norm, result.levels, floor.level, size.level));
  if (!loaded)
    result.notes.push_back(
        fmt::format("modelling floor (finite against small strain, measured at d = {:g} m): L2 {:.3g}, "
                    "H1 {:.3g}; levels below ten times that are not fitted",
                    floor.level.d, floor.level.nodal.l2, floor.level.nodal.h1));
  for (const StudyLevel& level : result.levels)
    if (level.failure)
      result.notes.push_back(fmt::format("d = {:g} m: unstable, {}", level.d, *level.failure));
  result.status = status_of(result.fits);
  return result;
}

}  // namespace

double norm_of(const StudyLevel& level, const std::string& norm) {
  if (norm == "l2") return level.nodal.l2;
  if (norm == "h1") return level.nodal.h1;
  if (norm == "linf") return level.nodal.linf;
  return norm == "l2_gauss" ? level.gauss->l2 : level.gauss->h1;
}

double end_time(const Study& study) {
  if (study.time) return *study.time;
  return *study.periods *
         (study.dimension() == 2 ? solution_of<2>(study).period : solution_of<3>(study).period);
}

StudyResult run_study(const Study& study, const StudyProgress& progress) {
  if (study.dimension() == 2) return run_in<2>(study, progress);
  if (study.dimension() == 3) return run_in<3>(study, progress);
  throw InputError(fmt::format("a study in {} dimensions", study.dimension()), "solutions exist in 2D and 3D",
                   "Give body.size two or three entries.");
}

}  // namespace plumb::mms
