#include "mms/static_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "lib/core/dimension.hpp"
#include "lib/schemes/tlsph/statics/statics.hpp"
#include "mms/finite_equilibrium.hpp"
#include "mms/level.hpp"
#include "mms/manufactured.hpp"
#include "mms/static_surface.hpp"

namespace plumb::mms {
namespace {

double cpu_now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template <int d>
TlsphBody<d> still_body_of(Study study, const Manufactured<d>& solution, double spacing) {
  if (study.method.projection)
    throw InputError("[projection] in a static study", "it takes the torque off a force and has no stiffness",
                     "Leave it out.");
  study.method.jst = std::nullopt;  // nothing moves
  return driven_simulation<d>(study, solution, spacing);
}

/// Displacements, their sources and the inertia of the solution at every particle.
template <int d>
struct Exact {
  Eigen::VectorXd u, load;
  double unbalanced = 0;  ///< |rho u_tt - Div P| / |rho u_tt|
};

template <int d>
Exact<d> exact_at(const Manufactured<d>& solution, const Cloud<d>& cloud, double time) {
  Exact<d> exact;
  exact.u.resize(d * cloud.size());
  exact.load.resize(d * cloud.size());
  double unbalanced = 0, inertia = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Motion<d> m = solution.motion(cloud.X[i], time);
    const Vec<d> divergence = solution.stress_divergence(m);
    exact.u.template segment<d>(d * i) = m.displacement;
    exact.load.template segment<d>(d * i) = -cloud.V[i] * divergence;
    unbalanced += (solution.density * m.acceleration - divergence).squaredNorm();
    inertia += (solution.density * m.acceleration).squaredNorm();
  }
  exact.unbalanced = std::sqrt(unbalanced / inertia);
  return exact;
}

/// The equilibrium is that of finite strains: scheme "implicit".
bool finite(const Study& study) {
  return study.method.scheme == "implicit";
}

template <int d>
Eigen::VectorXd linear_equilibrium(const Study& study, const Solid<d>& solid, const Linearised& body,
                                   Exact<d>& exact, const Manufactured<d>& solution, double time) {
  const std::vector<Prescribed> prescribed =
      surface_conditions<d>(study, solution, solid, time, exact.u, exact.load);
  return equilibrium(body.stiffness, exact.load, prescribed);
}

template <int d>
void measure_equilibrium(const Study& study, const Solid<d>& solid, const Eigen::VectorXd& found,
                         const Manufactured<d>& solution, double time, StaticLevel& level) {
  const Cloud<d>& cloud = solid.cloud;
  State<d> state = make_state(solid);
  for (Index i = 0; i < cloud.size(); ++i)
    set_vector<d>(state.u, solid.bonds.slots.of(i), found.template segment<d>(d * i));
  const ExactField<d> field = [&](const Vec<d>& X) -> PointValue<d> {
    const Motion<d> m = solution.motion(X, time);
    return {m.displacement, m.F - Mat<d>::Identity(), Vec<d>::Zero(), solution.first_piola(m.F)};
  };
  const NodalValues<d> values = values_of_body<d>(study, solid, state, solution);
  level.error = nodal_norms<d>(cloud, values, field);
  level.exact = nodal_size<d>(cloud, field);
}

/// Above this the solution needs a body force: an amplitude of 1e-3 of the body leaves about as much.
constexpr double balanced = 1e-3;
/// The guess is set apart from the exact frequency, where a perfect scheme would make the matrix singular.
constexpr double guess = 0.99;

template <int d>
StaticLevel run_level(const Study& study, const Manufactured<d>& solution, double spacing) {
  StaticLevel level;
  const double start = cpu_now();
  TlsphBody<d> simulation = still_body_of<d>(study, solution, spacing);
  const Solid<d>& solid = simulation.solid;
  if (simulation.compatible && !simulation.compatible->closed_form)
    level.projection = {simulation.compatible->divergence_defect, simulation.compatible->residual};
  level.setup_s = cpu_now() - start;
  level.n = solid.cloud.size();
  level.spacing = spacing;
  const double time = end_time(study);
  if (finite(study)) {
    measure_equilibrium(study, solid, finite_equilibrium(study, simulation, solution, time), solution, time,
                        level);
    level.solve_s = cpu_now() - start - level.setup_s;
    return level;
  }
  Exact<d> exact = exact_at(solution, solid.cloud, time);
  const Linearised body = linearise(solid);
  measure_equilibrium(study, solid, linear_equilibrium(study, solid, body, exact, solution, time), solution,
                      time, level);
  if (!solution.still && exact.unbalanced < balanced) {
    const double omega = 2 * std::acos(-1.0) / solution.period;
    try {
      const Vibration found =
          vibration_near(body, guess * omega, exact.u, held_unknowns(solid.cloud, solution.domain));
      level.frequency_error = found.angular_frequency / omega - 1;
    } catch (const InputError&) {
      throw;
    } catch (const std::runtime_error& error) {  // a force without potential may have no such mode
      level.failure = error.what();
    }
  }
  level.solve_s = cpu_now() - start - level.setup_s;
  return level;
}

StudyFit fit_of(std::string_view norm, const std::vector<Level>& errors, std::optional<double> declared) {
  StudyFit out;
  out.norm = norm;
  out.declared = declared;
  out.fit = fit_order(errors);
  out.verdict = verdict_of(out.fit, declared);
  return out;
}

std::vector<StudyFit> fits_of(const Study& study, const std::vector<StaticLevel>& levels) {
  std::vector<StudyFit> fits;
  for (const NormName& norm : static_norms()) {
    std::vector<Level> errors;
    for (const StaticLevel& level : levels) errors.push_back({level.spacing, level.relative(norm.value)});
    fits.push_back(fit_of(norm.name, errors, declared_order(study, norm.name)));
  }
  std::vector<Level> frequency;
  for (const StaticLevel& level : levels)
    if (level.frequency_error) frequency.push_back({level.spacing, *level.frequency_error});
  if (frequency.size() == levels.size()) fits.push_back(fit_of("frequency", frequency, std::nullopt));
  return fits;
}

template <int d>
StaticResult run_static_in(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  const bool box = solution.domain.shape == Domain<d>::Shape::box;
  if (study.body.layout != Layout::node || !(box || solution.still || finite(study)))
    throw InputError(
        "a static study needs particles on the surface of a box, or a solution at rest",
        "displacements are prescribed there",
        "Use layout = \"node\" and a solution on a box, one that is at rest, or scheme = \"implicit\".");
  StaticResult result;
  for (const double spacing : study.spacings) {
    result.levels.push_back(sitting.value<StaticLevel>(
        fmt::format("level {}", spacing), [&] { return run_level<d>(study, solution, spacing); }));
    if (progress)
      progress(static_cast<double>(result.levels.size()) / static_cast<double>(study.spacings.size()),
               fmt::format("d = {:g} m", spacing));
  }
  result.fits = fits_of(study, result.levels);
  result.status = status_of(result.fits);
  return result;
}

}  // namespace

std::vector<NormName> static_norms() {
  std::vector<NormName> norms;
  for (const NormName& norm : norm_names)
    if (norm.value != &ErrorNorms::velocity_l2) norms.push_back(norm);
  return norms;
}

StaticResult run_static_study(const Study& given, const StudyProgress& progress, Sitting& sitting) {
  Study study = given;
  study.quadrature = "nodal";  // the only norms that there are
  return with_dimension(study.dimension(),
                        [&]<int d>() { return run_static_in<d>(study, progress, sitting); });
}

}  // namespace plumb::mms
