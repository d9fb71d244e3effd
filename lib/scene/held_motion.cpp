#include "lib/scene/held_motion.hpp"

#include <gsl/gsl_deriv.h>

#include <algorithm>
#include <functional>

#include "lib/actions/load_options.hpp"

namespace plumb {
namespace {

using Function = std::function<double(double)>;

/// df/dt; formulas are not asked before t = 0.
double rate_of(const Function& f, double time, double time_scale) {
  const double step = 1e-3 * time_scale;
  gsl_function function{
      [](double t, void* of) { return (*static_cast<const Function*>(of))(t); },
      const_cast<Function*>(&f)};  // NOLINT: GSL's interface has no const; it is only called
  double rate = 0, error = 0;
  const auto derive = time > step ? gsl_deriv_central : gsl_deriv_forward;
  derive(&function, time, step, &rate, &error);
  return rate;
}

bool varies(const std::vector<Expression>& formulas) {
  return std::any_of(formulas.begin(), formulas.end(), [](const Expression& f) { return f.uses_time(); });
}

}  // namespace

bool is_steady(const Boundary& boundary) {
  const bool moves = !boundary.velocity.empty() || !boundary.displacement.empty();
  if (!moves) return true;
  return !boundary.ramp && !varies(boundary.velocity) && !varies(boundary.displacement);
}

HeldMotion prescribed_motion(const Boundary& boundary, const std::array<double, 3>& X, int component,
                             double time, double time_scale) {
  const auto& formulas = boundary.velocity.empty() ? boundary.displacement : boundary.velocity;
  if (formulas.empty()) return {};
  const Expression& formula = formulas[static_cast<std::size_t>(component)];
  const Function value = [&](double t) { return ramp_share(boundary.ramp, t) * formula.at(X, t); };
  const Function rate = [&](double t) { return rate_of(value, t, time_scale); };
  const bool steady = is_steady(boundary);
  if (!boundary.velocity.empty()) return {std::nullopt, value(time), steady ? 0 : rate(time)};
  if (steady) return {value(time), 0, 0};
  return {value(time), rate(time), rate_of(rate, time, time_scale)};
}

}  // namespace plumb
