#include "plumbline/compatible/multilevel.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

/// Smoothing steps before and after a coarser level: measured at 1e4 particles, 8 and 2 need the least time.
constexpr int bond_sweeps = 8, spline_sweeps = 2;
/// The eigenvalues of a matrix of this size take a second.
constexpr Index most_coarsest_rows = 700;

/// Steps of the Chebyshev polynomial of the fourth kind for eigenvalues up to `largest`: correction n is
/// old * correction + fresh * D^-1 residual. Needs no lower bound (Lottes, Numer. Linear Algebra Appl. 30,
/// 2023).
struct ChebyshevStep {
  double old, fresh;
};
ChebyshevStep chebyshev(int n, double largest) {
  return {(2.0 * n - 3) / (2 * n + 1), (8.0 * n - 4) / (2 * n + 1) / largest};
}

/// x is improved by `sweeps` steps; r is its residual before and after (before the last one, if `lazy`).
template <int d>
void smooth(const BondOperator<d>& N, int sweeps, bool lazy, Multipliers<d>& r, Multipliers<d>& x,
            Multipliers<d>& z, Multipliers<d>& Nz) {
  for (int n = 1; n <= sweeps; ++n) {
    const auto step = chebyshev(n, smoothing_bound);
#pragma omp parallel for schedule(static)
    for (Index i = 0; i < N.particles(); ++i) {
      const MultiplierBlock<d> fresh = step.fresh * (r[i] * N.inverse_diagonal[i]);
      z[i] = n == 1 ? fresh : (step.old * z[i] + fresh).eval();
      x[i] += z[i];
    }
    if (lazy && n == sweeps) break;
    apply_bonds(N, z, Nz);
#pragma omp parallel for schedule(static)
    for (Index i = 0; i < N.particles(); ++i) r[i] -= Nz[i];
  }
}

template <int d>
void smooth(const SplineMatrix<d>& matrix, int sweeps, bool lazy, Coefficients<d>& r, Coefficients<d>& x) {
  Coefficients<d> z(matrix.grid.places, Coefficient<d>::Zero()), Az = z;
  for (int n = 1; n <= sweeps; ++n) {
    const auto step = chebyshev(n, matrix.largest);
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < matrix.rows(); ++k) {
      const Index p = matrix.places[k];
      z[p] = step.old * z[p] + step.fresh * matrix.inverse_diagonal[k] * r[p];
      x[p] += z[p];
    }
    if (lazy && n == sweeps) break;
    apply(matrix, z, Az);
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < matrix.rows(); ++k) r[matrix.places[k]] -= Az[matrix.places[k]];
  }
}

template <int d>
Eigen::MatrixXd dense(const SplineMatrix<d>& matrix) {
  Eigen::MatrixXd all(matrix.rows(), matrix.rows());
  Coefficients<d> unit(matrix.grid.places, Coefficient<d>::Zero()), column = unit;
  for (Index k = 0; k < matrix.rows(); ++k) {
    unit[matrix.places[k]][0] = 1;
    apply(matrix, unit, column);
    unit[matrix.places[k]][0] = 0;
    for (Index r = 0; r < matrix.rows(); ++r) all(r, k) = column[matrix.places[r]][0];
  }
  return all;
}

/// Coefficients of the fields of degree 2, one per column, row by row of the matrix: a coordinate has that of
/// the spline's centre as coefficient, its square that square less a third of the spacing's.
template <int d>
Eigen::MatrixXd quadratics(const SplineMatrix<d>& matrix) {
  Eigen::MatrixXd Q(matrix.rows(), (d + 1) * (d + 2) / 2);
  for (Index r = 0; r < matrix.rows(); ++r) {
    const auto spline = matrix.grid.spline(matrix.places[r]);
    int field = 0;
    Q(r, field++) = 1;
    for (int a = 0; a < d; ++a) {
      const double x = static_cast<double>(spline[a]);
      Q(r, field++) = x;
      for (int b = a; b < d; ++b)
        Q(r, field++) = a == b ? x * x - 1.0 / 3 : x * static_cast<double>(spline[b]);
    }
  }
  return Q;
}

