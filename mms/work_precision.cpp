#include "mms/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lib/core/dimension.hpp"
#include "lib/core/sentences.hpp"
#include "mms/level.hpp"

namespace plumb::mms {
namespace {

/// One run of a level, or why there is none.
struct TimedRun {
  std::optional<StudyLevel> level;
  std::optional<std::string> refused;

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("level", self.level);
    visit("refused", self.refused);
  }
};

/// One run of a level; the first one with its norms and those of the exact field.
template <int d>
StudyLevel run_of(const Study& study, double spacing, bool warm_up, Sitting& sitting) {
  const Manufactured<d> solution = solution_of<d>(study);
  LevelRun<d> run = run_level<d>(study, solution, spacing, loading_of(study), sitting);
  if (warm_up) measure<d>(study, exact_field<d>(solution, end_time(study)), run);
  return run.level;
}

template <int d>
TimedRun make_run(const Study& study, double spacing, bool warm_up, Sitting& sitting) {
  try {
    return {run_of<d>(study, spacing, warm_up, sitting), {}};
  } catch (const InputError& error) {
    return {{}, sentences(error.problem(), error.why(), "")};
  }
}

/// Puts what a run measured into the point: the least time, and the span to the slowest.
void count(const TimedRun& run, WorkPoint& point, bool warm_up) {
  if (run.refused) {
    point.refused = true;
    point.failure = run.refused;
    point.error = point.cpu_s = point.wall_s = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const StudyLevel& level = run.level.value();
  if (warm_up) {
    point.error = level.nodal.l2 / level.exact.l2;
    point.failure = level.failure;
    point.pair_evaluations = level.pair_evaluations;
    point.cpu_s = point.wall_s = std::numeric_limits<double>::max();
    return;
  }
  const double slowest = std::max(
      point.cpu_s == std::numeric_limits<double>::max() ? 0 : point.cpu_s + point.cpu_spread_s, level.cpu_s);
  point.cpu_s = std::min(point.cpu_s, level.cpu_s);
  point.cpu_spread_s = slowest - point.cpu_s;
  point.wall_s = std::min(point.wall_s, level.wall_s);
}

void run_once(const Contender& variant, int turn, WorkPoint& point, Sitting& sitting) {
  const auto make = [&] {
    return with_dimension(variant.study.dimension(), [&]<int d>() {
      return make_run<d>(variant.study, point.spacing, turn == 0, sitting);
    });
  };
  const auto run =
      sitting.value<TimedRun>(fmt::format("turn {}, {}, d = {} m", turn, variant.label, point.spacing), make,
                              work_of(variant.study, point.spacing));
  count(run, point, turn == 0);
}

using CostAndError = std::pair<double, double>;

double cost_of(const WorkPoint& point, bool cpu) {
  return cpu ? point.cpu_s : static_cast<double>(point.pair_evaluations);
}

/// Cost of an error on one variant's levels, coarse to fine; nothing if its finest error is above.
std::optional<double> cost_at(double error, const std::vector<CostAndError>& levels) {
  std::optional<CostAndError> coarser;
  for (const CostAndError& level : levels) {
    if (!std::isfinite(level.second)) continue;
    if (level.second <= error) {
      if (!coarser) return level.first;
      const double share = std::log(coarser->second / error) / std::log(coarser->second / level.second);
      return coarser->first * std::pow(level.first / coarser->first, share);
    }
    coarser = level;
  }
  return std::nullopt;
}

void find_cheapest(WorkPrecision& result, const std::vector<double>& errors, bool cpu) {
  for (const double error : errors) {
    std::optional<Cheapest> best;
    for (std::size_t v = 0; v < result.labels.size(); ++v) {
      std::vector<CostAndError> levels;
      for (const WorkPoint& point : result.points)
        if (point.variant == v) levels.emplace_back(cost_of(point, cpu), point.error);
      const auto cost = cost_at(error, levels);
      if (cost && (!best || *cost < best->cost)) best = {error, cpu ? "cpu_s" : "pair_evaluations", v, *cost};
    }
    if (best) result.cheapest.push_back(*best);
  }
}

void mark_front(WorkPrecision& result, bool cpu) {
  std::vector<CostAndError> points;
  for (const WorkPoint& point : result.points) points.emplace_back(cost_of(point, cpu), point.error);
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t k = 0; k < points.size(); ++k)
    (cpu ? result.points[k].front_cpu : result.points[k].front_work) = front[k];
}

}  // namespace

std::vector<bool> pareto_front(const std::vector<CostAndError>& points) {
  const auto finite = [](const CostAndError& p) { return std::isfinite(p.first) && std::isfinite(p.second); };
  std::vector<bool> front;
  front.reserve(points.size());
  for (const auto& p : points)
    front.push_back(finite(p) && std::none_of(points.begin(), points.end(), [&](const CostAndError& q) {
                      return finite(q) && q.first <= p.first && q.second <= p.second && q != p;
                    }));
  return front;
}

WorkPrecision work_precision(const std::vector<Contender>& variants, int repeats,
                             const std::vector<double>& errors, const StudyProgress& progress,
                             Sitting& sitting) {
  WorkPrecision result;
  const int turns = 1 + std::max(1, repeats);
  double work = 0;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    result.labels.push_back(variants[v].label);
    for (const double d : variants[v].study.spacings) {
      WorkPoint point;
      point.variant = v;
      point.spacing = d;
      result.points.push_back(point);
      work += turns * work_of(variants[v].study, d);
    }
  }
  sitting.tell(work, progress, "pair evaluations");
  for (int turn = 0; turn < turns; ++turn)
    for (WorkPoint& point : result.points) run_once(variants[point.variant], turn, point, sitting);
  if (std::ranges::all_of(result.points, &WorkPoint::refused))
    throw InputError("no level of the study can be built", result.points.front().failure.value_or(""), "");
  for (const bool cpu : {true, false}) {
    mark_front(result, cpu);
    find_cheapest(result, errors, cpu);
  }
  return result;
}

}  // namespace plumb::mms
