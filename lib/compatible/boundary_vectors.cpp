#include "plumbline/compatible/boundary_vectors.hpp"

#include <Eigen/QR>
#include <cmath>

#include "plumbline/geometry/neighbours.hpp"

namespace plumb {
namespace {

/// Linear extrapolation from inside needs two layers of particles, so at least this ratio of h to spacing.
constexpr double least_beta = 1.2;

template <int d>
std::vector<Vec<d>> lumped(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double h,
                           const std::vector<Facet<d>>& facets) {
  std::vector<Vec<d>> B(cloud.size(), Vec<d>::Zero());
  const NeighbourSearch<d> search(cloud.X);
  const double wide = std::max(h, least_beta * cloud.spacing);
  std::vector<Index> found;
  std::vector<Neighbour<d>> seen;
  for (const Facet<d>& facet : facets) {
    // 1e-9 spacings: on the face, but for the rounding of coordinates
    if (facet.depth < 1e-9 * cloud.spacing) {
      B[facet.owner] += facet.area;
      continue;
    }
    search.within(facet.centroid, kernel.support * wide, found);
    seen.clear();
    for (const Index j : found) seen.push_back({cloud.X[j] - facet.centroid, cloud.V[j]});
    const CorrectedKernel<d> shape = correct<d>(Pair::W1, kernel, wide, seen);
    for (std::size_t n = 0; n < found.size(); ++n) B[found[n]] += shape.weight[n] * facet.area;
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
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(1 + d + d * (d + 1) / 2, 1 + d + d * (d + 1) / 2);
  for (Index i = 0; i < cloud.size(); ++i) {
    m.push_back(monomials<d>((cloud.X[i] - surface.centroid) / size));
    gram += result.B[i].norm() * m[i] * m[i].transpose();
  }
  Eigen::MatrixXd missing = missing_moments<d>(m, result.B, scale);
  result.defect = missing.cwiseAbs().maxCoeff() / scale;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);  // moments that the surface does not tell apart (in 1D: 1 and x^2)
  solver.compute(gram);
  for (int pass = 0; pass < 2; ++pass) {  // the second one removes the rounding of the first
    const Eigen::MatrixXd change = solver.solve(missing);
    for (Index i = 0; i < cloud.size(); ++i) {
      const double weight = result.B[i].norm();
      if (weight > 0) result.B[i] += weight * (change.transpose() * m[i]);
    }
    missing = missing_moments<d>(m, result.B, scale);
  }
  result.remainder = missing.cwiseAbs().maxCoeff() / scale;
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
