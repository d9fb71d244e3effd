#include "lib/schemes/element/element_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/core/error.hpp"
#include "lib/geometry/position_text.hpp"

namespace plumb {
namespace {

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// Gauss points and weights on [-1, 1], as many as a line of nodes has.
struct Gauss {
  std::vector<double> at, weight;
  explicit Gauss(int degree) {
    if (degree == 1) {
      at = {-std::sqrt(1.0 / 3), std::sqrt(1.0 / 3)};
      weight = {1, 1};
    } else {
      at = {-std::sqrt(0.6), 0, std::sqrt(0.6)};
      weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    }
  }
};

/// Value and slope at x of the polynomial that is 1 at node n of equal steps on [-1, 1] and 0 at the others.
std::array<double, 2> lagrange(int degree, int n, double x) {
  if (degree == 1) return {0.5 * (1 + (2 * n - 1) * x), 0.5 * (2 * n - 1)};
  if (n == 1) return {1 - x * x, -2 * x};
  const double s = n - 1;
  return {0.5 * x * (x + s), x + 0.5 * s};
}

/// Shape functions of the reference cell at its Gauss points; the first axis runs fastest.
template <int d>
struct ReferenceCell {
  int nodes, points;
  std::vector<double> weight, value;  ///< per point; per point and node
  std::vector<Vec<d>> slope;          ///< per point and node

  explicit ReferenceCell(int degree) : nodes(power(degree + 1, d)), points(nodes), weight(points, 1.0) {
    const Gauss gauss(degree);
    const auto digit = [&](int number, int k) { return number / power(degree + 1, k) % (degree + 1); };
    for (int q = 0; q < points; ++q) {
      for (int k = 0; k < d; ++k) weight[q] *= gauss.weight[digit(q, k)];
      for (int a = 0; a < nodes; ++a) {
        double N = 1;
        Vec<d> dN = Vec<d>::Ones();
        for (int k = 0; k < d; ++k) {
          const auto [of, slope_of] = lagrange(degree, digit(a, k), gauss.at[digit(q, k)]);
          N *= of;
          for (int m = 0; m < d; ++m) dN[m] *= m == k ? slope_of : of;
        }
        value.push_back(N);
        slope.push_back(dN);
      }
    }
  }
};

template <int d>
void require_lattice(const Cloud<d>& cloud, int degree) {
  const Index all = std::accumulate(cloud.count.begin(), cloud.count.end(), Index{1}, std::multiplies<>());
  const bool at_corner = cloud.size() > 0 && (cloud.X[0] - cloud.box.origin).norm() < 1e-9 * cloud.spacing;
  if (all != cloud.size() || !at_corner)
    throw InputError("elements need the nodes of a box", "their corners are the particles of a node lattice",
                     "use shape = \"box\", layout = \"node\" and no holes, or another scheme");
  for (int k = 0; k < d; ++k)
    if (cloud.count[k] < 2 || (cloud.count[k] - 1) % degree != 0)
      throw InputError(fmt::format("{} cells along {} are not an even number", cloud.count[k] - 1, "xyz"[k]),
                       "a quadratic element is two cells wide",
                       "change the spacing, or use order = \"linear\"");
}

template <int d>
void set_nodes(const Cloud<d>& cloud, int degree, ElementMesh<d>& mesh) {
  std::array<Index, d> cells;
  Index count = 1;
  for (int k = 0; k < d; ++k) count *= cells[k] = (cloud.count[k] - 1) / degree;
  for (Index c = 0; c < count; ++c) {
    Index rest = c, first = 0;
    for (int k = 0; k < d; ++k) {
      first += rest % cells[k] * degree * cloud.stride[k];
      rest /= cells[k];
    }
    for (int a = 0; a < mesh.nodes; ++a) {
      Index particle = first;
      for (int k = 0; k < d; ++k) particle += a / power(degree + 1, k) % (degree + 1) * cloud.stride[k];
      mesh.node.push_back(particle);
    }
  }
}

/// K = sum_a D_a D_a^T / |X_a - X_m|^2 V/n with D_a u = u_a - mean u - H (X_a - X_m). THEORY (15.8).
template <int d>
void add_springs(const Cloud<d>& cloud, Index cell, ElementMesh<d>& mesh) {
  const int n = mesh.nodes;
  const Index* node = &mesh.node[cell * n];
  Vec<d> middle = Vec<d>::Zero();
  for (int a = 0; a < n; ++a) middle += cloud.X[node[a]] / n;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int a = 0; a < n; ++a) {
    const Vec<d> arm = cloud.X[node[a]] - middle;
    Eigen::VectorXd D(n);
    for (int b = 0; b < n; ++b) D[b] = (a == b ? 1.0 : 0.0) - 1.0 / n - mesh.slope[cell * n + b].dot(arm);
    K += mesh.weight[cell] / (n * arm.squaredNorm()) * D * D.transpose();
  }
  mesh.springs.insert(mesh.springs.end(), K.data(), K.data() + n * n);
}

/// Weights and slopes of one cell's points.
template <int d>
void add_points(const Cloud<d>& cloud, const ReferenceCell<d>& reference, Index cell, bool one_point,
                ElementMesh<d>& mesh) {
  const int n = mesh.nodes;
  const Index* node = &mesh.node[cell * n];
  double all = 0;
  std::vector<Vec<d>> mean(n, Vec<d>::Zero());
  for (int q = 0; q < reference.points; ++q) {
    Mat<d> J = Mat<d>::Zero();
    for (int a = 0; a < n; ++a) J += cloud.X[node[a]] * reference.slope[q * n + a].transpose();
    const double weight = J.determinant() * reference.weight[q];
    if (!(weight > 0))
      throw InputError(fmt::format("the element at {} is folded", position_text<d>(cloud.X[node[0]])),
                       "its nodes have been moved too far", "use a smaller jitter");
    const Mat<d> back = J.inverse().transpose();
    all += weight;
    for (int a = 0; a < n; ++a) {
      const Vec<d> slope = back * reference.slope[q * n + a];
      mean[a] += weight * slope;
      mesh.volume[node[a]] += weight * reference.value[q * n + a];
      if (!one_point) mesh.slope.push_back(slope);
    }
    if (!one_point) mesh.weight.push_back(weight);
  }
  if (!one_point) return;
  mesh.weight.push_back(all);
  for (const Vec<d>& slope : mean) mesh.slope.push_back(slope / all);
  add_springs(cloud, cell, mesh);
}

}  // namespace

template <int d>
ElementMesh<d> make_element_mesh(const Cloud<d>& cloud, int degree, bool one_point) {
  require_lattice(cloud, degree);
  const ReferenceCell<d> reference(degree);
  ElementMesh<d> mesh;
  mesh.nodes = reference.nodes;
  mesh.points = one_point ? 1 : reference.points;
  mesh.shape = one_point ? std::vector<double>(mesh.nodes, 1.0 / mesh.nodes) : reference.value;
  mesh.volume.assign(cloud.X.size(), 0.0);
  set_nodes(cloud, degree, mesh);
  for (Index c = 0; c < mesh.cells(); ++c) add_points(cloud, reference, c, one_point, mesh);
  return mesh;
}

template ElementMesh<1> make_element_mesh<1>(const Cloud<1>&, int, bool);
template ElementMesh<2> make_element_mesh<2>(const Cloud<2>&, int, bool);
template ElementMesh<3> make_element_mesh<3>(const Cloud<3>&, int, bool);

}  // namespace plumb
