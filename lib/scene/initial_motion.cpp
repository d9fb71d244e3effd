#include "lib/scene/initial_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/geometry/position_text.hpp"
#include "lib/scene/actions_of_scene.hpp"

namespace plumb {
namespace {

/// A closed body whose total energy doubles is unstable beyond doubt: the paper's scheme gains at most a
/// tenth.
constexpr double closed_energy_bound = 1.0;

/// Of a whole box without the rounding of a sum.
template <int d>
Vec<d> centre_of_mass(const Cloud<d>& cloud, const Body& body) {
  if (body.shape == "box" && body.holes.empty()) return cloud.box.origin + 0.5 * cloud.box.size;
  Vec<d> moment = Vec<d>::Zero();
  double volume = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    moment += cloud.V[i] * cloud.X[i];
    volume += cloud.V[i];
  }
  return moment / volume;
}

}  // namespace

template <int d>
InitialMotion<d> initial_motion(const Scene& scene, const Cloud<d>& cloud) {
  InitialMotion<d> start;
  if (!scene.initial) return start;
  if (!scene.initial->displacement.empty())
    for (const auto& X : cloud.X) start.u.push_back(evaluate_at<d>(scene.initial->displacement, X));
  if (scene.initial->temperature)
    for (const auto& X : cloud.X) {
      const double T = scene.initial->temperature->at(coordinates_of(X), 0);
      if (!(T >= 0 && std::isfinite(T)))
        throw InputError(fmt::format("[initial] temperature is {:g} K at {}", T, position_text<d>(X)),
                         "an absolute temperature is not negative", "mend the formula");
      start.temperature.push_back(T);
    }
  if (scene.initial->velocity.empty() && !scene.initial->spin) return start;
  const Vec<d> centre = centre_of_mass(cloud, scene.body);
  for (const auto& X : cloud.X) {
    if (!scene.initial->spin) {
      start.v.push_back(evaluate_at<d>(scene.initial->velocity, X));
      continue;
    }
    const auto& w = *scene.initial->spin;
    Vec<3> arm = Vec<3>::Zero();
    arm.template head<d>() = X - centre;
    const Vec<3> cross(w[1] * arm[2] - w[2] * arm[1], w[2] * arm[0] - w[0] * arm[2],
                       w[0] * arm[1] - w[1] * arm[0]);
    start.v.push_back(cross.template head<d>());
  }
  return start;
}

namespace {

double longest_ramp(const Scene& scene) {
  double longest = scene.load ? scene.load->ramp.value_or(0) : 0;
  for (const auto& boundary : scene.boundaries) longest = std::max(longest, boundary.ramp.value_or(0));
  return longest;
}

}  // namespace

StepControl step_control(const Scene& scene) {
  StepControl control;
  if (scene.method.cfl) control.cfl = *scene.method.cfl;
  control.fixed_step = scene.method.time_step;
  control.wave_speed = wave_speed_named(scene.method.wave_speed);
  control.end_time = scene.end_time;
  if (scene.relaxation) control.rest = scene.relaxation->residual;
  control.rest_after = longest_ramp(scene);
  control.max_steps = scene.max_steps;
  if (scene.output && (scene.output->series || scene.output->vtk)) control.interval = scene.output->every;
  bool driven = scene.load.has_value();
  for (const auto& boundary : scene.boundaries)
    driven = driven || (boundary.kind != BoundaryKind::clamped && boundary.kind != BoundaryKind::roller);
  if (!driven && scene.initial) control.energy_bound = closed_energy_bound;
  return control;
}

template InitialMotion<1> initial_motion<1>(const Scene&, const Cloud<1>&);
template InitialMotion<2> initial_motion<2>(const Scene&, const Cloud<2>&);
template InitialMotion<3> initial_motion<3>(const Scene&, const Cloud<3>&);

}  // namespace plumb
