// The two solvers of the projection, and the parts of the iterative one. THEORY chapter 11.
#include <gtest/gtest.h>
#include <omp.h>

#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/compatible/solver/conjugate_gradients.hpp"
#include "lib/schemes/tlsph/compatible/solver/least_change.hpp"
#include "lib/schemes/tlsph/compatible/solver/quadratic_fields.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/compatible.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

/// A start table with boundary vectors that obey the divergence theorem; volumes are those of the box.
template <int d>
AreaTable<d> start_table(const Cloud<d>& cloud, double beta = 0.9) {
  const BondOptions<d> options = testing::options<d>({.beta = beta}, cloud.spacing);
  auto bonds = testing::all_bonds<d>(cloud, options);
  const auto boundary =
      boundary_vectors<d>(cloud, options.kernel, options.smoothing_length, box_surface<d>(cloud));
  return area_table<d>(cloud, bonds, options.kernel, options.smoothing_length, boundary.B);
}

/// Large enough for a V-cycle of more than one spline level, small enough for the direct solver.
template <int d>
Cloud<d> block(double jitter, Index n = d == 2 ? 60 : 14) {
  std::array<Index, d> cells;
  cells.fill(n);
  cells[0] = n - 3;
  Box<d> box{Vec<d>::Constant(-0.3), Vec<d>::Constant(static_cast<double>(n))};
  box.size[0] -= 3;
  const Cloud<d> cloud = lattice<d>(box, cells, Layout::node);
  return jitter > 0 ? jittered<d>(cloud, jitter, 7, Layout::node) : cloud;
}

using Kinds = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
template <class Case>
class ProjectionSolvers : public ::testing::Test {};
TYPED_TEST_SUITE(ProjectionSolvers, Kinds, test::Names);

/// All area vectors, and what was done.
template <int d>
std::pair<std::vector<Vec<d>>, CompatibleReport> area_vectors(Cloud<d> cloud, double beta, double weight,
                                                              ProjectionSolver solver) {
  const BondOptions<d> options = testing::options<d>({.beta = beta}, cloud.spacing);
  auto bonds = testing::all_bonds<d>(cloud, options);
  CompatibleOptions<d> how;
  how.volume_weight = weight;
  how.solver = solver;
  const auto report = make_compatible<d>(cloud, bonds, options.kernel, options.smoothing_length, how);
  std::vector<Vec<d>> A;
  for (Index i = 0; i < cloud.size(); ++i)
    for (const auto& ij : bonds[i]) A.push_back(2 * cloud.V[i] * ij.stencil);
  return {A, report};
}

// The least change is one table, whichever way it is found; the multipliers are not unique.
TYPED_TEST(ProjectionSolvers, FindTheSameTable) {
  constexpr int d = TypeParam::d;
  const Index n = d == 2 ? 60 : 10;  // factors of larger ones take seconds
  for (const auto& [jitter, beta] : {std::pair{0.0, 1.2}, std::pair{0.2, 0.9}})
    for (const double weight : {0.0, CompatibleOptions<d>{}.volume_weight}) {
      SCOPED_TRACE("jitter " + std::to_string(jitter) + ", volumes " + std::to_string(weight));
      const auto [direct, a] = area_vectors<d>(block<d>(jitter, n), beta, weight, ProjectionSolver::direct);
      const auto [iterated, b] =
          area_vectors<d>(block<d>(jitter, n), beta, weight, ProjectionSolver::iterative);
      EXPECT_LT(a.residual, 1e-12);  // what is promised
      EXPECT_LT(b.residual, 1e-12);
      EXPECT_GE(b.levels, 2);
      EXPECT_GT(a.start_residual, 1e-2);
      double difference = 0;
      for (std::size_t k = 0; k < direct.size(); ++k)
        difference = std::max(difference, (direct[k] - iterated[k]).norm());
      // residuals of 1e-12 over the root of the smallest eigenvalue, (1/60)^6 and (1/10)^6 of order 1
      EXPECT_LT(difference, 1e-12 * (d == 2 ? 216000 : 1000));
    }
}

