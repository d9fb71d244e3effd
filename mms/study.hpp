#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mms/norms.hpp"
#include "plumbline/convergence/verdict.hpp"
#include "plumbline/scene/study.hpp"

namespace plumb::mms {

/// One run of a refinement study.
struct StudyLevel {
  Index n = 0;    ///< particles
  double d = 0;   ///< spacing [m]
  double dt = 0;  ///< first time step [s]
  long steps = 0;
  ErrorNorms nodal;                 ///< NaN if the run failed
  std::optional<ErrorNorms> gauss;  ///< by the paper's quadrature, if asked for
  double cpu_s = 0, wall_s = 0;     ///< of the time steps, without set-up
  std::int64_t pair_evaluations = 0;
  std::optional<std::string> failure;  ///< cause and time, if the run became unstable
};

/// The order in one norm. With a declared order there is a verdict, without one a trend.
struct StudyFit {
  std::string norm;  ///< l2, h1, linf, l2_gauss, h1_gauss
  OrderFit fit;
  std::optional<double> declared;
  double modelling_floor = 0;  ///< unit of the norm
  std::string verdict;
};

struct StudyResult {
  std::vector<StudyLevel> levels;
  std::vector<StudyFit> fits;
  std::string status;  ///< pass: every declared order passes; fail: one fails; inconclusive: anything else
  std::vector<std::string> notes;
};

/// Called after each level with the share of the work that is done.
using StudyProgress = std::function<void(double fraction, const std::string& note)>;

/// Runs every level and judges the orders. With force = "none" the difference to the run with the
/// finite-strain body force is measured on the second level: it is the modelling floor, which no refinement
/// reduces. Throws InputError if the solution does not fit the study (dimension, parameters, box).
StudyResult run_study(const Study& study, const StudyProgress& progress = {});

/// One norm of a level by its name: l2, h1, linf, l2_gauss, h1_gauss.
double norm_of(const StudyLevel& level, const std::string& norm);

/// End time of the study [s].
double end_time(const Study& study);

}  // namespace plumb::mms
