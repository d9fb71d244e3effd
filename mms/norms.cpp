#include "mms/norms.hpp"

#include <fmt/format.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "lib/geometry/neighbours.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb::mms {
namespace {

struct Node {
  double at, weight;
};

/// Gauss points of all tiles of one axis from `origin` over `length`.
std::vector<Node> gauss_nodes(double origin, double length, int tiles, int points) {
  const std::unique_ptr<gsl_integration_glfixed_table, void (*)(gsl_integration_glfixed_table*)> table(
      gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(points)),
      &gsl_integration_glfixed_table_free);
  const double tile = length / tiles;
  std::vector<Node> nodes;
  for (int k = 0; k < tiles; ++k)
    for (int p = 0; p < points; ++p) {
      Node node{};
      gsl_integration_glfixed_point(origin + k * tile, origin + (k + 1) * tile, static_cast<std::size_t>(p),
                                    &node.at, &node.weight, table.get());
      nodes.push_back(node);
    }
  return nodes;
}

/// Sums of squares, turned into norms at the end.
template <int d>
struct Sums {
  ErrorNorms sum;
  void add(const PointValue<d>& value, const PointValue<d>& exact, double weight) {
    const double error = (value.u - exact.u).squaredNorm();
    sum.l2 += weight * error;
    sum.h1 += weight * (value.gradient - exact.gradient).squaredNorm();
    sum.velocity_l2 += weight * (value.v - exact.v).squaredNorm();
    sum.stress_l2 += weight * (value.stress - exact.stress).squaredNorm();
    if (!std::isnan(sum.linf) && !(std::sqrt(error) <= sum.linf))
      sum.linf = std::sqrt(error);  // NaN enters and stays
  }
  ErrorNorms norms() const {
    return {std::sqrt(sum.l2), std::sqrt(sum.h1), sum.linf, std::sqrt(sum.velocity_l2),
            std::sqrt(sum.stress_l2)};
  }
};

template <int d>
class Interpolator {
 public:
  Interpolator(const Cloud<d>& cloud, const NodalValues<d>& values, const Interpolation<d>& how)
      : cloud_(with_images(cloud, how)),
        values_(with_image_values(cloud, values, how)),
        how_(how),
        search_(cloud_.X) {}

  PointValue<d> operator()(const Vec<d>& X) {
    search_.within(X, how_.kernel.support * how_.smoothing_length, found_);
    neighbours_.clear();
    for (const Index j : found_) neighbours_.push_back({cloud_.X[j] - X, cloud_.V[j]});
    const CorrectedKernel<d> kernel = corrected(X);
    PointValue<d> value;
    for (std::size_t k = 0; k < found_.size(); ++k) {
      const PointValue<d>& at = values_[static_cast<std::size_t>(found_[k])];
      value.u += kernel.weight[k] * at.u;
      value.gradient += at.u * kernel.gradient[k].transpose();
      value.v += kernel.weight[k] * at.v;
      value.stress += kernel.weight[k] * at.stress;
    }
    return value;
  }

 private:
  static std::vector<Ghost<d>> images(const Cloud<d>& cloud, const Interpolation<d>& how) {
    return ghosts_behind(cloud, how.walls, how.kernel.support * how.smoothing_length);
  }
  static Cloud<d> with_images(const Cloud<d>& cloud, const Interpolation<d>& how) {
    return with_ghosts(cloud, images(cloud, how));
  }
  /// Images carry what their particle has, reflected.
  static NodalValues<d> with_image_values(const Cloud<d>& cloud, const NodalValues<d>& values,
                                          const Interpolation<d>& how) {
    NodalValues<d> all = values;
    for (const auto& ghost : images(cloud, how)) {
      const PointValue<d>& real = values[static_cast<std::size_t>(ghost.real)];
      const Vec<d> signs = signs_of(ghost);
      const Mat<d> reflection = signs.asDiagonal();
      all.push_back({signs.cwiseProduct(real.u), reflection * real.gradient * reflection,
                     signs.cwiseProduct(real.v), reflection * real.stress * reflection});
    }
    return all;
  }
  CorrectedKernel<d> corrected(const Vec<d>& X) const {
    try {
      return correct<d>(how_.pair, how_.kernel, how_.smoothing_length, neighbours_);
    } catch (const InputError& error) {
      std::string where = fmt::format("{:g}", X[0]);
      for (int a = 1; a < d; ++a) where += fmt::format(", {:g}", X[a]);
      throw InputError(fmt::format("the Gauss norms do not exist: no interpolation at ({})", where),
                       error.problem(), R"(Use layout = "node", a larger beta, or quadrature = "nodal".)");
    }
  }

  Cloud<d> cloud_;
  NodalValues<d> values_;
  const Interpolation<d>& how_;
  NeighbourSearch<d> search_;
  std::vector<Index> found_;
  std::vector<Neighbour<d>> neighbours_;
};

