#include "mms/study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mms/level.hpp"

namespace plumb::mms {
namespace {

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

/// Relative work of a level: particles times steps.
double work_of(const Study& study, double spacing) {
  return std::pow(spacing, -study.dimension() - 1);
}

/// Difference to the run with the finite-strain body force; zero where that is the run itself, or where one
/// broke.
template <int d>
LevelRun<d> modelling_error(const Study& study, const Manufactured<d>& solution, const LevelRun<d>& run,
                            Sitting& sitting) {
  LevelRun<d> out = run;
  out.level.failure.reset();
  out.values.assign(run.values.size(), PointValue<d>{});
  if (study.force == "finite-strain" || run.level.failure) return out;
  const LevelRun<d> loaded = run_level<d>(study, solution, run.level.d, true, sitting);
  if (!loaded.level.failure) out.values = difference<d>(run.values, loaded.values);
  return out;
}

/// A level, and with `floor` also the norms of the modelling error and of the exact field there.
template <int d>
Sitting::Json make_level(const Study& study, const Manufactured<d>& solution, double spacing, bool with_floor,
                         Sitting& sitting) {
  const ExactField<d> exact = exact_field<d>(solution, end_time(study));
  const ExactField<d> zero = [](const Vec<d>&) { return PointValue<d>{}; };
  LevelRun<d> run = run_level<d>(study, solution, spacing, study.force == "finite-strain", sitting);
  measure<d>(study, exact, run);
  Sitting::Json made{{"level", json_of(run.level)}};
  if (!with_floor) return made;
  LevelRun<d> floor = modelling_error<d>(study, solution, run, sitting), size = run;
  for (std::size_t i = 0; i < size.values.size(); ++i) size.values[i] = exact(size.cloud.X[i]);
  size.level.failure.reset();
  measure<d>(study, zero, floor);
  measure<d>(study, zero, size);
  made["floor"] = json_of(floor.level);
  made["size"] = json_of(size.level);
  return made;
}

template <int d>
StudyResult run_in(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  const bool loaded = study.force == "finite-strain";
  double total = 0, done = 0;
  for (const double spacing : study.spacings) total += work_of(study, spacing);

  StudyResult result;
  StudyLevel floor, size;  // norms of the modelling error and of the exact field
  const std::size_t floor_level = std::min<std::size_t>(1, study.spacings.size() - 1);
  for (const double spacing : study.spacings) {
    const bool with_floor = result.levels.size() == floor_level;
    const auto part = sitting.part(fmt::format("level {}", spacing), [&] {
      return make_level<d>(study, solution, spacing, with_floor, sitting);
    });
    if (with_floor) floor = level_of(part["floor"]), size = level_of(part["size"]);
    result.levels.push_back(level_of(part["level"]));
    done += work_of(study, spacing);
    if (progress) progress(done / total, fmt::format("d = {:g} m", spacing));
  }
  std::vector<std::string> norms{"l2", "h1", "linf"};
  if (wants_gauss(study)) norms.insert(norms.end(), {"l2_gauss", "h1_gauss"});
  for (const std::string& norm : norms)
    result.fits.push_back(fit_norm(study, norm, result.levels, floor, size));
  if (!loaded)
    result.notes.push_back(
        fmt::format("modelling floor (finite against small strain, measured at d = {:g} m): L2 {:.3g}, "
                    "H1 {:.3g}; levels below ten times that are not fitted",
                    floor.d, floor.nodal.l2, floor.nodal.h1));
  for (const StudyLevel& level : result.levels)
    if (level.failure)
      result.notes.push_back(fmt::format("d = {:g} m: unstable, {}", level.d, *level.failure));
  result.status = status_of(result.fits);
  return result;
}

}  // namespace

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

double norm_of(const StudyLevel& level, const std::string& norm) {
  if (norm == "l2") return level.nodal.l2;
  if (norm == "h1") return level.nodal.h1;
  if (norm == "linf") return level.nodal.linf;
  return norm == "l2_gauss" ? level.gauss->l2 : level.gauss->h1;
}

StudyResult run_study(const Study& study, const StudyProgress& progress, Sitting& sitting) {
  if (study.dimension() == 2) return run_in<2>(study, progress, sitting);
  if (study.dimension() == 3) return run_in<3>(study, progress, sitting);
  throw InputError(fmt::format("a study in {} dimensions", study.dimension()), "solutions exist in 2D and 3D",
                   "Give body.size two or three entries.");
}

}  // namespace plumb::mms
