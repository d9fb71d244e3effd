#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

#include <Eigen/QR>
#include <cmath>
#include <functional>

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

/// Who shares each facet.
template <int d>
std::vector<std::vector<AreaShare>> shares_of(const Cloud<d>& cloud, const RadialKernel<d>& kernel, double h,
                                              const std::vector<Facet<d>>& facets) {
  std::vector<std::vector<AreaShare>> all;
  const NeighbourSearch<d> search(cloud.X);
  std::vector<Index> found;
  for (const Facet<d>& facet : facets) {
    // 1e-9 spacings: on the face, but for the rounding of coordinates
    if (facet.depth < 1e-9 * cloud.spacing) {
      all.push_back({{facet.owner, 1}});
      continue;
    }
    const auto weight = extrapolation<d>(cloud, search, kernel, h, facet.centroid, found);
    all.emplace_back();
    for (std::size_t n = 0; n < found.size(); ++n) all.back().push_back({found[n], weight[n]});
  }
  return all;
}

template <int d>
std::vector<Vec<d>> lumped(Index particles, const std::vector<Facet<d>>& facets,
                           const std::vector<std::vector<AreaShare>>& shares) {
  std::vector<Vec<d>> B(particles, Vec<d>::Zero());
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (const AreaShare& s : shares[f]) B[s.particle] += s.share * facets[f].area;
  return B;
}

/// B_i as the sum of the sides' normals times areas.
template <int d>
std::vector<Vec<d>> vectors_of(Index particles, const std::vector<FlatSide<d>>& sides) {
  std::vector<Vec<d>> B(particles, Vec<d>::Zero());
  for (const FlatSide<d>& side : sides)
    for (const AreaShare& s : all_areas(side)) B[s.particle] += s.share * side.normal;
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

/// The sums over the areas of the sides that have a value: sum q N for every monomial q and direction, and for each side its area
/// and its first moments.
template <int d>
struct SideSums {
  const std::vector<Eigen::VectorXd>& m;
  const std::vector<FlatSide<d>>& sides;

  Index count() const { return m[0].size() * d + static_cast<Index>(sides.size()) * (1 + d); }
  /// The part that an area of 1 at a particle has in each.
  Eigen::VectorXd of(std::size_t side, const Eigen::VectorXd& q) const {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(count());
    for (int c = 0; c < d; ++c) g.segment(c * q.size(), q.size()) = sides[side].normal[c] * q;
    g.segment(d * q.size() + static_cast<Index>(side) * (1 + d), 1 + d) = q.head(1 + d);
    return g;
  }
  /// What is missing: of the body's moments as given, of a side's area and middle as far as those of its facets are known.
  Eigen::VectorXd missing(const Eigen::MatrixXd& of_body, const std::vector<Eigen::VectorXd>& middles) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count());
    for (int c = 0; c < d; ++c) right.segment(c * of_body.rows(), of_body.rows()) = of_body.col(c);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      auto part = right.segment(d * of_body.rows() + static_cast<Index>(k) * (1 + d), 1 + d);
      for (std::size_t n = 0; n < sides[k].facets.size(); ++n)
        part += sides[k].size[n] * middles[static_cast<std::size_t>(sides[k].facets[n])].head(1 + d);
      for (const AreaShare& s : all_areas(sides[k]))
        part -= s.share * m[static_cast<std::size_t>(s.particle)].head(1 + d);
    }
    return right;
  }
};

/// Adds what is missing to the areas of the sides by the least change, weighted by the areas, that gives each side its area and its
/// middle. Twice, as add_missing(). `middles`: monomials at the middles of all facets.
template <int d>
void correct_sides(const std::vector<Eigen::VectorXd>& m, const std::vector<Eigen::VectorXd>& middles,
                   const std::function<Eigen::MatrixXd(const std::vector<Vec<d>>&)>& missing,
                   std::vector<FlatSide<d>>& sides) {
  const SideSums<d> sums{m, sides};
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(sums.count(), sums.count());
  std::vector<std::vector<AreaShare>> weights;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    weights.push_back(all_areas(sides[k]));
    sides[k].correction = weights[k];
    for (AreaShare& s : sides[k].correction) {
      const Eigen::VectorXd g = sums.of(k, m[static_cast<std::size_t>(s.particle)]);
      gram += std::abs(s.share) * g * g.transpose();
      s.share = 0;
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);  // sums that the sides do not tell apart
  solver.compute(gram);
  for (int pass = 0; pass < 2; ++pass) {
    const auto B = vectors_of(static_cast<Index>(m.size()), sides);
    const Eigen::VectorXd change = solver.solve(sums.missing(missing(B), middles));
    for (std::size_t k = 0; k < sides.size(); ++k)
      for (std::size_t n = 0; n < weights[k].size(); ++n)
        sides[k].correction[n].share +=
            std::abs(weights[k][n].share) *
            change.dot(sums.of(k, m[static_cast<std::size_t>(weights[k][n].particle)]));
  }
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
  auto shares = shares_of<d>(cloud, kernel, h, surface.facets);
  result.B = lumped<d>(cloud.size(), surface.facets, shares);
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
  if (auto sides = flat_sides(surface.facets, cloud.spacing)) {
    for (FlatSide<d>& side : *sides)
      for (const Index f : side.facets) side.shares.push_back(std::move(shares[f]));
    const auto missing = [&](const std::vector<Vec<d>>& B) { return missing_moments<d>(m, B, scale); };
    std::vector<Eigen::VectorXd> middles;
    for (const Facet<d>& facet : surface.facets)
      middles.push_back(monomials<d>((facet.centroid - surface.centroid) / size));
    if (result.defect > met) {
      correct_sides<d>(m, middles, missing, *sides);
      const auto B = vectors_of(cloud.size(), *sides);
      result.remainder = largest(missing(B));
      if (result.remainder <= met) return {B, result.defect, result.remainder, std::move(*sides)};
    } else {
      result.sides = std::move(*sides);  // what the next lines take off is round-off
    }
  }
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
