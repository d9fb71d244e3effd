#include "lib/convergence/richardson.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <string>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

struct ObservedOrder {
  Extrapolation::Behaviour behaviour;
  double order;
};

/// ln(coarse/fine), of spacings whose quotient is no number too.
double log_ratio(double coarse, double fine) {
  const double ratio = coarse / fine;
  return std::isfinite(ratio) ? std::log(ratio) : std::log(coarse) - std::log(fine);
}

/// The p with (f3 - f2)/(f2 - f1) = (h3^p - h2^p)/(h2^p - h1^p), for fine f1, medium f2, coarse f3. The right
/// side rises with p; at p -> 0 it is ln(h3/h2)/ln(h2/h1), below which the differences do not shrink.
ObservedOrder observed_order(const Sample& fine, const Sample& medium, const Sample& coarse) {
  using Behaviour = Extrapolation::Behaviour;
  const double near = medium.value - fine.value, far = coarse.value - medium.value;
  const double scale = std::max({std::abs(fine.value), std::abs(medium.value), std::abs(coarse.value)});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (std::abs(near) <= 64 * std::numeric_limits<double>::epsilon() * scale)
    return {Behaviour::converged, nan};
  if (far / near < 0) return {Behaviour::oscillatory, nan};
  const double r = log_ratio(medium.spacing, fine.spacing), s = log_ratio(coarse.spacing, medium.spacing);
  const auto mismatch = [&](double p) {
    return std::log(std::expm1(p * s) / -std::expm1(-p * r)) - std::log(far / near);
  };
  constexpr double smallest = 1e-6;
  const double largest = 50 / std::max(r, s);  // beyond e^50 no difference is left to see
  if (mismatch(smallest) >= 0) return {Behaviour::divergent, nan};
  if (mismatch(largest) <= 0) return {Behaviour::converged, nan};
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      mismatch, smallest, largest, boost::math::tools::eps_tolerance<double>(50), iterations);
  return {Behaviour::monotone, (bracket.first + bracket.second) / 2};
}

/// r^p - 1 for the step from the coarse to the fine grid.
double gain(const Sample& fine, const Sample& coarse, double order) {
  return std::expm1(order * log_ratio(coarse.spacing, fine.spacing));
}

GridIndex index_of(const Sample& fine, const Sample& coarse, double order, double safety) {
  GridIndex index;
  index.absolute = safety * std::abs(coarse.value - fine.value) / gain(fine, coarse, order);
  if (fine.value != 0) index.relative = index.absolute / std::abs(fine.value);
  return index;
}

/// Order of the three grids from number k on, or the one given where they have none.
double order_from(const std::vector<Sample>& grid, std::size_t k, double otherwise) {
  if (k + 2 >= grid.size()) return otherwise;
  const ObservedOrder observed = observed_order(grid[k], grid[k + 1], grid[k + 2]);
  return observed.behaviour == Extrapolation::Behaviour::monotone ? observed.order : otherwise;
}

/// Index of the second pair, formed with `coarse_order`, over r^p times that of the first.
double ratio_of(const std::vector<Sample>& grid, double order, double coarse_order) {
  const double near = std::abs(grid[1].value - grid[0].value) / gain(grid[0], grid[1], order),
               far = std::abs(grid[2].value - grid[1].value) / gain(grid[1], grid[2], coarse_order);
  return far / ((gain(grid[0], grid[1], order) + 1) * near);
}

}  // namespace

std::vector<Sample> fine_to_coarse(std::span<const Sample> samples) {
  std::vector<Sample> out(samples.begin(), samples.end());
  for (const Sample& sample : out)
    if (!(sample.spacing > 0) || !std::isfinite(sample.spacing) || !std::isfinite(sample.value))
      throw InputError("a grid has spacing " + std::to_string(sample.spacing) + " and value " +
                           std::to_string(sample.value),
                       "extrapolation needs finite values on positive spacings", "Leave broken runs out.");
  std::sort(out.begin(), out.end(), [](const Sample& a, const Sample& b) { return a.spacing < b.spacing; });
  for (std::size_t k = 1; k < out.size(); ++k)
    if (out[k].spacing < 1.05 * out[k - 1].spacing)
      throw InputError("two grids have nearly the same spacing " + std::to_string(out[k].spacing),
                       "their difference is noise", "Refine by a factor of at least 1.05, better 1.3.");
  return out;
}

Extrapolation richardson(std::span<const Sample> samples, double safety,
                         std::optional<double> declared_order) {
  if (samples.size() < 3)
    throw InputError(std::to_string(samples.size()) + " grids cannot be extrapolated",
                     "the order is unknown, so three values are needed", "Add finer or coarser grids.");
  const std::vector<Sample> grid = fine_to_coarse(samples);
  const ObservedOrder observed = observed_order(grid[0], grid[1], grid[2]);
  Extrapolation out;
  out.behaviour = observed.behaviour;
  if (out.behaviour != Extrapolation::Behaviour::monotone) return out;
  out.order = observed.order;
  out.limit = grid[0].value + (grid[0].value - grid[1].value) / gain(grid[0], grid[1], out.order);
  double order = out.order;
  for (std::size_t k = 0; k + 1 < grid.size(); ++k) {
    order = order_from(grid, k, order);
    out.gci.push_back(index_of(grid[k], grid[k + 1], order, safety));
  }
  if (declared_order)
    out.asymptotic_ratio = ratio_of(grid, *declared_order, *declared_order);
  else if (const double next = order_from(grid, 1, 0); next > 0)
    out.asymptotic_ratio = ratio_of(grid, out.order, next);
  return out;
}

std::vector<Level> errors_against(std::span<const Sample> samples, const Sample& reference,
                                  double expected_order) {
  std::vector<Level> levels;
  for (const Sample& sample : samples) {
    const double share = std::pow(reference.spacing / sample.spacing, expected_order);
    if (!(share <= 0.1))
      throw InputError(
          "the reference of spacing " + std::to_string(reference.spacing) +
              " is too coarse for the grid of spacing " + std::to_string(sample.spacing),
          "its own error is " + std::to_string(share) +
              " of the grid's; with the finest of three grids as reference first order shows as 1.585",
          "Use richardson(), or a much finer reference.");
    levels.push_back({sample.spacing, sample.value - reference.value});
  }
  return levels;
}

double order_seen_against_finest(double order, double ratio) {
  return std::log(std::pow(ratio, order) + 1) / std::log(ratio);
}

double order_from_finest(double seen, double ratio) {
  const double power = std::pow(ratio, seen) - 1;
  if (!(power > 1))
    throw InputError("an apparent order of " + std::to_string(seen) + " against the finest grid",
                     "any positive order shows more than " + std::to_string(std::log(2.0) / std::log(ratio)),
                     "The grids do not converge.");
  return std::log(power) / std::log(ratio);
}

std::string_view name_of(Extrapolation::Behaviour behaviour) {
  switch (behaviour) {
    case Extrapolation::Behaviour::monotone:
      return "monotone";
    case Extrapolation::Behaviour::oscillatory:
      return "oscillatory";
    case Extrapolation::Behaviour::divergent:
      return "divergent";
    case Extrapolation::Behaviour::converged:
      break;
  }
  return "converged";
}

}  // namespace plumb
