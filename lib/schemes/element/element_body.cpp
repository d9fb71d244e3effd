#include "lib/schemes/element/element_body.hpp"

#include <algorithm>
#include <cmath>

#include "lib/linear/dense.hpp"
#include "lib/material/laws.hpp"
#include "lib/material/tangent.hpp"
#include "lib/schemes/gather.hpp"

namespace plumb {
namespace {

/// A vector per node, one row each.
template <int d>
using PerNode = Eigen::Matrix<double, Eigen::Dynamic, d, d == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

using Triplets = std::vector<Eigen::Triplet<double>>;

template <class Rows>
Rows built(Index rows, Index columns, const Triplets& entries) {
  Rows m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

/// Calls use(point, node's number in the cell, node) for all nodes of all points.
template <int d, class Use>
void for_each_share(const ElementMesh<d>& mesh, Use&& use) {
  for (Index q = 0; q < mesh.cells() * mesh.points; ++q)
    for (int a = 0; a < mesh.nodes; ++a) use(q, a, mesh.node[q / mesh.points * mesh.nodes + a]);
}

template <int d>
void set_matrices(ElementBody<d>& body, double hourglass_modulus) {
  const ElementMesh<d>& mesh = body.mesh;
  const Index nodes = body.cloud.size(), points = body.points();
  using Rows = typename ElementBody<d>::Rows;
  Triplets slopes, mean, springs;
  std::vector<double> sum(static_cast<std::size_t>(nodes), 0.0);
  const auto share = [&](Index q, int a) {
    return mesh.weight[q] * mesh.shape[q % mesh.points * mesh.nodes + a];
  };
  for_each_share(mesh, [&](Index q, int a, Index i) {
    for (int m = 0; m < d; ++m) slopes.emplace_back(d * q + m, i, mesh.slope[q * mesh.nodes + a][m]);
    sum[i] += share(q, a);
  });
  for_each_share(mesh, [&](Index q, int a, Index i) { mean.emplace_back(i, q, share(q, a) / sum[i]); });
  const Index n = mesh.nodes;
  for (Index c = 0; c < mesh.cells() && hourglass_modulus > 0; ++c)
    for (Index ab = 0; ab < n * n; ++ab)
      springs.emplace_back(mesh.node[c * n + ab / n], mesh.node[c * n + ab % n],
                           hourglass_modulus * mesh.springs[c * n * n + ab]);
  body.slopes = built<Rows>(d * points, nodes, slopes);
  body.mean = built<Rows>(nodes, points, mean);
  body.springs = built<Rows>(nodes, nodes, springs);
  Rows weighted = body.slopes;
  for (Index row = 0; row < weighted.rows(); ++row) weighted.row(row) *= mesh.weight[row / d];
  body.forces = weighted.transpose();
}

/// Stiffness of one cell at the reference over its lumped masses, from both sides.
template <int d>
Eigen::MatrixXd scaled_stiffness(const ElementBody<d>& body, const Tangent<d>& tangent, Index cell) {
  const ElementMesh<d>& mesh = body.mesh;
  const int n = mesh.nodes;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(d * n, d * n);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(d * n);
  for (int p = 0; p < mesh.points; ++p) {
    const Index q = cell * mesh.points + p;
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(d * d, d * n);
    for (int a = 0; a < n; ++a)
      for (int k = 0; k < d; ++k) {
        G.block<d, 1>(k * d, d * a + k) = mesh.slope[q * n + a];
        mass[d * a + k] += body.elastic.density * mesh.weight[q] * mesh.shape[p * n + a];
      }
    K += mesh.weight[q] * G.transpose() * tangent * G;
  }
  if (mesh.points == 1 && body.springs.nonZeros() > 0)
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        K.block<d, d>(d * a, d * b).diagonal().array() +=
            body.hourglass_modulus * mesh.springs[(cell * n + a) * n + b];
  const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
  return root.asDiagonal() * K * root.asDiagonal();
}

}  // namespace

template <int d>
Field ElementBody<d>::gradients(const Eigen::VectorXd& u) const {
  const PerNode<d> slope = slopes * Eigen::Map<const PerNode<d>>(u.data(), cloud.size(), d);
  Field F(d * d, points(), 0);
#pragma omp parallel for schedule(static)
  for (Index q = 0; q < points(); ++q)
    for (int k = 0; k < d; ++k)
      for (int m = 0; m < d; ++m) F[d * k + m][q] = slope(d * q + m, k) + (k == m ? 1 : 0);
  return F;
}

template <int d>
Field ElementBody<d>::nodal_gradients(const Field& F) const {
  Field at_nodes(d * d, cloud.size(), 0);
  for (int n = 0; n < d * d; ++n)
    Eigen::Map<Eigen::VectorXd>(at_nodes[n], cloud.size()) =
        mean * Eigen::Map<const Eigen::VectorXd>(F[n], points());
  return at_nodes;
}

template <int d>
std::optional<Trouble> ElementBody<d>::trouble(const Field& F) const {
  for (Index q = 0; q < points(); ++q) {
    Mat<d> at;
    for (int m = 0; m < d * d; ++m) at(m / d, m % d) = F[m][q];
    if (const double J = determinant<d, double>(at); !(J > 0))
      return Trouble{mesh.node[q / mesh.points * mesh.nodes], "determinant of F", J};
  }
  return std::nullopt;
}

template <int d>
Eigen::VectorXd ElementBody<d>::residual(const Eigen::VectorXd& u, const Field& F) const {
  constexpr Index at_once = 256;  // points in one thread's piece
  const MixedState<d> nothing;
  const MixedState<d>& remembered = memory ? *memory : nothing;
  Field P(d * d, points(), 0);
  PerNode<d> stress(d * points(), d);
#pragma omp parallel for schedule(static)
  for (Index first = 0; first < points(); first += at_once) {
    const Index end = std::min(first + at_once, points());
    law.stress(remembered, F, first, end, P);
    for (Index q = first; q < end; ++q)
      for (int k = 0; k < d; ++k)
        for (int m = 0; m < d; ++m) stress(d * q + m, k) = P[d * k + m][q];
  }
  PerNode<d> force = forces * stress;
  if (springs.nonZeros() > 0) force += springs * Eigen::Map<const PerNode<d>>(u.data(), cloud.size(), d);
  return Eigen::Map<const Eigen::VectorXd>(force.data(), force.size());
}

template <int d>
double ElementBody<d>::strain_energy(const Field& F) const {
  return law.energy(memory ? *memory : MixedState<d>(), F, mesh.weight.data(), 0, points());
}

template <int d>
double ElementBody<d>::potential(const Field& F) const {
  return memory ? law.potential(*memory, F, mesh.weight.data(), 0, points()) : strain_energy(F);
}

template <int d>
Tangent<d> ElementBody<d>::tangent_at(const Mat<d>& F, Index point) const {
  return memory ? law.tangent(*memory, F, point) : tangent(F);
}

template <int d>
void ElementBody<d>::commit(const Field& F) const {
  if (memory) law.commit(*memory, F, 0, points());
}

template <int d>
double ElementBody<d>::hourglass_energy(const Eigen::VectorXd& u) const {
  if (springs.nonZeros() == 0) return 0;
  const Eigen::Map<const PerNode<d>> at(u.data(), cloud.size(), d);
  const PerNode<d> pull = springs * at;
  return 0.5 * pull.cwiseProduct(at).sum();
}

template <int d>
double ElementBody<d>::highest_frequency() const {
  const Tangent<d> stiffness = tangent_at(Mat<d>::Identity(), 0);
  double most = 0;
  Eigen::MatrixXd last;
  for (Index c = 0; c < mesh.cells(); ++c) {
    const Eigen::MatrixXd K = scaled_stiffness(*this, stiffness, c);
    constexpr double same = 1e-9;  // cells of a lattice differ by rounding
    if (c > 0 && (K - last).norm() <= same * K.norm()) continue;
    most = std::max(most, symmetric_values(K).maxCoeff());
    last = K;
  }
  return std::sqrt(most);
}

template <int d>
ElementBody<d> make_element_body(Specimen<d> specimen, const ElementOptions& options) {
  ElementBody<d> body;
  body.law = block_law<d>(specimen.law, specimen.elastic, false);
  if (!body.law.tangent)
    with_elastic_law<d>(specimen.law, specimen.elastic, [&](const auto& law) {
      body.tangent = [law](const Mat<d>& F) { return tangent_of<d>(law, F); };
    });
  body.elastic = in_dimension(d, specimen.elastic, specimen.law.plane);
  body.mesh = make_element_mesh(specimen.cloud, options.degree(), options.one_point());
  body.cloud = std::move(specimen.cloud);
  body.cloud.V = body.mesh.volume;
  body.hourglass_modulus = options.one_point() ? options.alpha * body.elastic.shear_modulus() : 0;
  set_matrices(body, body.hourglass_modulus);
  if (body.law.history_components > 0) {
    body.memory = std::make_shared<MixedState<d>>();
    body.memory->history = Field(body.law.history_components, body.points(), 0);
    start_history<d>(specimen.law, *body.memory, body.points());
  }
  return body;
}

template struct ElementBody<1>;
template struct ElementBody<2>;
template struct ElementBody<3>;
template ElementBody<1> make_element_body<1>(Specimen<1>, const ElementOptions&);
template ElementBody<2> make_element_body<2>(Specimen<2>, const ElementOptions&);
template ElementBody<3> make_element_body<3>(Specimen<3>, const ElementOptions&);

}  // namespace plumb
