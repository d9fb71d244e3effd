#include "lib/convergence/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// Order over the last three fitted levels (two if there are no more).
double tail_order(const OrderFit& fit) {
  const std::size_t last = fit.levels.size() - 1;
  const std::size_t first = last >= 2 ? last - 2 : 0;
  return pairwise_order({fit.levels[first], fit.errors[first]}, {fit.levels[last], fit.errors[last]});
}

/// How far the local orders of the fitted levels are from the declared one, from coarse to fine.
std::vector<double> distances(const OrderFit& fit, double declared) {
  std::vector<double> out;
  for (std::size_t k = 1; k < fit.levels.size(); ++k)
    out.push_back(std::abs(
        pairwise_order({fit.levels[k - 1], fit.errors[k - 1]}, {fit.levels[k], fit.errors[k]}) - declared));
  return out;
}

/// The local slope leaves the declared order under refinement, and that is no scatter: its drift is
/// significant, or four pairs and more recede one after the other (by chance four do in 1 of 24 cases).
bool moves_away(const OrderFit& fit, double declared, const VerdictRules& rules) {
  const std::vector<double> off = distances(fit, declared);
  if (off.back() <= rules.departure || off.back() <= std::abs(fit.order - declared)) return false;
  const bool recedes = off.size() >= 4 && std::is_sorted(off.begin(), off.end());
  return recedes || std::abs(fit.drift) > std::max(rules.resolution, fit.drift_half_width);
}

/// The local orders come nearer to the declared one from pair to pair.
bool converges(const OrderFit& fit, double declared, const VerdictRules& rules) {
  const std::vector<double> off = distances(fit, declared);
  for (std::size_t k = 1; k < off.size(); ++k)
    if (off[k] > off[k - 1] + rules.digits) return false;
  return off.back() <= off.front() / 2;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::not_asymptotic:
      return "not-asymptotic";
    case Verdict::above:
      return "above";
    case Verdict::noise_floor:
      return "noise-floor";
    case Verdict::too_few_levels:
      return "too-few-levels";
    case Verdict::inconclusive:
      break;
  }
  return "inconclusive";
}

std::string_view name_of(Trend trend) {
  switch (trend) {
    case Trend::asymptotic:
      return "asymptotic";
    case Trend::noise_floor:
      return "noise-floor";
    case Trend::stalled:
      return "stalled";
    case Trend::divergent:
      return "divergent";
    case Trend::too_few_levels:
      return "too-few-levels";
    case Trend::not_asymptotic:
      break;
  }
  return "not-asymptotic";
}

Verdict judge(const OrderFit& fit, double declared, const VerdictRules& rules) {
  if (fit.not_finite > 0) return Verdict::fail;
  if (fit.given < rules.min_levels) return Verdict::too_few_levels;
  if (fit.levels.size() < rules.min_levels) return Verdict::noise_floor;
  if (fit.sign_changes) return Verdict::not_asymptotic;
  if (fit.errors.back() > fit.errors.front()) return Verdict::fail;
  if (!(std::abs(fit.drift) <= rules.max_drift)) return Verdict::not_asymptotic;
  if (!(fit.half_width() <= rules.max_half_width)) return Verdict::inconclusive;
  const double missing = declared - fit.order, distance = std::abs(missing);
  if (distance <= fit.half_width() + rules.digits)
    return moves_away(fit, declared, rules) ? Verdict::not_asymptotic : Verdict::pass;
  if (distance <= rules.resolution && converges(fit, declared, rules)) return Verdict::pass;
  const bool on_its_way =
      missing * fit.drift > 0 && std::abs(fit.drift) > std::min(distance, 2 * rules.resolution);
  if (on_its_way) return Verdict::not_asymptotic;
  return fit.order > declared ? Verdict::above : Verdict::fail;
}

Trend classify(const OrderFit& fit, const VerdictRules& rules) {
  if (fit.not_finite > 0) return Trend::divergent;
  if (fit.given < rules.min_levels) return Trend::too_few_levels;
  if (fit.levels.size() < rules.min_levels) return Trend::noise_floor;
  if (fit.sign_changes) return Trend::not_asymptotic;
  const double tail = tail_order(fit);
  if (tail <= -rules.least_order) return Trend::divergent;
  if (tail < rules.least_order) return Trend::stalled;
  const bool power_law = std::abs(fit.drift) <= rules.max_drift && fit.half_width() <= rules.max_half_width;
  return power_law ? Trend::asymptotic : Trend::not_asymptotic;
}

bool excludes(const OrderFit& fit, double declared, const VerdictRules& rules) {
  return fit.not_finite == 0 && fit.levels.size() >= rules.min_levels &&
         fit.upper < declared - rules.resolution;
}

}  // namespace plumb
