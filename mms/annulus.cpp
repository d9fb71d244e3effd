#include "mms/annulus.hpp"

#include <cmath>

#include "lib/core/error.hpp"
#include "mms/solution.hpp"

namespace plumb::mms {
namespace {

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
      cloud.X.emplace_back(radius * Vec<2>(std::cos(angle), std::sin(angle)));
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

Shape<2> annulus_shape(double inner, double outer) {
  return shape_named<2>("annulus", {{"inner", {inner}}, {"outer", {outer}}});
}

}  // namespace plumb::mms
