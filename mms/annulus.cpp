#include "mms/annulus.hpp"

#include <cmath>

#include "plumbline/core/error.hpp"

namespace plumb::mms {
namespace {

constexpr double pi = 3.141592653589793238462643383279502884;

void check(double inner, double outer, double spacing) {
  if (!(inner > 0) || !(outer > inner) || !(spacing > 0) || spacing > (outer - inner) / 2)
    throw InputError("an annulus of radii " + std::to_string(inner) + " and " + std::to_string(outer) +
                         " with spacing " + std::to_string(spacing),
                     "at least two layers of cells are needed", "Choose a smaller spacing.");
}

Cloud<2> empty_cloud(double outer, double spacing) {
  Cloud<2> cloud;
  cloud.spacing = spacing;
  cloud.box = {Vec<2>::Constant(-outer), Vec<2>::Constant(2 * outer)};
  return cloud;
}

/// Share of the cell around `middle` that lies in the annulus, by 32 x 32 points (error below 0.1 %).
double share_inside(const Vec<2>& middle, double size, double inner, double outer) {
  constexpr int points = 32;
  int inside = 0;
  for (int a = 0; a < points; ++a)
    for (int b = 0; b < points; ++b) {
      const double radius =
          (middle + size * Vec<2>((a + 0.5) / points - 0.5, (b + 0.5) / points - 0.5)).norm();
      inside += radius >= inner && radius <= outer;
    }
  return static_cast<double>(inside) / (points * points);
}

}  // namespace

Cloud<2> polar_cloud(double inner, double outer, double spacing) {
  check(inner, outer, spacing);
  Cloud<2> cloud = empty_cloud(outer, spacing);
  const auto steps = static_cast<int>(std::lround((outer - inner) / spacing));
  const auto around = static_cast<int>(std::lround(pi * (inner + outer) / spacing));
  const double step = (outer - inner) / steps;
  for (int k = 0; k <= steps; ++k) {
    const double radius = inner + k * step;
    const double low = std::max(inner, radius - step / 2), high = std::min(outer, radius + step / 2);
    const double sector = pi * (high * high - low * low) / around;
    for (int m = 0; m < around; ++m) {
      const double angle = 2 * pi * m / around;
      cloud.X.push_back(radius * Vec<2>(std::cos(angle), std::sin(angle)));
      cloud.V.push_back(sector);
    }
  }
  return cloud;
}

Surface<2> polar_surface(const Cloud<2>& polar, double inner, double outer) {
  const double middle = (inner + outer) / 2;
  Index around = 0;  // particles of the first ring
  while (polar.X[around].norm() < inner + 1e-9 * middle) ++around;
  const Index last = polar.size() - around;
  SurfaceMesh<2> mesh;
  for (Index m = 0; m < around; ++m) {
    const Index next = (m + 1) % around;
    mesh.push_back({next, m});  // the body lies outside of the inner circle
    mesh.push_back({last + m, last + next});
  }
  return mesh_surface<2>(polar, mesh);
}

Cloud<2> clipped_cloud(double inner, double outer, double spacing) {
  check(inner, outer, spacing);
  Cloud<2> cloud = empty_cloud(outer, spacing);
  const auto cells = static_cast<int>(std::ceil(outer / spacing));
  for (int a = -cells; a < cells; ++a)
    for (int b = -cells; b < cells; ++b) {
      const Vec<2> middle = spacing * Vec<2>(a + 0.5, b + 0.5);
      if (middle.norm() < inner || middle.norm() > outer) continue;
      cloud.X.push_back(middle);
      cloud.V.push_back(spacing * spacing * share_inside(middle, spacing, inner, outer));
    }
  return cloud;
}

}  // namespace plumb::mms
