#include "lib/convergence/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <string>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

using Expansion = GridFit::Expansion;

constexpr double least_order = 0.01, largest_order = 20;

/// The grids with lengths in units of the coarsest spacing, and one choice of weights (their mean is 1).
struct Data {
  Eigen::ArrayXd h, value, weight;
};

Data data_of(const std::vector<Sample>& grids, bool weighted) {
  const auto n = static_cast<Eigen::Index>(grids.size());
  Data data{Eigen::ArrayXd(n), Eigen::ArrayXd(n), Eigen::ArrayXd::Ones(n)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const Sample& grid = grids[static_cast<std::size_t>(k)];
    data.h[k] = grid.spacing / grids.back().spacing;
    data.value[k] = grid.value;
  }
  if (weighted) data.weight = data.h.inverse() * (static_cast<double>(n) / data.h.inverse().sum());
  return data;
}

/// One expansion fitted.
struct Fit {
  Expansion expansion = Expansion::power;
  bool weighted = false;
  double order = 0, limit = 0, deviation = 0;
  bool least_inside = false;  ///< of a power law: its order is not an end of the range
  Eigen::ArrayXd values;      ///< at the grids
};

/// value = limit + sum of factors times powers of h, by linear least squares.
Fit fit_powers(const Data& data, const std::vector<double>& powers, int freedom) {
  const auto n = data.h.size(), unknowns = static_cast<Eigen::Index>(powers.size()) + 1;
  Eigen::MatrixXd terms = Eigen::MatrixXd::Ones(n, unknowns);
  for (Eigen::Index k = 1; k < unknowns; ++k)
    terms.col(k) = data.h.pow(powers[static_cast<std::size_t>(k - 1)]).matrix();
  const Eigen::VectorXd root = data.weight.sqrt().matrix();
  const Eigen::VectorXd factors =
      (root.asDiagonal() * terms).colPivHouseholderQr().solve(root.cwiseProduct(data.value.matrix()));
  Fit fit;
  fit.limit = factors[0];
  fit.values = (terms * factors).array();
  fit.deviation = std::sqrt((data.weight * (data.value - fit.values).square()).sum() / freedom);
  return fit;
}

/// The power law with the order of least deviation between the two ends of the range.
Fit fit_power_law(const Data& data, bool weighted) {
  const int freedom = static_cast<int>(data.h.size()) - 3;
  const auto deviation = [&](double log_order) {
    return fit_powers(data, {std::exp(log_order)}, freedom).deviation;
  };
  constexpr int steps = 150;
  const double begin = std::log(least_order), step = (std::log(largest_order) - begin) / steps;
  int best = 0;
  double least = deviation(begin);
  for (int k = 1; k <= steps; ++k)
    if (const double next = deviation(begin + k * step); next < least) best = k, least = next;
  const bool inside = best > 0 && best < steps;
  const double found = inside ? boost::math::tools::brent_find_minima(deviation, begin + (best - 1) * step,
                                                                      begin + (best + 1) * step, 40)
                                    .first
                              : begin + best * step;
  Fit fit = fit_powers(data, {std::exp(found)}, freedom);
  fit.weighted = weighted;
  fit.order = std::exp(found);
  fit.least_inside = inside;
  return fit;
}

/// Which expansions stand in for a power law of that order.
std::vector<Expansion> substitutes(double order) {
  if (order > 2) return {Expansion::first, Expansion::second};
  return {Expansion::first, Expansion::second, Expansion::first_and_second};
}

Fit fit_fixed(const Data& data, Expansion expansion, bool weighted) {
  const int n = static_cast<int>(data.h.size());
  Fit fit = expansion == Expansion::first    ? fit_powers(data, {1}, n - 2)
            : expansion == Expansion::second ? fit_powers(data, {2}, n - 2)
                                             : fit_powers(data, {1, 2}, n - 3);
  fit.expansion = expansion;
  fit.weighted = weighted;
  return fit;
}

Fit better(const Fit& a, const Fit& b) {
  return b.deviation < a.deviation ? b : a;
}

GridUncertainty uncertainty_of(const Sample& grid, double fitted, const GridFit& fit) {
  GridUncertainty out{grid.spacing, grid.value, fitted, std::abs(fitted - fit.limit), 0};
  const double scatter = fit.deviation + std::abs(grid.value - fitted);
  if (fit.deviation < fit.range)
    out.uncertainty = fit.safety * out.error + scatter;
  else if (fit.range > 0)
    out.uncertainty = 3 * fit.deviation / fit.range * (out.error + scatter);
  return out;
}

}  // namespace

GridFit fit_grids(std::span<const Sample> samples) {
  if (samples.size() < 4)
    throw InputError(std::to_string(samples.size()) + " grids for a least-squares extrapolation",
                     "three unknowns leave no scatter to see with three grids",
                     "Give four grids or more; plumb extrapolate takes three.");
  const std::vector<Sample> grids = fine_to_coarse(samples);
  const Data plain = data_of(grids, false), weighted = data_of(grids, true);
  const Fit power = better(fit_power_law(plain, false), fit_power_law(weighted, true));
  Fit chosen = power;
  if (power.order < 0.5 || power.order > 2) {
    chosen = fit_fixed(plain, Expansion::first, false);
    for (const Expansion expansion : substitutes(power.order))
      chosen =
          better(better(chosen, fit_fixed(plain, expansion, false)), fit_fixed(weighted, expansion, true));
  }
  GridFit out;
  out.expansion = chosen.expansion;
  out.weighted = chosen.weighted;
  if (power.least_inside) out.order = power.order;
  out.limit = chosen.limit;
  out.deviation = chosen.deviation;
  out.range = (plain.value.maxCoeff() - plain.value.minCoeff()) / static_cast<double>(grids.size() - 1);
  if (power.order >= 0.5 && power.order < 2.1 && out.deviation < out.range) out.safety = 1.25;
  for (std::size_t k = 0; k < grids.size(); ++k)
    out.grids.push_back(uncertainty_of(grids[k], chosen.values[static_cast<Eigen::Index>(k)], out));
  return out;
}

std::string_view name_of(GridFit::Expansion expansion) {
  switch (expansion) {
    case GridFit::Expansion::power:
      return "limit + a h^p";
    case GridFit::Expansion::first:
      return "limit + a h";
    case GridFit::Expansion::second:
      return "limit + a h^2";
    case GridFit::Expansion::first_and_second:
      break;
  }
  return "limit + a h + b h^2";
}

}  // namespace plumb
