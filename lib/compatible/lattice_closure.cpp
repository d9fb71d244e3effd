#include "plumbline/compatible/lattice_closure.hpp"

#include <cmath>

#include "plumbline/core/error.hpp"

namespace plumb {
namespace {

/// Which layers there are beside a particle, along one axis.
struct Axis {
  double below = 0, above = 0;  ///< distance to the lowest and to the highest layer seen [m]
  double half;                  ///< half a step [m]: what is farther is the next layer

  bool lower_end() const { return below > -half; }
  bool upper_end() const { return above < half; }
  int layer(double separation) const { return separation < -half ? -1 : separation > half ? 1 : 0; }

  /// D [1/m], THEORY (11.9): between the outermost layers seen, so that linear fields are exact on the
  /// positions as they are rounded.
  double difference(int layer) const {
    const double own = lower_end() ? -1 : upper_end() ? 1 : 0;
    return (layer == 0 ? own : layer) / (above - below);
  }
  /// T, THEORY (11.9).
  double curvature(int layer) const {
    const bool inside = !lower_end() && !upper_end();
    return layer == 0 ? -2 : inside ? 1 : 2;
  }
};

template <int d>
std::array<Axis, d> axes_of(const LatticeClosure<d>& closure, Neighbourhood<d> neighbours) {
  std::array<Axis, d> axes;
  for (int k = 0; k < d; ++k) {
    axes[k].half = 0.5 * closure.step[k];
    for (const auto& neighbour : neighbours) {
      axes[k].below = std::min(axes[k].below, neighbour.separation[k]);
      axes[k].above = std::max(axes[k].above, neighbour.separation[k]);
    }
  }
  return axes;
}

/// I + sum_m once_m T_m + twice T_m T_n of component k at one neighbour. T and I are zero where there is a
/// step along the other axes.
template <int d>
double across(const Averaging<d>& averaging, int k, const std::array<Axis, d>& axes,
              const std::array<int, d>& layer) {
  double both = averaging.twice;
  std::array<double, d> identity;
  for (int m = 0; m < d; ++m) identity[m] = m == k || layer[m] == 0 ? 1 : 0;
  double sum = 1;
  for (int m = 0; m < d; ++m) sum *= identity[m];
  for (int m = 0; m < d; ++m) {
    if (m == k) continue;
    double once = averaging.once[m] * axes[m].curvature(layer[m]);
    for (int n = 0; n < d; ++n)
      if (n != m) once *= identity[n];
    sum += once;
    both *= axes[m].curvature(layer[m]);
  }
  return d == 3 ? sum + both : sum;
}

/// Separations of the particle itself and of all 3^d - 1 particles around it, in that order.
template <int d>
std::vector<Vec<d>> full_neighbourhood(const Vec<d>& step) {
  std::vector<Vec<d>> all{Vec<d>::Zero()};
  for (int n = 0; n < (d == 2 ? 9 : 27); ++n) {
    Vec<d> X;
    for (int k = 0, rest = n; k < d; ++k, rest /= 3) X[k] = (rest % 3 - 1) * step[k];
    if (X.squaredNorm() > 0) all.push_back(X);
  }
  return all;
}

/// The averaging of component k that gives the weights c(offset) of a full neighbourhood.
template <int d, class Weight>
Averaging<d> averaging_of(int k, double step, const Weight& c) {
  Averaging<d> a;
  if (d == 3) a.twice = 2 * step * c(Vec<d>::Ones());
  double total = 1 + 4 * a.twice;
  for (int m = 0; m < d; ++m)
    if (m != k) {
      a.once[m] = 2 * step * c(Vec<d>::Unit(k) + Vec<d>::Unit(m)) + 2 * a.twice;
      total -= 2 * a.once[m];
    }
  // rounding of sums of some ten weights, and of a correction of small condition
  if (std::abs(2 * step * c(Vec<d>::Unit(k)) - total) > 1e-10)
    throw InputError("a start table that is not exact for affine maps",
                     "its weights are no difference along an axis times an average across",
                     "use start = \"standard\" or \"improved\" with pair = \"W1\" or \"W0\"");
  return a;
}

}  // namespace

template <int d>
std::optional<std::string> reason_against_closure(const Cloud<d>& cloud, double R) {
  Index particles = 1;
  for (const Index n : cloud.count) particles *= n;
  if (cloud.line == 0 || particles != cloud.size()) return "the particles are no whole lattice";
  for (int k = 0; k < d; ++k) {
    if (cloud.count[k] < 2) return std::string("the body is one particle thick");
    const double first = cloud.X.front()[k] - cloud.box.origin[k], size = cloud.box.size[k];
    if (first != 0 || std::abs(cloud.X.back()[k] - cloud.box.origin[k] - size) > 1e-12 * size)
      return "no particles lie on the faces";
    const double step = size / static_cast<double>(cloud.count[k] - 1);
    if (cloud.count[k] > 2 && R * (1 - 1e-12) > 2 * step) return "bonds reach beyond the next layer";
  }
  return std::nullopt;
}

template <int d>
LatticeClosure<d> lattice_closure(const Cloud<d>& cloud, const BondOptions<d>& options) {
  LatticeClosure<d> closure;
  for (int k = 0; k < d; ++k) closure.step[k] = cloud.box.size[k] / static_cast<double>(cloud.count[k] - 1);
  const double R = options.kernel.support * options.smoothing_length;
  std::vector<Neighbour<d>> seen;
  for (const auto& X : full_neighbourhood<d>(closure.step))
    if (X.norm() < R * (1 - 1e-12)) seen.push_back({X, closure.step.prod()});
  const CorrectedKernel<d> kernel = correct<d>(options.pair, options.kernel, options.smoothing_length, seen);
  const auto stencil = options.estimator(seen, kernel);
  for (int k = 0; k < d; ++k)
    closure.averaging[k] = averaging_of<d>(k, closure.step[k], [&](const Vec<d>& offset) {
      const Vec<d> X = offset.cwiseProduct(closure.step);
      for (std::size_t n = 0; n < seen.size(); ++n)
        if ((seen[n].separation - X).norm() < 0.1 * closure.step.minCoeff()) return stencil[n][k];
      return 0.0;  // out of reach
    });
  return closure;
}

template <int d>
std::vector<Vec<d>> closed_stencil(const LatticeClosure<d>& closure, Neighbourhood<d> neighbours) {
  const auto axes = axes_of<d>(closure, neighbours);
  std::vector<Vec<d>> c;
  c.reserve(neighbours.size());
  for (const auto& neighbour : neighbours) {
    std::array<int, d> layer;
    for (int k = 0; k < d; ++k) layer[k] = axes[k].layer(neighbour.separation[k]);
    Vec<d> weight = Vec<d>::Zero();
    if (neighbour.separation.squaredNorm() > 0)
      for (int k = 0; k < d; ++k)
        weight[k] = axes[k].difference(layer[k]) * across<d>(closure.averaging[k], k, axes, layer);
    c.push_back(weight);
  }
  return c;
}

template <int d>
LatticeClosure<d> close_on_lattice(BondOptions<d>& options, const Cloud<d>& cloud) {
  const LatticeClosure<d> closure = lattice_closure(cloud, options);
  options.estimator = [closure](Neighbourhood<d> neighbours, const CorrectedKernel<d>&) {
    return closed_stencil<d>(closure, neighbours);
  };
  return closure;
}

#define PLUMB_INSTANTIATE(d)                                                                  \
  template std::optional<std::string> reason_against_closure<d>(const Cloud<d>&, double);     \
  template LatticeClosure<d> lattice_closure<d>(const Cloud<d>&, const BondOptions<d>&);      \
  template std::vector<Vec<d>> closed_stencil<d>(const LatticeClosure<d>&, Neighbourhood<d>); \
  template LatticeClosure<d> close_on_lattice<d>(BondOptions<d>&, const Cloud<d>&);
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
