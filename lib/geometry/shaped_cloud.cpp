#include "lib/geometry/shaped_cloud.hpp"

#include <fmt/format.h>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/geometry/poisson_discs.hpp"

namespace plumb {
namespace {

/// Least distance of random points for about one per spacing^k in k = 1, 2, 3 dimensions: discs thrown at
/// random cover 0.748, 0.547 and 0.384 of space when no more fit, of which some 95 % are found here.
constexpr std::array<double, 4> disc = {0, 0.72, 0.81, 0.89};
/// Throws per expected point; more find some percent more.
constexpr int throws_per_point = 300;
/// How far inside of the surface the particles of a cell layout stay at least, in spacings.
constexpr double least_depth = 0.25;

template <int d>
Index expected(const Box<d>& box, double spacing) {
  return static_cast<Index>(std::ceil((box.size / spacing).prod()));
}

/// A coordinate that misses a face of the box by rounding is put on it.
template <int d>
void meet_faces(const Box<d>& box, double spacing, Vec<d>& X) {
  for (int k = 0; k < d; ++k)
    for (const double face : {box.origin[k], box.origin[k] + box.size[k]})
      if (std::abs(X[k] - face) < 1e-9 * spacing) X[k] = face;
}

/// The nearest point of the surface, by following the gradient of the distance; it may not be found at edges.
template <int d>
Vec<d> on_surface(const Shape<d>& shape, Vec<d> X, double spacing) {
  const double step = 1e-6 * spacing;
  for (int pass = 0; pass < 8; ++pass) {
    const double there = shape.distance(X);
    if (std::abs(there) < 1e-14 * spacing) break;
    Vec<d> gradient;
    for (int k = 0; k < d; ++k)
      gradient[k] =
          (shape.distance(X + step * Vec<d>::Unit(k)) - shape.distance(X - step * Vec<d>::Unit(k))) /
          (2 * step);
    if (!(gradient.squaredNorm() > 0)) break;
    X -= there * gradient / gradient.squaredNorm();
  }
  meet_faces(shape.box, spacing, X);
  return X;
}

template <int d>
void throw_on_surface(const Shape<d>& shape, double spacing, RandomNumbers& random, PoissonDiscs<d>& discs) {
  const Index throws = throws_per_point * expected(shape.box, spacing);
  for (Index n = 0; n < throws; ++n) {
    const Vec<d> X = random.in(shape.box);
    if (std::abs(shape.distance(X)) > spacing) continue;
    const Vec<d> at = on_surface(shape, X, spacing);
    // 1e-10: found, but for rounding
    if (std::abs(shape.distance(at)) < 1e-10 * spacing && discs.is_free(at, disc[d - 1] * spacing))
      discs.add(at);
  }
}

template <int d>
void throw_inside(const Shape<d>& shape, double depth, double spacing, RandomNumbers& random,
                  PoissonDiscs<d>& discs) {
  const Index throws = throws_per_point * expected(shape.box, spacing);
  for (Index n = 0; n < throws; ++n) {
    const Vec<d> X = random.in(shape.box);
    if (shape.distance(X) < -depth && discs.is_free(X, disc[d] * spacing)) discs.add(X);
  }
}

/// Nodes or middles of the cells of a lattice that is centred on the shape's box.
template <int d>
std::vector<Vec<d>> lattice_over(const Box<d>& box, const Filling& filling) {
  std::array<Index, d> count;
  Vec<d> first;
  Index total = 1;
  for (int k = 0; k < d; ++k) {
    // 1e-6: as in cells_of, a size that the spacing divides gives no cell more
    count[k] = static_cast<Index>(std::ceil(box.size[k] / filling.spacing - 1e-6));
    const double beyond = 0.5 * (static_cast<double>(count[k]) * filling.spacing - box.size[k]);
    first[k] = box.origin[k] - beyond + (filling.layout == Layout::cell ? 0.5 * filling.spacing : 0);
    if (filling.layout == Layout::node) ++count[k];
    total *= count[k];
  }
  std::vector<Vec<d>> X;
  for (Index n = 0; n < total; ++n) {
    X.push_back(first);
    for (Index k = d - 1, rest = n; k >= 0; rest /= count[k], --k)
      X.back()[k] += filling.spacing * static_cast<double>(rest % count[k]);
    meet_faces(box, filling.spacing, X.back());
  }
  return X;
}

/// Moves the particles inside; a move that would bring one too near to the surface is left out.
template <int d>
void jitter(std::vector<Vec<d>>& X, const Shape<d>& shape, const Filling& filling, RandomNumbers& random) {
  const double depth = least_depth * filling.spacing;
  for (auto& point : X) {
    Vec<d> moved = point;
    for (int k = 0; k < d; ++k) moved[k] += filling.jitter * filling.spacing * (2 * random.next() - 1);
    if (shape.distance(point) < -1e-9 * filling.spacing && shape.distance(moved) < -depth) point = moved;
  }
}

}  // namespace

template <int d>
Cloud<d> shaped_cloud(const Shape<d>& shape, const Filling& filling) {
  if (!shape.box.size.allFinite())
    throw InputError("a body without bounds", "no finite number of particles fills it",
                     "use it to cut another shape");
  RandomNumbers random(filling.seed);
  PoissonDiscs<d> discs(filling.spacing);
  const bool nodes = filling.layout == Layout::node;
  const double depth = (nodes ? 0.5 : filling.blue_noise ? least_depth : 0.0) * filling.spacing;
  const auto lattice = lattice_over<d>(shape.box, filling);
  if (nodes) {
    for (const auto& X : lattice)
      if (std::abs(shape.distance(X)) < 1e-9 * filling.spacing) discs.add(X);
    throw_on_surface(shape, filling.spacing, random, discs);
  }
  if (filling.blue_noise) {
    throw_inside(shape, depth, filling.spacing, random, discs);
  } else {
    for (const auto& X : lattice)
      if (shape.distance(X) < -depth * (1 - 1e-9)) discs.add(X);
  }
  Cloud<d> cloud;
  cloud.X = discs.points();
  if (cloud.X.empty())
    throw InputError("the body is empty",
                     fmt::format("no particle of spacing {:g} m lies inside", filling.spacing),
                     "use a smaller spacing");
  if (filling.jitter > 0) jitter(cloud.X, shape, filling, random);
  cloud.spacing = filling.spacing;
  cloud.box = shape.box;
  cloud.V = clipped_cells<d>(cloud.X, shape).volume;
  return cloud;
}

template Cloud<2> shaped_cloud<2>(const Shape<2>&, const Filling&);
template Cloud<3> shaped_cloud<3>(const Shape<3>&, const Filling&);

}  // namespace plumb
