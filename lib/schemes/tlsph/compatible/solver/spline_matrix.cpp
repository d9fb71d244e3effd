#include "lib/schemes/tlsph/compatible/solver/spline_matrix.hpp"

#include "lib/schemes/tlsph/compatible/solver/spline_rows.hpp"

namespace plumb {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What the 4^d splines around a point give there, value and derivatives weighted by q: a row of the
/// prolongation.
template <int d>
Eigen::Matrix<double, 1, int_power(4, d)> prolonged(const SplineValues<d>& s,
                                                    const Eigen::Matrix<double, 1, d + 1>& q) {
  Eigen::Matrix<double, 1, int_power(4, d)> t;
  const auto product = across(s);
  for (int line = 0; line < lines<d>; ++line) {
    double value = q[0] * product[line][0];
    const double slope = q[1] * product[line][0];
    for (int k = 1; k < d; ++k) value += q[1 + k] * product[line][k];
    for (int m = 0; m < 4; ++m) t[4 * line + m] = value * s.value[0][m] + slope * s.slope[0][m];
  }
  return t;
}

/// All rows: the value and the derivatives.
template <int d>
Eigen::Matrix<double, d + 1, int_power(4, d), Eigen::RowMajor> local_prolongation(const SplineValues<d>& s) {
  Eigen::Matrix<double, d + 1, int_power(4, d), Eigen::RowMajor> P;
  for (int row = 0; row <= d; ++row) P.row(row) = prolonged<d>(s, Eigen::Matrix<double, 1, d + 1>::Unit(row));
  return P;
}

/// Adds the product with which particle i answers to the splines in the window of 6^d around its cell:
/// d + 1 rows of C W C^T P.
template <int d>
void add_response(const BondOperator<d>& N, const SplineGrid<d>& grid, Index i, const SplineValues<d>& s,
                  const auto& own, Eigen::Ref<RowMajor> response) {
  using Row = Eigen::Matrix<double, 1, d + 1>;
  constexpr int splines = int_power(4, d);
  Eigen::Matrix<double, d + 1, d + 1> diagonal = Eigen::Matrix<double, d + 1, d + 1>::Zero();
  const auto add = [&](int first, const auto& rows) {
    for (int line = 0; line < splines / 4; ++line) {
      int at = first;
      for (int k = 1, rest = line, step = 6; k < d; ++k, rest /= 4, step *= 6) at += rest % 4 * step;
      response.template middleCols<4>(at) += rows.template middleCols<4>(4 * line);
    }
  };
  int centre = 0;
  for (int k = 0, step = 1; k < d; ++k, step *= 6) centre += step;
  for (Index n = N.begin[i]; n < N.begin[i + 1]; ++n) {
    const Index j = N.other[n];
    Row p, q;
    p << 1, 0.5 * (N.X[j] - N.X[i]).transpose();
    q = p;
    q[0] = -1;
    diagonal += N.weight[n] * p.transpose() * p;
    const auto far = splines_at<d>(grid, N.X[j]);
    int first = centre;
    for (int k = 0, step = 1; k < d; ++k, step *= 6)
      first += static_cast<int>(far.cell[k] - s.cell[k]) * step;
    add(first, (N.weight[n] * p.transpose() * prolonged<d>(far, q)).eval());
  }
  add(centre, (diagonal * own).eval());
}

/// The place of spline m of those around a point.
template <int d>
Index place_of(const SplineGrid<d>& grid, const SplineValues<d>& s, int m) {
  Index at = grid.place(s.cell);
  for (int k = 0; k < d; ++k, m /= 4) at += m % 4 * grid.stride[k];
  return at;
}

/// Kept from one cell to the next.
struct CellWork {
  RowMajor P, G, product;
};

/// Adds what the particles of one cell answer, to the rows of the splines that they see.
template <int d>
void add_cell(const BondOperator<d>& N, const ParticlesByCell<d>& by_cell, Index cell,
              const std::vector<std::int32_t>& row_of, CellWork& work, SplineMatrix<d>& matrix) {
  constexpr int splines = int_power(4, d), window = int_power(6, d);
  const Index first = by_cell.begin[cell], many = by_cell.begin[cell + 1] - first;
  work.P.resize(many * (d + 1), splines);
  work.G.setZero(many * (d + 1), window);
  SplineValues<d> s;
  for (Index n = 0; n < many; ++n) {
    const Index i = by_cell.particles[first + n];
    s = splines_at<d>(matrix.grid, N.X[i]);
    const auto own = local_prolongation<d>(s);
    work.P.template middleRows<d + 1>(n * (d + 1)) = own;
    add_response<d>(N, matrix.grid, i, s, own, work.G.template middleRows<d + 1>(n * (d + 1)));
  }
  work.product.noalias() = work.P.transpose() * work.G;
  for (int m = 0; m < splines; ++m) {
    double* row = matrix.row(row_of[place_of(matrix.grid, s, m)]);
    for (int c = 0; c < window; ++c) {
      int offset = 0;
      for (int k = 0, a = m, b = c, step = 1; k < d; ++k, a /= 4, b /= 6, step *= row_width)
        offset += (b % 6 - 1 - a % 4 + spline_reach) * step;
      row[offset] += work.product(m, c);
    }
  }
}

}  // namespace

template <int d>
SplineMatrix<d> spline_matrix(const BondOperator<d>& N, const SplineGrid<d>& grid,
                              const ParticlesByCell<d>& by_cell) {
  SplineMatrix<d> matrix;
  matrix.grid = grid;
  std::vector<char> used(grid.places, 0);
  const Index cells = static_cast<Index>(by_cell.begin.size()) - 1;
  for (Index cell = 0; cell < cells; ++cell) {
    const auto s = splines_at<d>(grid, N.X[by_cell.particles[by_cell.begin[cell]]]);
    for (int m = 0; m < int_power(4, d); ++m) used[place_of(grid, s, m)] = 1;
  }
  make_rows(matrix, used);
  const auto row_of = rows_by_place(matrix);
  for (std::size_t colour = 0; colour + 1 < by_cell.colour_begin.size(); ++colour) {
#pragma omp parallel
    {
      CellWork work;
#pragma omp for schedule(static)
      for (Index block = by_cell.colour_begin[colour]; block < by_cell.colour_begin[colour + 1]; ++block)
        for (Index cell = by_cell.block_begin[block]; cell < by_cell.block_begin[block + 1]; ++cell)
          add_cell<d>(N, by_cell, cell, row_of, work, matrix);
    }
  }
  finish(matrix);
  return matrix;
}

#define PLUMB_INSTANTIATE(d)                                                              \
  template SplineMatrix<d> spline_matrix<d>(const BondOperator<d>&, const SplineGrid<d>&, \
                                            const ParticlesByCell<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
