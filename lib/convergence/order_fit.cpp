#include "lib/convergence/order_fit.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

struct Weighted {
  Level level;
  double weight;
};

void check(std::span<const Level> levels, std::span<const double> weights) {
  for (const Level& level : levels)
    if (!(level.spacing > 0) || !std::isfinite(level.spacing))
      throw InputError("a level has spacing " + std::to_string(level.spacing),
                       "an order is a slope over log spacing", "Give positive, finite spacings.");
  if (!weights.empty() && weights.size() != levels.size())
    throw InputError(
        std::to_string(weights.size()) + " weights for " + std::to_string(levels.size()) + " levels", "",
        "Give one weight per level, or none.");
  for (double weight : weights)
    if (!(weight > 0) || !std::isfinite(weight))
      throw InputError("a weight of the order fit is " + std::to_string(weight),
                       "weights are 1/variance of log error", "Give positive, finite weights.");
}

/// Levels from coarse to fine with their weights.
std::vector<Weighted> sorted(std::span<const Level> levels, std::span<const double> weights) {
  check(levels, weights);
  std::vector<Weighted> out;
  for (std::size_t k = 0; k < levels.size(); ++k)
    out.push_back({levels[k], weights.empty() ? 1.0 : weights[k]});
  std::stable_sort(out.begin(), out.end(),
                   [](const Weighted& a, const Weighted& b) { return a.level.spacing > b.level.spacing; });
  for (std::size_t k = 1; k < out.size(); ++k)
    if (out[k].level.spacing == out[k - 1].level.spacing)
      throw InputError("two levels have the spacing " + std::to_string(out[k].level.spacing), "",
                       "Give every spacing once.");
  return out;
}

/// The levels that say something about the order; counts the others in the fit.
std::vector<Weighted> usable(const std::vector<Weighted>& levels, const FitOptions& options, OrderFit& fit) {
  std::vector<Weighted> out;
  for (const Weighted& entry : levels) {
    const double error = std::abs(entry.level.error);
    if (!std::isfinite(error)) {
      ++fit.not_finite;
    } else if (fit.at_round_off > 0 ||
               error <= options.floor_factor * std::max(options.round_off, entry.level.floor)) {
      ++fit.at_round_off;
    } else if (fit.at_model_floor > 0 || error <= options.floor_factor * options.modelling_floor) {
      ++fit.at_model_floor;
    } else {
      if (!out.empty() && (out.back().level.error < 0) != (entry.level.error < 0)) fit.sign_changes = true;
      out.push_back(entry);
    }
  }
  return out;
}

/// Quantile of Student's t for a two-sided interval.
double student_quantile(double confidence, double freedom) {
  const boost::math::students_t_distribution<double> student(freedom);
  return boost::math::quantile(boost::math::complement(student, (1 - confidence) / 2));
}

/// Change of the slope over the range: 2 c2 (x_last - x_first) of y = c0 + c1 x + c2 x^2, by removing the
/// straight part of x^2 first (so that no near-singular system is solved). `straight`: weighted sum of
/// squared residuals of the straight line; what c2 leaves of it gives the interval.
void fit_drift(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& w,
               double straight, double confidence, OrderFit& fit) {
  const std::size_t n = x.size();
  std::vector<double> square(n);
  const double middle = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) square[k] = (x[k] - middle) * (x[k] - middle);
  double c0 = 0, c1 = 0, cov00 = 0, cov01 = 0, cov11 = 0, chi2 = 0;
  gsl_fit_wlinear(x.data(), 1, w.data(), 1, square.data(), 1, n, &c0, &c1, &cov00, &cov01, &cov11, &chi2);
  double along = 0;
  for (std::size_t k = 0; k < n; ++k) along += w[k] * (square[k] - c0 - c1 * x[k]) * y[k];
  const double range = x.back() - x.front();
  fit.drift = 2 * (along / chi2) * range;  // chi2 is the weighted norm of that remainder
  if (n < 4) return;
  const auto freedom = static_cast<double>(n - 3);
  const double left = std::max(0.0, straight - along * along / chi2);
  fit.drift_half_width =
      2 * std::abs(range) * student_quantile(confidence, freedom) * std::sqrt(left / freedom / chi2);
}

void fit_line(const std::vector<Weighted>& levels, double confidence, OrderFit& fit) {
  std::vector<double> x, y, w;
  for (const Weighted& entry : levels) {
    x.push_back(std::log(entry.level.spacing));
    y.push_back(std::log(std::abs(entry.level.error)));
    w.push_back(entry.weight);
  }
  const std::size_t n = x.size();
  if (n < 2) return;
  double cov00 = 0, cov01 = 0, cov11 = 0, chi2 = 0;
  gsl_fit_wlinear(x.data(), 1, w.data(), 1, y.data(), 1, n, &fit.log_constant, &fit.order, &cov00, &cov01,
                  &cov11, &chi2);
  if (n < 3) return;
  const auto freedom = static_cast<double>(n - 2);
  // cov11 is for unit variance: scale by the residuals
  const double half = student_quantile(confidence, freedom) * std::sqrt(cov11 * chi2 / freedom);
  fit.lower = fit.order - half;
  fit.upper = fit.order + half;
  fit_drift(x, y, w, chi2, confidence, fit);
}

}  // namespace

double pairwise_order(const Level& coarse, const Level& fine) {
  const double ratio = coarse.error / fine.error;
  if (!std::isfinite(ratio) || !(ratio > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(ratio) / std::log(coarse.spacing / fine.spacing);
}

OrderFit fit_order(std::span<const Level> levels, const FitOptions& options) {
  const std::vector<Weighted> all = sorted(levels, options.weights);
  OrderFit fit;
  fit.given = all.size();
  for (std::size_t k = 1; k < all.size(); ++k)
    fit.pairwise.push_back(pairwise_order(all[k - 1].level, all[k].level));
  const std::vector<Weighted> chosen = usable(all, options, fit);
  for (const Weighted& entry : chosen) {
    fit.levels.push_back(entry.level.spacing);
    fit.errors.push_back(std::abs(entry.level.error));
  }
  fit_line(chosen, options.confidence, fit);
  return fit;
}

OrderFit fit_order(std::span<const Level> levels, std::span<const double> weights) {
  FitOptions options;
  options.weights = weights;
  return fit_order(levels, options);
}

}  // namespace plumb
