#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/output/sitting.hpp"
#include "lib/scene/study.hpp"
#include "mms/study.hpp"

namespace plumb::mms {

/// A study under the name of what makes it different from the others.
struct Contender {
  std::string label;
  Study study;
};

/// One level of one variant.
struct WorkPoint {
  std::size_t variant;
  double spacing = 0;                  ///< [m]
  double error = 0;                    ///< nodal L2 norm over that of the exact field; NaN if the run failed
  double cpu_s = 0, cpu_spread_s = 0;  ///< least of the repeats, and how far the slowest was above it
  double wall_s = 0;                   ///< least of the repeats
  std::int64_t pair_evaluations = 0;   ///< the same on every machine
  bool front_cpu = false, front_work = false;  ///< on the Pareto front: no point is as cheap and as accurate
  std::optional<std::string> failure;
  bool refused = false;  ///< nothing ran: the failure says why the body cannot be built
};

/// Which variant reaches an error at the least cost.
struct Cheapest {
  double error;         ///< relative, wanted
  std::string measure;  ///< "cpu_s" or "pair_evaluations"
  std::size_t variant;
  double cost;  ///< in that measure
};

/// Holds errors beside costs of all variants, and which one is cheapest at given errors.
struct WorkPrecision {
  std::vector<std::string> labels;
  std::vector<WorkPoint> points;
  std::vector<Cheapest> cheapest;  ///< none for errors that no variant reaches
};

/// Runs every level of every variant once to warm up and `repeats` times more, alternating between the
/// variants so that a slow minute of the machine does not fall on one of them. Costs between two levels are
/// interpolated in logarithms; nothing is extrapolated to errors below the finest level, and an error above
/// the coarsest level's costs what that level costs. A level that cannot be built is a point without error;
/// throws InputError if that is so for all of them. Each run is a part of the sitting; throws SittingEnded
/// if that ends.
WorkPrecision work_precision(const std::vector<Contender>& variants, int repeats,
                             const std::vector<double>& errors, const StudyProgress& progress,
                             Sitting& sitting);
/// Compares the variants in one sitting.
inline WorkPrecision work_precision(const std::vector<Contender>& variants, int repeats,
                                    const std::vector<double>& errors) {
  Sitting whole;
  return work_precision(variants, repeats, errors, {}, whole);
}

/// For points (cost, error): true where no other point is better in one and as good in the other. Entries
/// that are not finite are never on the front.
std::vector<bool> pareto_front(const std::vector<std::pair<double, double>>& points);

}  // namespace plumb::mms
