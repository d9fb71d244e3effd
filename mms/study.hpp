#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/convergence/verdict.hpp"
#include "lib/output/sitting.hpp"
#include "lib/scene/study.hpp"
#include "mms/study_level.hpp"

namespace plumb::mms {

/// The order in one norm. With a declared order there is a verdict, without one a trend.
struct StudyFit {
  std::string norm;  ///< one of norms_of()
  OrderFit fit;
  std::optional<double> declared;
  double modelling_floor = 0;  ///< unit of the norm
  std::string verdict;
};

/// Holds the errors and costs of all levels, with their orders and verdicts.
struct StudyResult {
  std::vector<StudyLevel> levels;
  std::vector<StudyFit> fits;
  std::string status;  ///< of plumb::status_of() from all fits
  std::vector<std::string> notes;
};

/// Called now and then with the share of the work that is done.
using StudyProgress = Sitting::Listener;

/// The order that a study declares in a norm of norms_of(), if any.
std::optional<double> declared_order(const Study& study, std::string_view norm);

/// Runs every level and judges the orders: solution_of, then for every spacing run_level (scheme "tlsph": driven_body and
/// run() of its body; any other: run_scheme_level by make_scheme_simulation), measure, and fit_order over the norms. With force = "none" the difference to the run with the
/// finite-strain body force is measured on the second level: it is the modelling floor, which no refinement
/// reduces. Each level is a part of the sitting. Throws InputError if the solution does not fit the study
/// (dimension, parameters, box), SittingEnded if the sitting ends.
StudyResult run_study(const Study& study, const StudyProgress& progress, Sitting& sitting);
/// Runs the study in one sitting.
inline StudyResult run_study(const Study& study, const StudyProgress& progress = {}) {
  Sitting whole;
  return run_study(study, progress, whole);
}

/// Work of a level relative to that of another level or method: particles times evaluations.
double work_of(const Study& study, double spacing);

/// Judges a fit: the verdict against a declared order, the trend where none is declared.
std::string verdict_of(const OrderFit& fit, std::optional<double> declared);

/// Status of a study from its fits, as in StudyResult.
std::string status_of(const std::vector<StudyFit>& fits);

/// Names of the norms that a study measures: l2, h1, linf, velocity_l2, stress_l2 by particles, and the same
/// with "_gauss" behind them if it wants Gauss points.
std::vector<std::string> norms_of(const Study& study);

/// One norm of the error of a level by its name, absolute.
double norm_of(const StudyLevel& level, const std::string& norm);

/// Returns that norm of the exact field: error over size is the relative error (not finite where the field is
/// zero). Orders are fitted to absolute errors; those of relative ones differ by the quadrature of the size
/// only.
double size_of(const StudyLevel& level, const std::string& norm);

}  // namespace plumb::mms