/// Calls use(X, weight) at all Gauss points of the tiles over the box.
template <int d, class Use>
void for_gauss_points(const Box<d>& box, int tiles, int points, Use&& use) {
  std::array<std::vector<Node>, d> nodes;
  for (int a = 0; a < d; ++a)
    nodes[static_cast<std::size_t>(a)] = gauss_nodes(box.origin[a], box.size[a], tiles, points);
  const std::size_t per_axis = nodes[0].size();
  std::size_t count = 1;
  for (int a = 0; a < d; ++a) count *= per_axis;
  for (std::size_t k = 0; k < count; ++k) {
    Vec<d> X;
    double weight = 1;
    std::size_t rest = k;
    for (std::size_t a = 0; a < d; ++a, rest /= per_axis) {
      X[static_cast<int>(a)] = nodes[a][rest % per_axis].at;
      weight *= nodes[a][rest % per_axis].weight;
    }
    use(X, weight);
  }
}

}  // namespace

template <int d>
NodalValues<d> nodal_values(const Solid<d>& solid, const State<d>& state, const StressFunction<d>& stress) {
  NodalValues<d> values(solid.cloud.X.size());
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Index slot = solid.bonds.slots.of(i);
    const Mat<d> F = deformation_gradient_of(solid, state, i);
    values[static_cast<std::size_t>(i)] = {vector_at<d>(state.u, slot), F - Mat<d>::Identity(),
                                           vector_at<d>(state.v, slot), stress(F)};
  }
  return values;
}

template <int d>
void require_same_law(const NodalValues<d>& by_body, const NodalValues<d>& by_solution, double modulus) {
  double largest = modulus;
  for (const auto& value : by_solution) largest = std::max(largest, value.stress.norm());
  for (std::size_t i = 0; i < by_solution.size(); ++i) {
    if (!by_solution[i].stress.allFinite()) continue;  // of a run that failed
    const double apart = (by_body[i].stress - by_solution[i].stress).norm();
    // 1e-11: some ten products of numbers that cancel to strains of 1e-4 of their size
    if (!(apart <= 1e-11 * largest))
      throw std::logic_error(
          fmt::format("particle {}: the body has the stress {:.15g} Pa, the law of the solution {:.15g} Pa",
                      i, by_body[i].stress.norm(), by_solution[i].stress.norm()));
  }
}

template <int d>
NodalValues<d> difference(const NodalValues<d>& a, const NodalValues<d>& b) {
  NodalValues<d> out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    out[i] = {a[i].u - b[i].u, a[i].gradient - b[i].gradient, a[i].v - b[i].v, a[i].stress - b[i].stress};
  return out;
}

template <int d>
ErrorNorms nodal_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact) {
  Sums<d> sums;
  for (std::size_t i = 0; i < values.size(); ++i) sums.add(values[i], exact(cloud.X[i]), cloud.V[i]);
  return sums.norms();
}

template <int d>
ErrorNorms nodal_size(const Cloud<d>& cloud, const ExactField<d>& exact) {
  return nodal_norms<d>(cloud, NodalValues<d>(cloud.X.size()), exact);
}

template <int d>
ErrorNorms gauss_norms(const Cloud<d>& cloud, const NodalValues<d>& values, const ExactField<d>& exact,
                       const Interpolation<d>& interpolation, int tiles, int points) {
  Interpolator<d> interpolate(cloud, values, interpolation);
  Sums<d> sums;
  for_gauss_points<d>(cloud.box, tiles, points,
                      [&](const Vec<d>& X, double weight) { sums.add(interpolate(X), exact(X), weight); });
  return sums.norms();
}

template <int d>
ErrorNorms gauss_size(const Box<d>& box, const ExactField<d>& exact, int tiles, int points) {
  Sums<d> sums;
  for_gauss_points<d>(box, tiles, points,
                      [&](const Vec<d>& X, double weight) { sums.add(PointValue<d>{}, exact(X), weight); });
  return sums.norms();
}

#define PLUMBLINE_INSTANTIATE(d)                                                                       \
  template NodalValues<d> nodal_values<d>(const Solid<d>&, const State<d>&, const StressFunction<d>&); \
  template void require_same_law<d>(const NodalValues<d>&, const NodalValues<d>&, double);             \
  template NodalValues<d> difference<d>(const NodalValues<d>&, const NodalValues<d>&);                 \
  template ErrorNorms nodal_norms<d>(const Cloud<d>&, const NodalValues<d>&, const ExactField<d>&);    \
  template ErrorNorms nodal_size<d>(const Cloud<d>&, const ExactField<d>&);                            \
  template ErrorNorms gauss_norms<d>(const Cloud<d>&, const NodalValues<d>&, const ExactField<d>&,     \
                                     const Interpolation<d>&, int, int);                               \
  template ErrorNorms gauss_size<d>(const Box<d>&, const ExactField<d>&, int, int);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb::mms
