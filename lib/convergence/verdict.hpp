#pragma once
#include <string_view>

#include "lib/convergence/order_fit.hpp"

namespace plumb {

/// Outcome of a study with a declared order. Only pass is a pass.
enum class Verdict {
  pass,            ///< the declared order is the measured one
  fail,            ///< the measured order is lower than the declared one; or a run broke
  above,           ///< the measured order is higher than the declared one
  not_asymptotic,  ///< the local slope still drifts, or a signed error crosses zero
  noise_floor,     ///< fewer than four levels lie above round-off or the modelling floor
  too_few_levels,  ///< fewer than four levels were given
  inconclusive     ///< an interval too wide to tell orders apart
};

/// Outcome of a study without a declared order (`plumb oned study`).
enum class Trend {
  asymptotic,      ///< at least four levels on one power law
  not_asymptotic,  ///< no power law (yet)
  noise_floor,     ///< fewer than four levels lie above round-off or the modelling floor
  stalled,         ///< the errors stop falling at a size that no floor explains
  divergent,       ///< the errors grow under refinement, or are not finite
  too_few_levels   ///< fewer than four levels were given
};

/// Gives the word of a verdict, as in words.hpp: "pass", "not-asymptotic", "too-few-levels".
std::string_view name_of(Verdict verdict);
/// Gives the word of a trend, as in words.hpp: "asymptotic", "stalled".
std::string_view name_of(Trend trend);

/// The thresholds of the verdicts; the reasons stand in lib/convergence/README.md.
struct VerdictRules {
  std::size_t min_levels = 4;   ///< two levels prove nothing, three leave the interval one degree of freedom
  double max_half_width = 0.5;  ///< a wider interval does not tell p from p + 1/2
  double max_drift = 0.5;       ///< change of the local slope over the fitted range
  double resolution = 0.1;      ///< a bias of this size may come from the next term of the expansion
  double departure = 0.15;      ///< finest pair off by more: not the 0.14 of a level at ten floors
  double digits = 0.005;        ///< orders are stated with two decimals: an interval is read as printed
  double least_order = 0.25;    ///< |order| below this is no convergence: 16 % a halving
};

/// Decides, in this sequence:
/// 1. a level that is not finite: fail;
/// 2. fewer than min_levels given: too_few_levels;
/// 3. fewer than min_levels above the floors: noise_floor;
/// 4. a change of sign: not_asymptotic;
/// 5. a larger error on the finest than on the coarsest fitted level: fail;
/// 6. |drift| > max_drift: not_asymptotic;
/// 7. half-width > max_half_width: inconclusive;
/// 8. the interval [lower, upper] contains the declared order (to its digits): pass, but not_asymptotic where
///    the local slope moves away from it: the finest pair is farther off than the fit and than `departure`,
///    and either the drift is more than a resolution and its interval excludes 0, or four pairs or more
///    recede in sequence;
/// 9. the order is within a resolution of the declared one and the pairwise orders converge to it (none
///    farther off than the one before, the last at most half as far as the first): pass;
/// 10. the local slope drifts towards the declared order by more than what is missing, or by more than 2
///    resolutions: not_asymptotic;
/// 11. an order above the declared one: above;
/// 12. else fail.
Verdict judge(const OrderFit& fit, double declared, const VerdictRules& rules = {});

/// Decides, in this sequence:
/// 1. a level that is not finite: divergent;
/// 2. fewer than min_levels given: too_few_levels;
/// 3. fewer than min_levels above the floors: noise_floor;
/// 4. a change of sign: not_asymptotic;
/// 5. the order q over the last three fitted levels: q <= -least_order divergent, |q| < least_order stalled;
/// 6. |drift| > max_drift or half-width > max_half_width: not_asymptotic;
/// 7. else asymptotic.
Trend classify(const OrderFit& fit, const VerdictRules& rules = {});

/// Says whether the measurement excludes a declared order from below: at least min_levels were fitted, and
/// the upper end of the interval is below the order by more than a resolution. Only then is an order
/// *contradicted*; a verdict other than pass does not say so.
bool excludes(const OrderFit& fit, double declared, const VerdictRules& rules = {});

}  // namespace plumb
