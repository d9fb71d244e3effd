#include "verification/plumb/explain/setup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/scene/compatible_table.hpp"

namespace plumb::app {
namespace {

/// CPU-s = seconds (particles / at)^exponent.
struct Growth {
  double seconds, at, exponent;
  double operator()(double particles) const { return seconds * std::pow(particles / at, exponent); }
};
/// Measured for THEORY chapter 11: factors on the plate of 81 x 81 and on a cube of 22^3 (a lattice whose
/// bonds reach one layer), iterations on the jittered cube of 47^3.
constexpr Growth factors_2d{0.79, 6561, 1.5}, factors_3d{36, 10648, 2}, iterations_3d{23, 103823, 1.08};

template <int d>
double expected(const Cloud<d>& cloud, double R) {
  const auto n = static_cast<double>(cloud.size());
  if (d <= 2) return factors_2d(n);  // at most that for a bar, whose matrix is a band
  const bool thin_lattice = cloud.line > 0 && R <= 2 * cloud.spacing;
  return thin_lattice ? factors_3d(n) : iterations_3d(n);
}

}  // namespace

template <int d>
std::optional<ProjectionCost> projection_cost(const Scene& scene, const Cloud<d>& cloud) {
  const auto why = reason_to_project<d>(scene, cloud);
  if (!why) return std::nullopt;
  const double R = kernel_named<d>(scene.method.kernel).support * scene.method.beta * cloud.spacing;
  return ProjectionCost{*why, expected<d>(cloud, R)};
}

std::string text_of(const std::optional<ProjectionCost>& cost) {
  if (!cost) return "";
  return fmt::format("Set-up: the table is projected, because {}; that takes {} CPU-s\n", cost->why,
                     cost->cpu_s < 0.1 ? "less than 0.1" : fmt::format("about {:.2g}", cost->cpu_s));
}

template std::optional<ProjectionCost> projection_cost<1>(const Scene&, const Cloud<1>&);
template std::optional<ProjectionCost> projection_cost<2>(const Scene&, const Cloud<2>&);
template std::optional<ProjectionCost> projection_cost<3>(const Scene&, const Cloud<3>&);

}  // namespace plumb::app
