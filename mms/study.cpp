#include "mms/study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/dimension.hpp"
#include "mms/level.hpp"

namespace plumb::mms {
namespace {

constexpr std::string_view gauss_suffix = "_gauss";

StudyFit fit_norm(const Study& study, const std::string& norm, const std::vector<StudyLevel>& levels,
                  const StudyLevel& floor) {
  StudyFit out;
  out.norm = norm;
  std::vector<Level> errors;
  errors.reserve(levels.size());
  for (const StudyLevel& level : levels) errors.push_back({level.spacing, norm_of(level, norm)});
  FitOptions options;
  options.modelling_floor = out.modelling_floor = norm_of(floor, norm);
  options.round_off *= size_of(levels.back(), norm);
  out.fit = fit_order(errors, options);
  const bool gauss = norm.ends_with(gauss_suffix);
  if (gauss ? wants_gauss(study) : wants_nodal(study))
    out.declared = declared_order(study, norm.substr(0, norm.size() - (gauss ? gauss_suffix.size() : 0)));
  out.verdict = verdict_of(out.fit, out.declared);
  return out;
}

/// The norm of that name among those by particles and those by Gauss points.
double value_of(const ErrorNorms& nodal, const std::optional<ErrorNorms>& gauss, std::string_view norm) {
  const bool by_gauss = norm.ends_with(gauss_suffix);
  if (by_gauss) norm.remove_suffix(gauss_suffix.size());
  for (const NormName& known : norm_names)
    if (known.name == norm) return (by_gauss ? gauss.value() : nodal).*known.value;
  throw unknown_name("norm", norm, {});
}

/// Difference to the run with the finite-strain body force; zero where that is the run itself, or where one
/// broke.
template <int d>
LevelRun<d> modelling_error(const Study& study, const Manufactured<d>& solution, const LevelRun<d>& run,
                            Sitting& sitting) {
  LevelRun<d> out = run;
  out.level.failure.reset();
  out.values.assign(run.values.size(), PointValue<d>{});
  if (loading_of(study).body_force || run.level.failure) return out;
  const LevelRun<d> loaded = run_level<d>(study, solution, run.level.spacing, {.body_force = true}, sitting);
  if (!loaded.level.failure) out.values = difference<d>(run.values, loaded.values);
  return out;
}

/// A level, and on one of them also the norms of the modelling error.
struct MeasuredLevel {
  StudyLevel level;
  std::optional<StudyLevel> floor;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("level", self.level);
    visit("floor", self.floor);
  }
};

template <int d>
MeasuredLevel make_level(const Study& study, const Manufactured<d>& solution, double spacing, bool with_floor,
                         Sitting& sitting) {
  LevelRun<d> run = run_level<d>(study, solution, spacing, loading_of(study), sitting);
  measure<d>(study, exact_field<d>(solution, end_time(study)), run);
  MeasuredLevel made{run.level, {}};
  if (!with_floor) return made;
  LevelRun<d> floor = modelling_error<d>(study, solution, run, sitting);
  measure<d>(
      study, [](const Vec<d>&) { return PointValue<d>{}; }, floor);
  made.floor = floor.level;
  return made;
}

template <int d>
StudyResult run_in(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  const bool loaded = loading_of(study).body_force;
  double work = 0;
  for (const double spacing : study.spacings) work += work_of(study, spacing);
  sitting.tell(work, progress, "pair evaluations");

  StudyResult result;
  StudyLevel floor;  // norms of the modelling error
  const std::size_t floor_level = std::min<std::size_t>(1, study.spacings.size() - 1);
  for (const double spacing : study.spacings) {
    const bool with_floor = result.levels.size() == floor_level;
    const auto make = [&] { return make_level<d>(study, solution, spacing, with_floor, sitting); };
    const auto made =
        sitting.value<MeasuredLevel>(fmt::format("d = {} m", spacing), make, work_of(study, spacing));
    if (made.floor) floor = *made.floor;
    result.levels.push_back(made.level);
  }
  for (const std::string& norm : norms_of(study))
    result.fits.push_back(fit_norm(study, norm, result.levels, floor));
  if (!loaded)
    result.notes.push_back(
        fmt::format("modelling floor (finite against small strain, measured at d = {:g} m): L2 {:.3g}, "
                    "H1 {:.3g}; levels below ten times that are not fitted",
                    floor.spacing, floor.nodal.l2, floor.nodal.h1));
  for (const StudyLevel& level : result.levels)
    if (level.failure)
      result.notes.push_back(fmt::format("d = {:g} m: unstable, {}", level.spacing, *level.failure));
  result.status = status_of(result.fits);
  return result;
}

}  // namespace

std::optional<double> declared_order(const Study& study, std::string_view norm) {
  if (!study.expect) return std::nullopt;
  if (norm == "l2") return study.expect->l2;
  if (norm == "h1") return study.expect->h1;
  if (norm == "velocity_l2") return study.expect->velocity_l2;
  return norm == "stress_l2" ? study.expect->stress_l2 : std::nullopt;
}

std::string verdict_of(const OrderFit& fit, std::optional<double> declared) {
  return std::string(declared ? name_of(judge(fit, *declared)) : name_of(classify(fit)));
}

std::string status_of(const std::vector<StudyFit>& fits) {
  std::vector<Judged> judged;
  judged.reserve(fits.size());
  for (const StudyFit& fit : fits) judged.push_back({fit.verdict, fit.declared.has_value()});
  return std::string(plumb::status_of(judged));
}

std::vector<std::string> norms_of(const Study& study) {
  std::vector<std::string> names;
  names.reserve(2 * std::size(norm_names));
  for (const NormName& norm : norm_names) names.emplace_back(norm.name);
  if (wants_gauss(study))
    for (const NormName& norm : norm_names) names.push_back(std::string(norm.name) + "_gauss");
  return names;
}

double norm_of(const StudyLevel& level, const std::string& norm) {
  return value_of(level.nodal, level.gauss, norm);
}

double size_of(const StudyLevel& level, const std::string& norm) {
  return value_of(level.exact, level.exact_gauss, norm);
}

double work_of(const Study& study, double spacing) {
  int evaluations = 1;
  for_each_type(IntegratorCatalogue{}, [&]<class T>(Type<T>) {
    if (T::name == study.method.integrator) evaluations = T::template Integrator<2>::evaluations_per_step;
  });
  const double step = study.method.cfl.value_or(1);
  return evaluations / step * std::pow(spacing, -study.dimension() - (study.method.cfl ? 1 : 0));
}

StudyResult run_study(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  return with_dimension(study.dimension(), [&]<int d>() { return run_in<d>(study, progress, sitting); });
}

}  // namespace plumb::mms
