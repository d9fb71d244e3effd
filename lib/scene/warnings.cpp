#include "lib/scene/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "lib/core/error.hpp"
#include "lib/kernel/kernel.hpp"

namespace plumb {
namespace {

using Texts = std::vector<std::string>;

bool has_free_face(const Scene& scene) {
  const auto held = std::count_if(scene.boundaries.begin(), scene.boundaries.end(),
                                  [](const Boundary& boundary) { return boundary.face.has_value(); });
  return held < 2 * scene.dimension;
}

/// Evaluates where the formula may not be finite: between particles nobody asked for a value.
std::optional<double> value_at(const Expression& formula, const auto& X) {
  std::array<double, 3> point{0, 0, 0};
  for (int k = 0; k < X.size(); ++k) point[k] = X[k];
  try {
    return formula.at(point);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Sums of a sample, for its spread.
struct Sample {
  double sum = 0, squares = 0, count = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
    count += 1;
  }
  /// Mean square distance from the mean; 0 if that is rounding.
  double variance() const {
    const double spread = squares - sum * sum / count;
    return count > 0 && spread > 1e-24 * squares ? spread / count : 0;
  }
};

/// How far the formula is from linear interpolation at `fraction` of the way along the axis, relative to its
/// spread there (and at the particles, if it is constant there); both root mean squares. 0 if it is linear.
template <int d>
double interpolation_error(const Expression& formula, const Cloud<d>& cloud, int axis, double fraction) {
  constexpr Index most_samples = 2000;  // enough for a mean; formulas are interpreted
  const Index every = std::max<Index>(1, cloud.size() / most_samples);
  double step = cloud.spacing, error = 0;
  if (cloud.line > 0 && cloud.count[axis] > 1) step = cloud.X[cloud.stride[axis]][axis] - cloud.X[0][axis];
  Sample middle, all;
  for (Index i = 0; i < cloud.size(); i += every) {
    Vec<d> next = cloud.X[i], between = cloud.X[i];
    next[axis] += step;
    between[axis] += fraction * step;
    if (next[axis] > cloud.box.origin[axis] + cloud.box.size[axis] + 1e-9 * step) continue;
    const auto a = value_at(formula, cloud.X[i]), b = value_at(formula, next), m = value_at(formula, between);
    if (!a || !b || !m) continue;
    const double off = *m - ((1 - fraction) * *a + fraction * *b);
    error += off * off;
    middle.add(*m);
    all.add(*m);
    all.add(*a);
  }
  const double spread = middle.variance() > 0 ? middle.variance() : all.variance();
  return spread > 0 ? std::sqrt(error / middle.count / spread) : 0;
}

/// The same error of a wave exp(i theta X/d).
double error_of_wave(double theta, double fraction) {
  const std::complex<double> i(0, 1);
  return std::abs(std::exp(i * theta * fraction) - (1 - fraction) - fraction * std::exp(i * theta));
}

}  // namespace

Texts wide_kernel_warnings(const Scene& scene, double radius_over_spacing) {
  if (!has_free_face(scene)) return {};
  const bool symmetrised = scene.method.momentum == "symmetrised" && scene.method.gradient != "compatible";
  const bool wide = radius_over_spacing > 2 * (1 - 1e-9);
  const std::string width =
      fmt::format("beta = {:g} with {} near a free face: the support reaches to R = {:.3g} d",
                  scene.method.beta, scene.method.pair, radius_over_spacing);
  // Growth rates and modes: plumb spectrum verification/scenes/free_cube.toml --set body.spacing=0.2 --set
  // method.gradient=improved --over method.beta=0.9,1.0,1.2,1.5 (a test repeats them)
  if (symmetrised && wide)
    return {
        width +
        ", where the symmetrised force lets motion grow at any time step (a free cube of 5^3: by 0.044 "
        "c_p/d at R = 2 d, 0.087 at 2.4 d, 0.009 at 1.8 d); use a smaller beta or momentum = \"adjoint\""};
  if (symmetrised && !scene.method.jst)
    return {
        "momentum = \"symmetrised\" without [jst]: near free faces motion grows at any time step and nothing "
        "damps it (THEORY chapter 9); use momentum = \"adjoint\", or plumb spectrum to see how fast"};
  if (!symmetrised && radius_over_spacing > 2.4 * (1 - 1e-9) && scene.method.gradient != "compatible")
    return {width +
            ", and the stiffness falls for motions that alternate from particle "
            "to particle (a free cube of 5^3 at R = 2.4 d: 28 of 375 modes are "
            "softer than the softest smooth one, none at 1.8 d); use a smaller beta"};
  return {};
}

Texts jst_step_warnings(const Scene& scene, const FirstStep& step, double limit) {
  constexpr double rounding = 1e-9;
  if (scene.method.time_step && step.dt > limit * (1 + rounding))
    return {
        fmt::format("time_step = {:g} s is {:.3g} times what JST bears: eta4 = {:g} needs {:.6g} s or less "
                    "(THEORY (6.5), damping limit {:g}), or the run blows up",
                    step.dt, step.dt / limit, scene.method.jst->eta4, limit, step.damping)};
  if (!scene.method.time_step && step.dt > limit * (1 - rounding))
    return {
        fmt::format("JST limits the time step to {:.6g} s, {:.3g} of what cfl = {:g} asks for (eta4 beta^3 "
                    "Lambda is above the integrator's damping limit {:g}, THEORY (6.5))",
                    step.dt, step.dt / (*scene.method.cfl * step.crossing), *scene.method.cfl, step.damping)};
  return {};
}

template <int d>
Texts lattice_distance_warnings(const Cloud<d>& cloud, double R, double beta) {
  if (cloud.line == 0) return {};
  std::array<Index, d> reach;
  Vec<d> step;
  Index offsets = 1;
  for (int k = 0; k < d; ++k) {
    step[k] = cloud.count[k] > 1 ? cloud.X[cloud.stride[k]][k] - cloud.X[0][k] : cloud.spacing;
    reach[k] = std::min<Index>(cloud.count[k] - 1, static_cast<Index>(std::ceil(R / step[k] * (1 + 1e-9))));
    offsets *= reach[k] + 1;
  }
  for (Index n = 1; n < offsets; ++n) {
    Vec<d> separation;
    Index rest = n;
    for (int k = 0; k < d; ++k) {
      separation[k] = static_cast<double>(rest % (reach[k] + 1)) * step[k];
      rest /= reach[k] + 1;
    }
    const double r = separation.norm();
    if (std::abs(R - r) > 1e-9 * r) continue;
    return {fmt::format(
        "R = {:.10g} d is a distance of the lattice: rounding may decide whether those neighbours "
        "count (equal ones do not; their weight is zero); use another beta, say {:.4g}",
        R / cloud.spacing, 0.99 * beta)};
  }
  return {};
}

template <int d>
Texts aliasing_warnings(const Scene& scene, const Cloud<d>& cloud) {
  if (!scene.initial) return {};
  for (const Expression& formula : scene.initial->velocity)
    for (int axis = 0; axis < d; ++axis)
      // half way shows theta from pi to 3 pi; a third of the way what is left at multiples of 4 pi
      for (const double fraction : {1.0 / 2, 1.0 / 3}) {
        const double error = interpolation_error<d>(formula, cloud, axis, fraction);
        if (error < error_of_wave(std::numbers::pi, fraction) * (1 - 1e-3)) continue;
        return {fmt::format(
            "initial velocity \"{}\" is aliased along {}: it changes as fast between two particles "
            "as a wave with k d > pi, so the particles see another field; use a smaller spacing",
            formula.text(), "xyz"[axis])};
      }
  return {};
}

template <int d>
Texts warnings_of(const Scene& scene, const Solid<d>& solid, const FirstStep& step) {
  Texts all;
  const auto add = [&all](const Texts& more) { all.insert(all.end(), more.begin(), more.end()); };
  const double R = kernel_named<d>(scene.method.kernel).support * solid.smoothing_length;
  add(wide_kernel_warnings(scene, R / solid.cloud.spacing));
  if (scene.method.jst && scene.method.jst->eta4 > 0) add(jst_step_warnings(scene, step, solid.step_limit));
  add(lattice_distance_warnings<d>(solid.cloud, R, scene.method.beta));
  add(aliasing_warnings<d>(scene, solid.cloud));
  return all;
}

template Texts lattice_distance_warnings<1>(const Cloud<1>&, double, double);
template Texts lattice_distance_warnings<2>(const Cloud<2>&, double, double);
template Texts lattice_distance_warnings<3>(const Cloud<3>&, double, double);
template Texts aliasing_warnings<1>(const Scene&, const Cloud<1>&);
template Texts aliasing_warnings<2>(const Scene&, const Cloud<2>&);
template Texts aliasing_warnings<3>(const Scene&, const Cloud<3>&);
template Texts warnings_of<1>(const Scene&, const Solid<1>&, const FirstStep&);
template Texts warnings_of<2>(const Scene&, const Solid<2>&, const FirstStep&);
template Texts warnings_of<3>(const Scene&, const Solid<3>&, const FirstStep&);

}  // namespace plumb
