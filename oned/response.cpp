#include "oned/response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumb::oned {

std::vector<double> response(const RadialKernel<1>& kernel, double radius_over_dx,
                             const GradientMethod& method, const std::vector<double>& thetas) {
  if (!(inner_radius(radius_over_dx) > 1) || radius_over_dx > 1e6)
    throw InputError(fmt::format("the radius over dx is {}", radius_over_dx),
                     "it must be above 1, or a particle has no neighbours, and at most 1000000",
                     "Give --radius-over-dx 4, for example.");
  std::vector<Neighbour<1>> lattice;  // spacing 1
  const auto reach = static_cast<Index>(std::ceil(inner_radius(radius_over_dx))) - 1;
  for (Index j = -reach; j <= reach; ++j) lattice.push_back({Vec<1>(static_cast<double>(j)), 1.0});
  const auto c = estimator_named<1>(method.estimator)(
      lattice, correct<1>(method.pair, kernel, radius_over_dx / kernel.support, lattice));
  std::vector<double> result;
  for (const double theta : thetas) {
    double sum = 0;
    for (Index j = 1; j <= reach; ++j)
      sum += (c[static_cast<std::size_t>(reach + j)][0] - c[static_cast<std::size_t>(reach - j)][0]) *
             std::sin(static_cast<double>(j) * theta);
    result.push_back(sum);
  }
  return result;
}

std::vector<ResponseRow> response_rows(const std::string& kernel, double radius_over_dx,
                                       const std::vector<GradientMethod>& methods, Index points) {
  if (points < 1 || points > 1'000'000)
    throw InputError(fmt::format("the number of points is {}", points), "it must lie between 1 and 1000000",
                     "");
  std::vector<double> thetas;
  for (Index m = 1; m <= points; ++m)
    thetas.push_back(std::numbers::pi * static_cast<double>(m) / static_cast<double>(points));
  std::vector<ResponseRow> rows;
  for (const GradientMethod& method : methods) {
    const std::vector<double> values = response(kernel_named<1>(kernel), radius_over_dx, method, thetas);
    for (std::size_t k = 0; k < thetas.size(); ++k)
      rows.push_back({thetas[k], method.estimator, method.pair, values[k]});
  }
  return rows;
}

std::vector<Resolution> resolutions(const std::string& kernel, double radius_over_dx,
                                    const std::vector<GradientMethod>& methods,
                                    const std::vector<double>& errors) {
  const RadialKernel<1> W = kernel_named<1>(kernel);
  std::vector<Resolution> all;
  for (const GradientMethod& method : methods)
    for (const double error : errors) {
      const auto within = [&](double theta) {
        return std::abs(response(W, radius_over_dx, method, {theta})[0] / theta - 1) <= error;
      };
      Resolution found{method.estimator, method.pair, error, {}, {}};
      constexpr int waves = 1000;
      double inside = 0, outside = std::numbers::pi;
      for (int k = 1; k <= waves; ++k) {
        outside = std::numbers::pi * k / waves;
        if (!within(outside)) break;
        inside = outside;
      }
      constexpr int halvings = 50;  // to round-off
      for (int k = 0; k < halvings && inside > 0 && inside < outside; ++k)
        (within((inside + outside) / 2) ? inside : outside) = (inside + outside) / 2;
      if (inside > 0) found.theta = inside, found.particles_per_wave = 2 * std::numbers::pi / inside;
      all.push_back(std::move(found));
    }
  return all;
}

std::vector<std::pair<std::size_t, std::size_t>> same_operators(const std::string& kernel,
                                                                double radius_over_dx,
                                                                const std::vector<GradientMethod>& methods) {
  std::vector<double> thetas;  // more than an operator has entries on one side
  const auto entries = static_cast<int>(std::ceil(radius_over_dx)) + 1;
  for (int k = 1; k <= entries; ++k) thetas.push_back(std::numbers::pi * k / (entries + 1));
  std::vector<std::vector<double>> values;
  for (const GradientMethod& method : methods)
    values.push_back(response(kernel_named<1>(kernel), radius_over_dx, method, thetas));
  constexpr double round_off = 1e-13;  // of sums of a few terms of size 1
  std::vector<std::pair<std::size_t, std::size_t>> same;
  for (std::size_t a = 0; a < methods.size(); ++a)
    for (std::size_t b = a + 1; b < methods.size(); ++b)
      if (std::equal(values[a].begin(), values[a].end(), values[b].begin(),
                     [](double x, double y) { return std::abs(x - y) < round_off; }))
        same.emplace_back(a, b);
  return same;
}

}  // namespace plumb::oned