/// The factors come from libraries that keep work space for the whole process.
TEST(ProjectionSolversSideBySide, GiveTheSameBits) {
  const Cloud<2> cloud = block<2>(0.2, 12);
  const AreaTable<2> start = start_table(cloud);
  const auto solved = [&] {
    AreaTable<2> table = start;
    least_change(table, cloud.X, 1e-3, ProjectionSolver::direct);
    std::vector<double> bits = table.volume;
    for (const auto& pair : table.pairs) bits.insert(bits.end(), {pair.A[0], pair.A[1]});
    return bits;
  };
  const std::vector<double> alone = solved();
  int others = 0;
#pragma omp parallel for num_threads(4) schedule(dynamic) reduction(+ : others)
  for (int n = 0; n < 400; ++n) others += solved() != alone;
  EXPECT_EQ(others, 0);
}

TYPED_TEST(ProjectionSolvers, SmallCloudsOfAllKinds) {
  constexpr int d = TypeParam::d;
  for (const auto& [name, cloud] : test::all_clouds<d>(1.0))
    for (const double beta : {0.9, 1.2}) {
      if (beta == 0.9 && name.ends_with("lattice")) continue;  // see IsChosenByWhatItCanDo
      SCOPED_TRACE(name + ", beta " + std::to_string(beta));
      AreaTable<d> direct = start_table(cloud, beta), iterated = direct;
      const auto a = least_change(direct, cloud.X, 1e-3, ProjectionSolver::direct);
      const auto b = least_change(iterated, cloud.X, 1e-3, ProjectionSolver::iterative);
      EXPECT_LT(a.residual, 1e-12);
      EXPECT_LT(b.residual, 1e-12);
      for (std::size_t n = 0; n < direct.pairs.size(); ++n)
        EXPECT_LT((direct.pairs[n].A - iterated.pairs[n].A).norm(), 1e-12 * 512);  // (1/8)^-3
      for (Index i = 0; i < cloud.size(); ++i) EXPECT_NEAR(direct.volume[i], iterated.volume[i], 1e-12 * 512);
    }
}

TYPED_TEST(ProjectionSolvers, GiveTheSameBitsForAnyNumberOfThreads) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = block<d>(0.2, d == 2 ? 40 : 12);
  AreaTable<d> one = start_table(cloud), three = one;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  least_change(one, cloud.X, 1e-5, ProjectionSolver::iterative);
  omp_set_num_threads(3);
  least_change(three, cloud.X, 1e-5, ProjectionSolver::iterative);
  omp_set_num_threads(before);
  bool same = one.volume == three.volume;
  for (std::size_t n = 0; n < one.pairs.size(); ++n) same = same && one.pairs[n].A == three.pairs[n].A;
  EXPECT_TRUE(same);
}

// Iterations where they serve, factors where they do not: small clouds, 2D, and lattices whose bonds reach no
// second layer.
TEST(ProjectionSolver, IsChosenByWhatItCanDo) {
  const auto chosen = [](Index n, double jitter, double beta) {
    Cloud<3> cloud =
        lattice<3>({Vec<3>::Zero(), Vec<3>::Constant(static_cast<double>(n))}, {n, n, n}, Layout::node);
    if (jitter > 0) cloud = jittered<3>(cloud, jitter, 7, Layout::node);
    const auto report = area_vectors<3>(cloud, beta, 1e-7, ProjectionSolver::automatic).second;
    EXPECT_LT(report.residual, 1e-12);
    return report.iterations > 0;
  };
  EXPECT_TRUE(chosen(12, 0.2, 0.9));
  EXPECT_TRUE(chosen(12, 0, 1.2));
  EXPECT_FALSE(chosen(12, 0, 0.9));
  EXPECT_FALSE(chosen(6, 0.2, 0.9));
  EXPECT_EQ(area_vectors<2>(block<2>(0.2), 0.9, 1e-7, ProjectionSolver::automatic).second.iterations, 0);
}

