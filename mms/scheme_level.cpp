#include "mms/scheme_level.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>

#include "lib/scene/scheme_simulation.hpp"
#include "mms/drive.hpp"

namespace plumb::mms {
namespace {

/// The solution at the start, and what drives a body along it.
template <int d>
SchemeStart<d> start_of(const Study& study, const Manufactured<d>& solution, Cloud<d> cloud,
                        const Loading& loading) {
  const double modulus = solution.density * std::pow(study.material.elastic().wave_speed(), 2);
  const DriveOptions options{study.body.layout, loading.body_force, study.held_band};
  SchemeStart<d> start{{}, actions_of(cloud, modulus, solution, options), {}};
  for (const auto& X : cloud.X) {
    const Motion<d> motion = solution.motion(X, 0);
    start.motion.u.push_back(motion.displacement);
    start.motion.v.push_back(motion.velocity);
  }
  start.cloud = std::move(cloud);
  return start;
}

}  // namespace

template <int d>
NodalValues<d> nodal_values(const Snapshot<d>& shown) {
  NodalValues<d> values(shown.X.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Mat<3>& F = shown.F[i];
    const Mat<3> P = shown.cauchy[i] * cofactor<3, double>(F);
    values[i] = {shown.u[i], F.topLeftCorner<d, d>() - Mat<d>::Identity(), shown.v[i],
                 P.topLeftCorner<d, d>()};
  }
  return values;
}

template <int d>
LevelRun<d> run_scheme_level(const Study& study, const Manufactured<d>& solution, double spacing,
                             const Loading& loading, Sitting& sitting) {
  require_motion(solution);
  const std::clock_t begin = std::clock();
  const Scene scene = scene_of_level(study, spacing);
  LevelRun<d> out;
  out.cloud = make_cloud<d>(scene.body);
  Simulation<d> simulation =
      make_scheme_simulation<d>(scene, start_of<d>(study, solution, out.cloud, loading));
  out.level.n = out.cloud.size();
  out.level.spacing = spacing;
  const std::clock_t cpu = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  RunRecord record;
  const RunResult result = run<d>(
      simulation,
      [&] {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - wall;
        sitting.check(simulation.steps.now().time / *scene.end_time,
                      static_cast<double>(simulation.counts().work.pair_evaluations) / elapsed.count());
        return true;
      },
      record);
  out.level.setup_s = static_cast<double>(cpu - begin) / CLOCKS_PER_SEC;
  out.level.cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  out.level.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  out.level.dt = result.dt.first;
  out.level.steps = simulation.steps.now().step;
  out.level.pair_evaluations = simulation.counts().work.pair_evaluations;
  if (result.failure)
    out.level.failure = fmt::format("{} at {:.6g} s", name_of(result.failure->cause), result.failure->time);
  out.values = nodal_values<d>(simulation.snapshot());
  return out;
}

template NodalValues<1> nodal_values<1>(const Snapshot<1>&);
template NodalValues<2> nodal_values<2>(const Snapshot<2>&);
template NodalValues<3> nodal_values<3>(const Snapshot<3>&);
template LevelRun<1> run_scheme_level<1>(const Study&, const Manufactured<1>&, double, const Loading&,
                                         Sitting&);
template LevelRun<2> run_scheme_level<2>(const Study&, const Manufactured<2>&, double, const Loading&,
                                         Sitting&);
template LevelRun<3> run_scheme_level<3>(const Study&, const Manufactured<3>&, double, const Loading&,
                                         Sitting&);

}  // namespace plumb::mms
