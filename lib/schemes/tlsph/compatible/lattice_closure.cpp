#include "lib/schemes/tlsph/compatible/lattice_closure.hpp"

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

/// What a particle sees along one axis, and the weights there of the operators of THEORY (11.9), (11.15). A
/// layer counts up from the particle's own.
class Axis {
 public:
  template <int d>
  Axis(double step, int k, Neighbourhood<d> neighbours) : step_(step) {
    double next[2] = {0, 0};  // distances to the layers below and above, as they are rounded
    for (const auto& neighbour : neighbours) {
      const double separation = neighbour.separation[k];
      const int n = layer(separation);
      below_ = std::max(below_, -n);
      above_ = std::max(above_, n);
      if (n == -1 || n == 1) next[n > 0] = separation;
    }
    per_length_ = 1 / (next[1] - next[0]);
  }

  int layer(double separation) const { return static_cast<int>(std::lround(separation / step_)); }

  /// D_m [1/m] at a layer.
  double difference(int m, int n) const {
    const double first = one_sided(1, n) - one_sided(-1, n);
    if (m == 1) return first * per_length_;
    return (first + (curved(1, n) - curved(-1, n)) / (4 * share())) * per_length_;
  }
  /// N_p at a layer.
  double neighbours(int p, int n) const {
    if (p == 0) return n == 0 ? 1 : 0;
    return (n == 0 ? 2 : 0) + (one_sided(p, n) + one_sided(-p, n)) / share();
  }

 private:
  bool sees(int n) const { return n > 0 ? n <= above_ : -n <= below_; }
  /// Tributary weight H/d.
  double share() const { return below_ == 0 || above_ == 0 ? 0.5 : 1; }
  /// u_to - u_0; nothing if there is no such layer.
  double one_sided(int to, int n) const { return sees(to) ? (n == to) - (n == 0) : 0; }
  /// Second difference around the layer `at`, in both directions from it, in units of difference().
  double curved(int at, int n) const {
    return sees(2 * at) ? widths() * ((n == 2 * at) - 2 * (n == at) + (n == 0)) : 0;
  }
  /// Layers between those that D_1 takes.
  int widths() const { return sees(1) && sees(-1) ? 2 : 1; }

  double step_, per_length_;
  int below_ = 0, above_ = 0;
};

/// Axes after axis k, cyclic.
template <int d>
int axis_after(int k, int n) {
  return (k + n) % d;
}

/// Places in InteriorWeights: use(m, p, q).
template <int d, class Use>
void for_each_weight(Use&& use) {
  for (int m = 1; m <= closure_reach; ++m)
    for (int p = 0; p <= (d > 1 ? closure_reach : 0); ++p)
      for (int q = 0; q <= (d == 3 ? closure_reach : 0); ++q) use(m, p, q);
}

/// The full neighbourhood of a particle inside the infinite lattice.
template <int d>
std::vector<Neighbour<d>> full_neighbourhood(const Vec<d>& step, double R) {
  constexpr int side = 2 * closure_reach + 1;
  std::vector<Neighbour<d>> seen;
  for (int n = 0; n < (d == 1 ? side : d == 2 ? side * side : side * side * side); ++n) {
    Vec<d> X;
    for (int k = 0, rest = n; k < d; ++k, rest /= side) X[k] = (rest % side - closure_reach) * step[k];
    if (X.norm() < R * (1 - 1e-12)) seen.push_back({X, step.prod()});
  }
  return seen;
}

/// Weight of D_m N_p N_q in component k, from the stencil of a full neighbourhood: D_m has 1/(2 m step) at
/// layer m, N_p has 1 at layer p.
template <int d>
InteriorWeights weights_of(int k, const Vec<d>& step, const std::vector<Neighbour<d>>& seen,
                           const std::vector<Vec<d>>& stencil) {
  InteriorWeights weight{};
  double total = 0;
  for_each_weight<d>([&](int m, int p, int q) {
    Vec<d> X = Vec<d>::Zero();
    X[k] = m * step[k];
    if (d > 1) X[axis_after<d>(k, 1)] = p * step[axis_after<d>(k, 1)];
    if (d == 3) X[axis_after<d>(k, 2)] = q * step[axis_after<d>(k, 2)];
    for (std::size_t n = 0; n < seen.size(); ++n)
      if ((seen[n].separation - X).norm() < 0.1 * step.minCoeff())
        weight[m - 1][p][q] = 2 * m * step[k] * stencil[n][k];
    total += (p > 0 ? 2 : 1) * (q > 0 ? 2 : 1) * weight[m - 1][p][q];
  });
  if (std::abs(total - 1) > 1e-10)  // rounding of sums of some ten weights is 1e-15
    throw InputError("a start table that is not exact for affine maps",
                     "its weights are no differences along an axis times averages across",
                     "use start = \"standard\" or \"improved\" with pair = \"W1\" or \"W0\"");
  return weight;
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
    if (R * (1 - 1e-12) > (closure_reach + 1) * step) return "bonds reach beyond the second layer";
  }
  return std::nullopt;
}

template <int d>
LatticeClosure<d> lattice_closure(const Cloud<d>& cloud, const BondOptions<d>& options) {
  LatticeClosure<d> closure;
  for (int k = 0; k < d; ++k) closure.step[k] = cloud.box.size[k] / static_cast<double>(cloud.count[k] - 1);
  const auto seen = full_neighbourhood<d>(closure.step, options.kernel.support * options.smoothing_length);
  const CorrectedKernel<d> kernel = correct<d>(options.pair, options.kernel, options.smoothing_length, seen);
  const auto stencil = options.estimator(seen, kernel);
  for (int k = 0; k < d; ++k) closure.weight[k] = weights_of<d>(k, closure.step, seen, stencil);
  return closure;
}

template <int d>
double averaging(const LatticeClosure<d>& closure, int k, int m) {
  const auto& first = closure.weight[k][0];
  return m == axis_after<d>(k, 1) ? first[1][0] + 2 * first[1][1] : first[0][1] + 2 * first[1][1];
}

template <int d>
std::vector<Vec<d>> closed_stencil(const LatticeClosure<d>& closure, Neighbourhood<d> neighbours) {
  std::vector<Axis> axes;
  for (int k = 0; k < d; ++k) axes.emplace_back(closure.step[k], k, neighbours);
  std::vector<Vec<d>> c;
  c.reserve(neighbours.size());
  for (const auto& neighbour : neighbours) {
    std::array<int, d> layer;
    for (int k = 0; k < d; ++k) layer[k] = axes[k].layer(neighbour.separation[k]);
    Vec<d> row = Vec<d>::Zero();
    if (neighbour.separation.squaredNorm() > 0)
      for (int k = 0; k < d; ++k)
        for_each_weight<d>([&](int m, int p, int q) {
          const int a = axis_after<d>(k, 1), b = axis_after<d>(k, 2);
          row[k] += closure.weight[k][m - 1][p][q] * axes[k].difference(m, layer[k]) *
                    (d > 1 ? axes[a].neighbours(p, layer[a]) : 1.0) *
                    (d == 3 ? axes[b].neighbours(q, layer[b]) : 1.0);
        });
    c.push_back(row);
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
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE
template double averaging<2>(const LatticeClosure<2>&, int, int);
template double averaging<3>(const LatticeClosure<3>&, int, int);

}  // namespace plumb