template <int d>
Multipliers<d> random_multipliers(std::size_t count, std::uint64_t seed) {
  test::Numbers numbers(seed);
  Multipliers<d> x(count, MultiplierBlock<d>::Zero());
  for (auto& block : x)
    for (int a = 0; a < d; ++a)
      for (int b = 0; b <= d; ++b) block(a, b) = numbers.next();
  return x;
}

template <int d>
double dot(const Multipliers<d>& x, const Multipliers<d>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i].cwiseProduct(y[i]).sum();
  return sum;
}

// Applied bond by bond or as a sparse matrix, volumes included.
TYPED_TEST(ProjectionSolvers, OperatorIsTheNormalMatrix) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::all_clouds<d>(1.0)[2].cloud;
  const AreaTable<d> table = start_table(cloud);
  const auto N = bond_operator<d>(table, cloud.X, 0.1);
  const auto matrix = normal_matrix(table, N);
  const auto x = random_multipliers<d>(cloud.X.size(), 3);
  Multipliers<d> y(x.size());
  apply(N, x, y);
  Eigen::VectorXd packed(matrix.rows());
  for (Index i = 0; i < cloud.size(); ++i)
    for (int a = 0; a < d; ++a) packed.segment<d + 1>((i * d + a) * (d + 1)) = x[i].row(a).transpose();
  packed = (matrix.template selfadjointView<Eigen::Lower>() * packed).eval();
  for (Index i = 0; i < cloud.size(); ++i)
    for (int a = 0; a < d; ++a)
      EXPECT_LT((packed.segment<d + 1>((i * d + a) * (d + 1)) - y[i].row(a).transpose()).norm(),
                1e-13);  // sums of some 30 terms of order 1
}

// The null space on any cloud: all fields of degree 2 if volumes are fixed, otherwise those without
// divergence.
TYPED_TEST(ProjectionSolvers, QuadraticFields) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = test::all_clouds<d>(1.0)[3].cloud;
  const AreaTable<d> table = start_table(cloud);
  for (const double weight : {0.0, 0.1}) {
    const auto N = bond_operator<d>(table, cloud.X, weight);
    const auto fields = quadratic_fields<d>(N);
    test::Numbers numbers(4);
    Multipliers<d> x(cloud.X.size(), MultiplierBlock<d>::Zero()), y = x, z = x;
    Eigen::Matrix<double, QuadraticFields<d>::scalars, d> c;
    for (double& value : c.reshaped()) value = numbers.next();
    for (Index i = 0; i < cloud.size(); ++i) x[i].template topRows<d>() = (fields.at(N.X[i]) * c).transpose();
    apply(N, x, y);
    EXPECT_GT(largest<d>(x), 0.1);
    if (weight == 0) {
      EXPECT_LT(largest<d>(y), 1e-13);
    } else {
      EXPECT_GT(largest<d>(y), 1e-3);
    }
    remove_null_part<d>(fields, N.X, x);
    apply(N, x, z);
    for (std::size_t i = 0; i < x.size(); ++i) z[i] -= y[i];
    EXPECT_LT(largest<d>(z), 1e-12);  // what was taken away had no image
    if (weight == 0) {
      EXPECT_LT(largest<d>(x), 1e-12);
    }
  }
}

