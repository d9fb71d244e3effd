#include "oned/profile.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/core/error.hpp"
#include "lib/kernel/correction.hpp"
#include "oned/gradient.hpp"

namespace plumb::oned {
namespace {

double sum(const std::vector<double>& weights) {
  double total = 0;
  for (const double weight : weights) total += weight;
  return total;
}

/// Of [m0 m1; m1 m2], m_k = sum V W (X_j - x)^k/R^k.
double condition_of(const std::vector<double>& weights, const std::vector<Neighbour<1>>& seen, double R) {
  double m0 = 0, m1 = 0, m2 = 0;
  for (std::size_t j = 0; j < seen.size(); ++j) {
    const double s = seen[j].separation[0] / R;
    m0 += weights[j], m1 += weights[j] * s, m2 += weights[j] * s * s;
  }
  const double half = (m0 + m2) / 2, determinant = m0 * m2 - m1 * m1;
  const double largest = half + std::hypot((m0 - m2) / 2, m1);
  return largest * largest / determinant;  // over the smallest, which is determinant/largest
}

}  // namespace

std::vector<ProfileRow> correction_profile(const Discretisation& discretisation,
                                           const std::vector<double>& at) {
  const Cloud<1> cloud = make_cloud(discretisation);
  const RadialKernel<1> kernel = kernel_named<1>(discretisation.kernel);
  const double R = discretisation.support(), h = R / kernel.support;
  std::vector<Neighbour<1>> seen;
  std::vector<ProfileRow> rows;
  rows.reserve(at.size());
  for (const double x : at) {
    see(cloud, support_of(cloud, R, discretisation.length, x), x, seen);
    const auto plain = correct<1>(Correction::none, kernel, h, seen);
    const auto shepard = correct<1>(Correction::W0raw, kernel, h, seen);
    const auto first = correct<1>(Correction::W1, kernel, h, seen);
    double negative = 0;
    for (const double weight : first.weight) negative += std::max(0.0, -weight);
    rows.push_back({x, first.alpha, first.beta[0], sum(plain.weight), sum(shepard.weight), sum(first.weight),
                    condition_of(plain.weight, seen, R), negative});
  }
  return rows;
}

std::vector<double> even_points(double length, Index count) {
  if (count < 2 || count > 1'000'000)
    throw InputError(fmt::format("the number of points is {}", count), "it must lie between 2 and 1000000",
                     "Give --points 101, for example.");
  std::vector<double> points;
  for (Index k = 0; k < count; ++k)
    points.push_back(length * static_cast<double>(k) / static_cast<double>(count - 1));
  return points;
}

}  // namespace plumb::oned