/// Fields of degree 2, and splines that particles cannot tell apart, are in the null space. Rounding gives
/// the former small eigenvalues, so they are taken out before.
template <int d>
Eigen::MatrixXd pseudo_inverse(const SplineMatrix<d>& matrix) {
  constexpr double rounding = 1e-10;  // of the matrix, after four times eight terms that cancel
  Eigen::VectorXd scale(matrix.rows()), root(matrix.rows());
  for (Index k = 0; k < matrix.rows(); ++k) {
    scale[k] = std::sqrt(matrix.inverse_diagonal[k]);
    root[k] = scale[k] > 0 ? 1 / scale[k] : 0;
  }
  const Eigen::MatrixXd Q = root.asDiagonal() * quadratics(matrix);
  const Eigen::MatrixXd basis = Eigen::JacobiSVD<Eigen::MatrixXd>(Q, Eigen::ComputeThinU).matrixU();
  Eigen::MatrixXd all = scale.asDiagonal() * dense(matrix) * scale.asDiagonal();
  all -= basis * (basis.transpose() * all);
  all -= (all * basis) * basis.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(all);
  Eigen::VectorXd inverse = eigen.eigenvalues();
  const double most = inverse.maxCoeff();
  for (double& value : inverse) value = value > rounding * most ? 1 / value : 0;
  return scale.asDiagonal() * eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose() *
         scale.asDiagonal();
}

template <int d>
void cycle(const Multilevel<d>& all, std::size_t level, Coefficients<d>& r, Coefficients<d>& x) {
  const SplineMatrix<d>& matrix = all.levels[level];
  x.assign(matrix.grid.places, Coefficient<d>::Zero());
  if (level + 1 == all.levels.size()) {
    Eigen::Matrix<double, Eigen::Dynamic, lanes<d>> packed(matrix.rows(), lanes<d>);
    for (Index k = 0; k < matrix.rows(); ++k) packed.row(k) = r[matrix.places[k]].transpose();
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < matrix.rows(); ++k)
      x[matrix.places[k]] = packed.transpose() * all.coarsest_inverse.col(k);  // symmetric
    return;
  }
  smooth(matrix, spline_sweeps, false, r, x);
  const auto& next = all.levels[level + 1];
  Coefficients<d> coarse_r, coarse_x;
  coarsen(matrix.grid, r, next.grid, coarse_r);
  cycle(all, level + 1, coarse_r, coarse_x);
  Coefficients<d> change(matrix.grid.places, Coefficient<d>::Zero()), product = change;
  add_refined(next.grid, coarse_x, matrix.grid, change);
  apply(matrix, change, product);
  for (Index k = 0; k < matrix.rows(); ++k) {
    const Index p = matrix.places[k];
    x[p] += change[p];
    r[p] -= product[p];
  }
  smooth(matrix, spline_sweeps, true, r, x);
}

}  // namespace

template <int d>
Multilevel<d> multilevel(const BondOperator<d>& N) {
  Multilevel<d> all;
  double reach_of_bonds = 0;
  for (Index i = 0; i < N.particles(); ++i)
    for (Index n = N.begin[i]; n < N.begin[i + 1]; ++n)
      reach_of_bonds = std::max(reach_of_bonds, (N.X[N.other[n]] - N.X[i]).norm());
  const auto grid = grid_over<d>(N.X, reach_of_bonds);
  all.by_cell = particles_by_cell<d>(grid, N.X);
  all.levels.push_back(spline_matrix<d>(N, grid, all.by_cell));
  while (all.levels.back().rows() > most_coarsest_rows) all.levels.push_back(coarser(all.levels.back()));
// Eigen would split its products among the threads, and their blocks, so the bits, with them: within a team
// it uses the one that calls.
#pragma omp parallel num_threads(2)
#pragma omp single
  all.coarsest_inverse = pseudo_inverse(all.levels.back());
  return all;
}

template <int d>
void precondition(const BondOperator<d>& N, const Multilevel<d>& all, const Multipliers<d>& r,
                  Multipliers<d>& x) {
  Multipliers<d> residual = r, z(r.size(), MultiplierBlock<d>::Zero()), Nz = z;
  x = z;
  smooth(N, bond_sweeps, false, residual, x, z, Nz);
  Coefficients<d> coarse_r, coarse_x;
  const auto& grid = all.levels[0].grid;
  restrict_to(grid, N.X, all.by_cell, residual, coarse_r);
  cycle(all, 0, coarse_r, coarse_x);
  for (auto& block : z) block.setZero();
  add_prolonged(grid, N.X, coarse_x, z);
  apply_bonds(N, z, Nz);
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < N.particles(); ++i) {
    x[i] += z[i];
    residual[i] -= Nz[i];
  }
  smooth(N, bond_sweeps, true, residual, x, z, Nz);
}

#define PLUMB_INSTANTIATE(d)                                                                         \
  template Multilevel<d> multilevel<d>(const BondOperator<d>&);                                      \
  template void precondition<d>(const BondOperator<d>&, const Multilevel<d>&, const Multipliers<d>&, \
                                Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
