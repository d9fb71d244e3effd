#include "oned/response.hpp"

#include <fmt/format.h>

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

}  // namespace plumb::oned
