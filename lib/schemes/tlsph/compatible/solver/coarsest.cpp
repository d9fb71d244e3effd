#include "lib/schemes/tlsph/compatible/solver/coarsest.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "lib/linear/dense.hpp"

namespace plumb {
namespace {

using Eigen::MatrixXd;

/// Of the matrix, after four times eight terms that cancel.
constexpr double rounding = 1e-10;

template <int d>
MatrixXd dense(const SplineMatrix<d>& matrix) {
  MatrixXd all(matrix.rows(), matrix.rows());
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
MatrixXd quadratics(const SplineMatrix<d>& matrix) {
  MatrixXd Q(matrix.rows(), (d + 1) * (d + 2) / 2);
  for (Index r = 0; r < matrix.rows(); ++r) {
    const auto spline = matrix.grid.spline(matrix.places[r]);
    int field = 0;
    Q(r, field++) = 1;
    for (int a = 0; a < d; ++a) {
      const auto x = static_cast<double>(spline[a]);
      Q(r, field++) = x;
      for (int b = a; b < d; ++b)
        Q(r, field++) = a == b ? x * x - 1.0 / 3 : x * static_cast<double>(spline[b]);
    }
  }
  return Q;
}

/// The matrix of the bonds, scaled to a diagonal of 1. Fields of degree 2 are in its null space; rounding
/// gives them small eigenvalues, so they are taken out.
struct Scaled {
  Eigen::VectorXd scale;  ///< of rows and columns; 0 for splines that no particle sees
  MatrixXd matrix;
};
template <int d>
Scaled scaled(const SplineMatrix<d>& matrix) {
  Scaled s{Eigen::VectorXd(matrix.rows()), {}};
  for (Index k = 0; k < matrix.rows(); ++k) s.scale[k] = std::sqrt(matrix.inverse_diagonal[k]);
  const Eigen::VectorXd root = s.scale.unaryExpr([](double x) { return x > 0 ? 1 / x : 0; });
  const MatrixXd basis = orthonormal_basis(root.asDiagonal() * quadratics(matrix), 0);
  s.matrix = s.scale.asDiagonal() * dense(matrix) * s.scale.asDiagonal();
  s.matrix -= basis * (basis.transpose() * s.matrix);
  s.matrix -= (s.matrix * basis) * basis.transpose();
  return s;
}

/// Without the null space, in which splines are, too, that particles cannot tell apart.
MatrixXd pseudo_inverse(const Scaled& s) {
  const SymmetricPairs eigen = symmetric_pairs(s.matrix);
  Eigen::VectorXd inverse = eigen.values;
  const double most = inverse.maxCoeff();
  for (double& value : inverse) value = value > rounding * most ? 1 / value : 0;
  return s.scale.asDiagonal() * eigen.vectors * inverse.asDiagonal() * eigen.vectors.transpose() *
         s.scale.asDiagonal();
}

/// sum_i dB_k/dX_a dB_l/dX_b at all particles: row k d + a, column l d + b.
template <int d>
MatrixXd divergence_products(const SplineMatrix<d>& matrix, const std::vector<Vec<d>>& X) {
  constexpr int splines = d == 1 ? 4 : d == 2 ? 16 : 64;
  const auto& grid = matrix.grid;
  std::vector<Index> row(grid.places, -1);
  for (Index r = 0; r < matrix.rows(); ++r) row[matrix.places[r]] = r;
  const auto by_cell = particles_by_cell<d>(grid, X);
  MatrixXd all = MatrixXd::Zero(d * matrix.rows(), d * matrix.rows()), slopes,
           products(d * splines, d * splines);
  for (std::size_t cell = 0; cell + 1 < by_cell.begin.size(); ++cell) {
    const Index first = by_cell.begin[cell], many = by_cell.begin[cell + 1] - first;
    slopes.resize(d * splines, many);
    SplineValues<d> s;
    for (Index n = 0; n < many; ++n) {
      s = splines_at<d>(grid, X[by_cell.particles[first + n]]);
      for (int m = 0; m < splines; ++m)
        for (int a = 0; a < d; ++a) {
          double product = 1;
          for (int k = 0, rest = m; k < d; ++k, rest /= 4)
            product *= k == a ? s.slope[k][rest % 4] : s.value[k][rest % 4];
          slopes(m * d + a, n) = product;
        }
    }
    products.setZero();
    products.template selfadjointView<Eigen::Lower>().rankUpdate(slopes);
    std::array<Index, splines> at;
    for (int m = 0; m < splines; ++m) {
      Index place = grid.place(s.cell);
      for (int k = 0, rest = m; k < d; ++k, rest /= 4) place += rest % 4 * grid.stride[k];
      at[m] = d * row[place];
    }
    for (int m = 0; m < d * splines; ++m)
      for (int n = 0; n < d * splines; ++n)
        all(at[m / d] + m % d, at[n / d] + n % d) += products(std::max(m, n), std::min(m, n));
  }
  return all;
}

/// Bonds and volumes together. What is left in the null space (fields of degree 2 without divergence) gets
/// the eigenvalue 1, and everything a little more: right-hand sides have no part there.
template <int d>
MatrixXd coupled_inverse(const SplineMatrix<d>& matrix, const Scaled& bonds, const MatrixXd& divergence) {
  const Index rows = matrix.rows(), n = d * rows;
  MatrixXd Q(n, 0);
  const MatrixXd scalar = quadratics(matrix);
  Q.setZero(n, d * scalar.cols());
  Eigen::VectorXd scale(n), root(n);
  MatrixXd all = divergence;
  for (Index k = 0; k < rows; ++k)
    for (int a = 0; a < d; ++a) {
      const double own = bonds.scale[k] > 0 ? 1 / (bonds.scale[k] * bonds.scale[k]) : 0;
      root[k * d + a] = std::sqrt(own + divergence(k * d + a, k * d + a));
      scale[k * d + a] = own > 0 ? 1 / root[k * d + a] : 0;
      Q.block(k * d + a, a * scalar.cols(), 1, scalar.cols()) = root[k * d + a] * scalar.row(k);
      for (Index l = 0; l < rows; ++l)
        if (bonds.scale[k] > 0 && bonds.scale[l] > 0)
          all(k * d + a, l * d + a) += bonds.matrix(k, l) / (bonds.scale[k] * bonds.scale[l]);
    }
  all = scale.asDiagonal() * all * scale.asDiagonal();
  const MatrixXd basis = orthonormal_basis(Q, 0);
  const MatrixXd onto = basis.transpose() * (scale.asDiagonal() * divergence * scale.asDiagonal()) * basis;
  const SymmetricPairs eigen = symmetric_pairs(onto);
  for (Eigen::Index k = 0; k < onto.rows(); ++k) {
    if (eigen.values[k] > 1e-10 * eigen.values.maxCoeff()) continue;
    const Eigen::VectorXd null = basis * eigen.vectors.col(k);
    all += null * null.transpose();
  }
  all.diagonal().array() += rounding;
  const MatrixXd inverse = all.llt().solve(MatrixXd::Identity(n, n));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

}  // namespace

template <int d>
Coarsest coarsest(const SplineMatrix<d>& matrix, const std::vector<Vec<d>>& X, double volume_weight) {
  const Scaled bonds = scaled(matrix);
  if (volume_weight == 0) return {pseudo_inverse(bonds), false};
  return {coupled_inverse<d>(matrix, bonds, volume_weight * divergence_products<d>(matrix, X)), true};
}

template <int d>
void solve(const Coarsest& c, const std::vector<Index>& places, const Coefficients<d>& r,
           Coefficients<d>& x) {
  const auto rows = static_cast<Index>(places.size());
  if (c.coupled) {
    Eigen::VectorXd packed(d * rows);
    for (Index k = 0; k < rows; ++k) packed.segment<d>(k * d) = r[places[k]].template head<d>();
#pragma omp parallel for schedule(static)
    for (Index k = 0; k < rows; ++k)
      x[places[k]].template head<d>() = c.inverse.middleCols<d>(k * d).transpose() * packed;  // symmetric
    return;
  }
  Eigen::Matrix<double, Eigen::Dynamic, lanes<d>> packed(rows, lanes<d>);
  for (Index k = 0; k < rows; ++k) packed.row(k) = r[places[k]].transpose();
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < rows; ++k) x[places[k]] = packed.transpose() * c.inverse.col(k);  // symmetric
}

#define PLUMB_INSTANTIATE(d)                                                                 \
  template Coarsest coarsest<d>(const SplineMatrix<d>&, const std::vector<Vec<d>>&, double); \
  template void solve<d>(const Coarsest&, const std::vector<Index>&, const Coefficients<d>&, \
                         Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
