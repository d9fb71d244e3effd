#pragma once
#include <cmath>
#include <limits>

namespace plumb {

/// Yield stress and its derivative by the plastic strain [Pa].
struct Yield {
  double value, slope;
};

/// Plastic strain of one increment and the steps that were needed to find it.
struct PlasticIncrement {
  double strain;
  int iterations;
};

/// Where Newton's method begins: at no plastic strain, which ends at once for linear hardening, or at the most
/// that there can be, for yield stresses whose slope at none is infinite.
enum class Start { none, upper };

/// The root g > 0 of q_trial - 3 mu g = yield(g).value, THEORY (4.15): radial return of an isotropic J2 law.
/// Newton's method kept in the bracket [0, (q_trial - yield(0))/(3 mu)], so that it ends for every yield
/// stress that does not fall faster than 3 mu; one step for a linear one. `q_trial` must exceed yield(0).
template <class YieldOf>
PlasticIncrement plastic_increment(double q_trial, double shear, YieldOf&& yield, Start start = Start::none) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double tolerance = rounding * q_trial;
  double low = 0, high = (1 + rounding) * (q_trial - yield(0.0).value) / (3 * shear);
  double g = start == Start::upper ? high : 0;
  for (int n = 0; n < 200; ++n) {
    const Yield now = yield(g);
    const double excess = q_trial - 3 * shear * g - now.value;
    if (std::abs(excess) <= tolerance) return {g, n};
    (excess > 0 ? low : high) = g;
    double next = g + excess / (3 * shear + now.slope);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == g) return {g, n};
    g = next;
  }
  return {g, 200};
}

}  // namespace plumb
