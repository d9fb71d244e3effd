// The projection against a plain one: all constraints as one dense matrix, and its solution of least norm by
// an orthogonal decomposition, in long double. No normal equations, no multipliers, no solver of the library.
#include <Eigen/QR>

#include "tests/support/clouds.hpp"
#include "tests/support/compatible.hpp"
#include "tests/support/typed.hpp"

namespace plumb::oracle_test {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double beta = 0.9;

/// The cubic spline over its value at 0.
Real weight(Real q) {
  return q < 1 ? 1 - 1.5L * q * q + 0.75L * q * q * q : (2 - q) * (2 - q) * (2 - q) / 4;
}

/// The part of the surface of the box that is nearest to a node of a lattice of spacing 1, outward: 1 inside
/// a face, one half at its edges, one quarter at its corners.
template <int d>
Vec<d> share_of_surface(const Box<d>& box, const Vec<d>& X) {
  Vec<d> B = Vec<d>::Zero();
  const auto side = [&](int k) {
    return X[k] == box.origin[k] ? -1 : X[k] == box.origin[k] + box.size[k] ? 1 : 0;
  };
  for (int k = 0; k < d; ++k) {
    B[k] = side(k);
    for (int other = 0; other < d; ++other)
      if (other != k && side(other) != 0) B[k] /= 2;
  }
  return B;
}

template <int d>
struct Pair {
  Index i, j;
  Vec<d> X;   ///< X_ij
  Vec<d> A0;  ///< THEORY (11.3)
  Real weight;
};

template <int d>
std::vector<Pair<d>> pairs_of(const Cloud<d>& cloud) {
  const auto bonds = testing::all_bonds<d>(cloud, testing::options<d>({.beta = beta}, 1));
  std::vector<Pair<d>> pairs;
  for (Index i = 0; i < cloud.size(); ++i)
    for (const auto& ij : bonds[i])
      for (const auto& ji : bonds[ij.other])
        if (i < ij.other && ji.other == i)
          pairs.push_back({i, ij.other, cloud.X[ij.other] - cloud.X[i],
                           cloud.V[i] * ij.stencil - cloud.V[ij.other] * ji.stencil,
                           weight(ij.separation.norm() / beta)});
  return pairs;
}

template <int d>
struct Answer {
  std::vector<Vec<d>> A;  ///< of every pair
  std::vector<double> V;
};

/// (11.1), (11.2) as C z = r, z = z0 + D y with D^2 the weights: y is the solution of least norm of
/// C D y = r - C z0. With volume_weight = 0 the volumes are those of the cloud.
template <int d>
Answer<d> plain_projection(const Cloud<d>& cloud, const std::vector<Vec<d>>& B,
                           const std::vector<Pair<d>>& pairs, double volume_weight) {
  const auto n = cloud.size(), m = static_cast<Index>(pairs.size());
  Matrix C = Matrix::Zero(n * d * (d + 1), m * d + n);
  Vector r = Vector::Zero(C.rows()), z(C.cols()), D(C.cols());
  const auto closed = [](Index i, int a) { return (i * d + a) * (d + 1); };
  const auto exact = [&](Index i, int a, int b) { return closed(i, a) + 1 + b; };
  for (Index p = 0; p < m; ++p) {
    const Pair<d>& pair = pairs[p];
    for (int a = 0; a < d; ++a) {
      z[p * d + a] = pair.A0[a];
      D[p * d + a] = std::sqrt(pair.weight);
      C(closed(pair.i, a), p * d + a) = 1;
      C(closed(pair.j, a), p * d + a) = -1;  // A_ji = -A_ij, X_ji = -X_ij
      for (int b = 0; b < d; ++b)
        C(exact(pair.i, a, b), p * d + a) = C(exact(pair.j, a, b), p * d + a) = Real(pair.X[b]) / 2;
    }
  }
  for (Index i = 0; i < n; ++i) {
    z[m * d + i] = cloud.V[i];
    D[m * d + i] = std::sqrt(Real(volume_weight));
    for (int a = 0; a < d; ++a) {
      r[closed(i, a)] = -B[i][a];
      C(exact(i, a, a), m * d + i) = -1;
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Matrix> solver;
  // singular values are 1e-5 (volumes) and more, or zero to 1e-18
  solver.setThreshold(1e-12L);
  const Vector y = solver.compute(C * D.asDiagonal()).solve(r - C * z);
  z += D.cwiseProduct(y);
  EXPECT_LT((C * z - r).cwiseAbs().maxCoeff(), 1e-14);
  Answer<d> answer;
  for (Index p = 0; p < m; ++p) answer.A.push_back(z.template segment<d>(p * d).template cast<double>());
  for (Index i = 0; i < n; ++i) answer.V.push_back(static_cast<double>(z[m * d + i]));
  return answer;
}

template <class Case>
class ProjectionOracle : public ::testing::Test {};
using Kinds = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(ProjectionOracle, Kinds, test::Names);

TYPED_TEST(ProjectionOracle, GivesTheSameAreaVectors) {
  constexpr int d = TypeParam::d;
  std::array<Index, d> cells;
  cells.fill(d == 2 ? 6 : 2);
  cells[0] += 1;
  Box<d> box{Vec<d>::Zero(), Vec<d>::Zero()};
  for (int k = 0; k < d; ++k) box.size[k] = static_cast<double>(cells[k]);
  for (const double jitter : {0.0, 0.2})
    for (const double weight : {CompatibleOptions<d>{}.volume_weight, 1e-2, 0.0}) {
      SCOPED_TRACE("jitter " + std::to_string(jitter) + ", volumes " + std::to_string(weight));
      Cloud<d> cloud = lattice<d>(box, cells, Layout::node);
      if (jitter > 0) cloud = jittered<d>(cloud, jitter, 3, Layout::node);
      const auto pairs = pairs_of(cloud);
      CompatibleOptions<d> how;
      how.volume_weight = weight;
      const auto p = testing::projected<d>(cloud, box_surface<d>(cloud), beta, how);
      if (weight == 0) cloud.V = p.cloud.V;  // with the body's volume and centroid
      const auto plain = plain_projection<d>(cloud, p.boundary, pairs, weight);
      double wrong_A = 0, wrong_V = 0, wrong_B = 0, change = 0;
      for (std::size_t n = 0; n < pairs.size(); ++n)
        for (const auto& ij : p.bonds[pairs[n].i])
          if (ij.other == pairs[n].j) {
            wrong_A = std::max(wrong_A, (2 * p.cloud.V[pairs[n].i] * ij.stencil - plain.A[n]).norm());
            change = std::max(change, (plain.A[n] - pairs[n].A0).norm());
          }
      for (Index i = 0; i < cloud.size(); ++i) {
        wrong_V = std::max(wrong_V, std::abs(p.cloud.V[i] - plain.V[i]));
        wrong_B = std::max(wrong_B, (p.boundary[i] - share_of_surface(cloud.box, cloud.X[i])).norm());
      }
      EXPECT_LT(wrong_B, 1e-11);  // voro++'s tolerance
      EXPECT_LT(wrong_A, 1e-12);  // the promise of the constraints
      EXPECT_LT(wrong_V, 1e-12);
      EXPECT_GT(change, 1e-2);  // or there was nothing to be found
    }
}

}  // namespace
}  // namespace plumb::oracle_test