// Spline levels: P^T N P by its entries and by its factors, and again from one grid to the next.
TYPED_TEST(ProjectionSolvers, SplineMatricesAreGalerkinProducts) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = block<d>(0.2);
  const auto N = bond_operator<d>(start_table(cloud), cloud.X, 0);
  const auto all = multilevel<d>(N);
  ASSERT_GE(all.levels.size(), 2U);
  test::Numbers numbers(5);
  const SplineMatrix<d> fine = spline_matrix<d>(N, all.levels[0].grid, all.by_cell);
  Coefficients<d> c(fine.grid.places, Coefficient<d>::Zero()), by_entries = c, by_factors = c;
  for (const Index p : fine.places)
    for (int a = 0; a < d; ++a) c[p][a] = numbers.next();
  apply(fine, c, by_entries);
  Multipliers<d> x(cloud.X.size(), MultiplierBlock<d>::Zero()), Nx = x;
  add_prolonged<d>(fine.grid, N.X, c, x);
  apply_bonds(N, x, Nx);
  restrict_to<d>(fine.grid, N.X, all.by_cell, Nx, by_factors);
  for (const Index p : fine.places) EXPECT_LT((by_entries[p] - by_factors[p]).norm(), 1e-12);

  const SplineMatrix<d> coarse = coarser(fine);
  Coefficients<d> k(coarse.grid.places, Coefficient<d>::Zero()), coarse_entries = k, coarse_factors = k;
  for (const Index p : coarse.places)
    for (int a = 0; a < d; ++a) k[p][a] = numbers.next();
  apply(coarse, k, coarse_entries);
  for (auto& value : c) value.setZero();
  add_refined(coarse.grid, k, fine.grid, c);
  apply(fine, c, by_entries);
  coarsen(fine.grid, by_entries, coarse.grid, coarse_factors);
  double most = 0;
  for (const Index p : coarse.places) {
    EXPECT_LT((coarse_entries[p] - coarse_factors[p]).norm(), 1e-12);
    most = std::max(most, coarse_entries[p].norm());
  }
  EXPECT_GT(most, 1e-4);
}

/// <e, N e> / <x, N x> of e = x - M N x: what one round leaves of the error x, in the measure of conjugate
/// gradients.
template <int d>
double left_of_error(const BondOperator<d>& N, const Multipliers<d>& x) {
  const auto all = multilevel<d>(N);
  auto work = work_for(all);
  Multipliers<d> r(x.size()), z(x.size()), Ne(x.size());
  apply(N, x, r);
  precondition(N, all, r, work, z);
  for (std::size_t i = 0; i < x.size(); ++i) z[i] = x[i] - z[i];
  apply(N, z, Ne);
  return dot<d>(z, Ne) / dot<d>(x, r);
}

/// l = f(X) e_a for all a, L = grad l, with a monomial f of coordinates in (0, 1) or so.
template <int d>
Multipliers<d> monomials(const std::vector<Vec<d>>& X, double size, int power) {
  Multipliers<d> x(X.size(), MultiplierBlock<d>::Zero());
  for (std::size_t i = 0; i < X.size(); ++i)
    for (int a = 0; a < d; ++a) {
      const double t = X[i][a] / size, s = X[i][(a + 1) % d] / size;
      x[i](a, 0) = std::pow(t, power) * (1 + s);
      x[i](a, 1 + a) = power * std::pow(t, power - 1) * (1 + s) / size;
      x[i](a, 1 + (a + 1) % d) = std::pow(t, power) / size;
    }
  return x;
}

// What varies from particle to particle is smoothed, what does not is found on the grids; the coarsest of
// them sees the volumes too, without which fields of degree 2 would never be found.
TYPED_TEST(ProjectionSolvers, VCycleReducesEveryError) {
  constexpr int d = TypeParam::d;
  const Cloud<d> cloud = block<d>(0.2);
  const double size = cloud.box.size[0];
  for (const double weight : {0.0, CompatibleOptions<d>{}.volume_weight}) {
    const auto N = bond_operator<d>(start_table(cloud), cloud.X, weight);
    EXPECT_LT(left_of_error<d>(N, random_multipliers<d>(cloud.X.size(), 6)), 0.5);
    EXPECT_LT(left_of_error<d>(N, monomials<d>(N.X, size, 3)), 0.1);
    if (weight > 0) {
      EXPECT_LT(left_of_error<d>(N, monomials<d>(N.X, size, 1)), 1e-2);
    }
  }
}

}  // namespace
}  // namespace plumb
