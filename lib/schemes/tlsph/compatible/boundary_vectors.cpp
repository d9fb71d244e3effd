#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

#include <Eigen/QR>
#include <cmath>

#include "lib/geometry/neighbours.hpp"

namespace plumb {
namespace {

/// Linear extrapolation from inside needs two layers of particles, so at least this ratio of h to spacing.
constexpr double least_beta = 1.2;
/// Sum of the magnitudes of weights that are taken: half a spacing beyond two particles they are 3/2 and
/// -1/2, and irregular or cut neighbourhoods add to that.
constexpr double most_amplification = 4;
/// Moments count as met: rounding of sums of some thousand terms of order 1, and below what the projection
/// asks for.
constexpr double met = 1e-13;
/// Share of a boundary vector that counts as if spread over the particles around it, where those on the
/// surface alone cannot meet the moments.
constexpr double spread = 0.1;

/// Weights at the point that are exact for linear fields, from a support that grows until they do not
/// amplify: far from the particles (in a sharp corner) those of a narrow one would be large and of both
/// signs.
template <int d>
std::vector<double> extrapolation(const Cloud<d>& cloud, const NeighbourSearch<d>& search,
                                  const RadialKernel<d>& kernel, double h, const Vec<d>& point,
                                  std::vector<Index>& found) {
  std::vector<Neighbour<d>> seen;
  for (double wide = std::max(h, least_beta * cloud.spacing);; wide *= 1.25) {
    search.within(point, kernel.support * wide, found);
    seen.clear();
    for (const Index j : found) seen.push_back({cloud.X[j] - point, cloud.V[j]});
    const bool all = found.size() == static_cast<std::size_t>(cloud.size());
    if (!all && (found.size() < (1U << d) || independent_directions<d>(seen) < d)) continue;
    auto weight = correct<d>(Correction::W1, kernel, wide, seen).weight;
    double size = 0;
    for (const double w : weight) size += std::abs(w);
    if (all || size < most_amplification) return weight;
  }
}

template <int d>
std::vector<Vec<d>> lumped(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double h,
                           const std::vector<Facet<d>>& facets) {
  std::vector<Vec<d>> B(cloud.size(), Vec<d>::Zero());
  const NeighbourSearch<d> search(cloud.X);
  std::vector<Index> found;
  for (const Facet<d>& facet : facets) {
    // 1e-9 spacings: on the face, but for the rounding of coordinates
    if (facet.depth < 1e-9 * cloud.spacing) {
      B[facet.owner] += facet.area;
      continue;
    }
    const auto weight = extrapolation<d>(cloud, search, kernel, h, facet.centroid, found);
    for (std::size_t n = 0; n < found.size(); ++n) B[found[n]] += weight[n] * facet.area;
  }
  return B;
}

/// 1, x_a, x_a x_b (a <= b) of the point, with the centroid as origin and the body's size as unit.
template <int d>
Eigen::VectorXd monomials(const Vec<d>& x) {
  Eigen::VectorXd m(1 + d + d * (d + 1) / 2);
  m[0] = 1;
  int n = 1 + d;
  for (int a = 0; a < d; ++a) {
    m[1 + a] = x[a];
    for (int b = a; b < d; ++b) m[n++] = x[a] * x[b];
  }
  return m;
}

/// What is missing in sum_i m_k(X_i) B_i: for quadratics about the centroid only the moment x_c B_c is not
/// zero, and it is the volume.
template <int d>
Eigen::MatrixXd missing_moments(const std::vector<Eigen::VectorXd>& m, const std::vector<Vec<d>>& B,
                                double volume) {
  Eigen::MatrixXd missing = Eigen::MatrixXd::Zero(m[0].size(), d);
  for (int c = 0; c < d; ++c) missing(1 + c, c) = volume;
  for (std::size_t i = 0; i < B.size(); ++i) missing -= m[i] * B[i].transpose();
  return missing;
}

/// Adds what is missing by the least change with these weights; returns what is missing then. Twice, since
/// the second pass removes the rounding of the first.
template <int d>
Eigen::MatrixXd add_missing(const std::vector<Eigen::VectorXd>& m, const std::vector<double>& weight,
                            double scale, std::vector<Vec<d>>& B) {
  Eigen::MatrixXd missing = missing_moments<d>(m, B, scale);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(missing.rows(), missing.rows());
  for (std::size_t i = 0; i < B.size(); ++i) gram += weight[i] * m[i] * m[i].transpose();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);  // moments that the surface does not tell apart (in 1D: 1 and x^2)
  solver.compute(gram);
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::MatrixXd change = solver.solve(missing);
    for (std::size_t i = 0; i < B.size(); ++i)
      if (weight[i] > 0) B[i] += weight[i] * (change.transpose() * m[i]);
    missing = missing_moments<d>(m, B, scale);
  }
  return missing;
}

/// Weights of all particles near the surface. On a circle or a sphere the particles do not tell 1 from |x|^2,
/// so that the centroid of a polyhedron beside its centre asks for some that lie inside.
template <int d>
std::vector<double> spread_weights(const Cloud<d>& cloud, std::vector<double> weight) {
  const NeighbourSearch<d> search(cloud.X);
  const std::vector<double> own = weight;
  std::vector<Index> found;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (own[i] == 0) continue;
    search.within(cloud.X[i], 2 * cloud.spacing, found);
    for (const Index j : found) weight[j] += spread * own[i] / static_cast<double>(found.size());
  }
  return weight;
}

}  // namespace

template <int d>
Surface<d> box_surface(const Cloud<d>& cloud) {
  return {box_facets(cloud), cloud.box.size.prod(), cloud.box.origin + 0.5 * cloud.box.size};
}

template <int d>
BoundaryVectors<d> boundary_vectors(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double h,
                                    const Surface<d>& surface) {
  BoundaryVectors<d> result;
  result.B = lumped<d>(cloud, kernel, h, surface.facets);
  const double size = std::pow(surface.volume, 1.0 / d);
  const double scale = surface.volume / size;  // of x B with x in units of the size
  std::vector<Eigen::VectorXd> m;
  std::vector<double> weight;
  for (Index i = 0; i < cloud.size(); ++i) {
    m.push_back(monomials<d>((cloud.X[i] - surface.centroid) / size));
    weight.push_back(result.B[i].norm());
  }
  const auto largest = [&](const Eigen::MatrixXd& missing) { return missing.cwiseAbs().maxCoeff() / scale; };
  result.defect = largest(missing_moments<d>(m, result.B, scale));
  result.remainder = largest(add_missing<d>(m, weight, scale, result.B));
  if (result.remainder > met)
    result.remainder = largest(add_missing<d>(m, spread_weights(cloud, weight), scale, result.B));
  return result;
}

template Surface<1> box_surface<1>(const Cloud<1>&);
template Surface<2> box_surface<2>(const Cloud<2>&);
template Surface<3> box_surface<3>(const Cloud<3>&);
template BoundaryVectors<1> boundary_vectors<1>(const Cloud<1>&, const RadialKernel<1>&, double,
                                                const Surface<1>&);
template BoundaryVectors<2> boundary_vectors<2>(const Cloud<2>&, const RadialKernel<2>&, double,
                                                const Surface<2>&);
template BoundaryVectors<3> boundary_vectors<3>(const Cloud<3>&, const RadialKernel<3>&, double,
                                                const Surface<3>&);

}  // namespace plumb
