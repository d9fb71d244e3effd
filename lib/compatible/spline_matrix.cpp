#include "plumbline/compatible/spline_matrix.hpp"

#include <cmath>

namespace plumb {
namespace {

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}
constexpr int width = 2 * spline_reach + 1;  ///< of a row along an axis

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Numbers of rows by place; -1 where there is none.
template <int d>
std::vector<std::int32_t> rows_by_place(const SplineMatrix<d>& matrix) {
  std::vector<std::int32_t> row(matrix.grid.places, -1);
  for (Index r = 0; r < matrix.rows(); ++r) row[matrix.places[r]] = static_cast<std::int32_t>(r);
  return row;
}

/// Rows for the marked places, entries zero.
template <int d>
void make_rows(SplineMatrix<d>& matrix, const std::vector<char>& used) {
  for (Index p = 0; p < matrix.grid.places; ++p)
    if (used[p]) matrix.places.push_back(p);
  matrix.entries.assign(matrix.places.size() * row_size<d>, 0.0);
}

/// The 4^d splines around a point, and their derivatives: rows of the prolongation.
template <int d>
Eigen::Matrix<double, d + 1, power(4, d), Eigen::RowMajor> local_prolongation(const SplineValues<d>& s) {
  Eigen::Matrix<double, d + 1, power(4, d), Eigen::RowMajor> P;
  for (int m = 0; m < power(4, d); ++m)
    for (int row = 0; row <= d; ++row) {
      double product = 1;
      for (int k = 0, rest = m; k < d; ++k, rest /= 4)
        product *= k == row - 1 ? s.slope[k][rest % 4] : s.value[k][rest % 4];
      P(row, m) = product;
    }
  return P;
}

/// Adds the product with which particle i answers to the splines in the window of 6^d around its cell:
/// d + 1 rows of C W C^T P.
template <int d>
void add_response(const BondOperator<d>& N, const SplineGrid<d>& grid, Index i, const SplineValues<d>& s,
                  const auto& own, Eigen::Ref<RowMajor> response) {
  using Row = Eigen::Matrix<double, 1, d + 1>;
  constexpr int splines = power(4, d);
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
    const Eigen::Matrix<double, 1, splines> t = q * local_prolongation<d>(far);
    add(first, (N.weight[n] * p.transpose() * t).eval());
  }
  add(centre, (diagonal * own).eval());
}

template <int d>
void finish(SplineMatrix<d>& matrix) {
  matrix.inverse_diagonal.resize(matrix.rows());
  for (Index r = 0; r < matrix.rows(); ++r) {
    const double own = matrix.row(r)[row_size<d> / 2];
    matrix.inverse_diagonal[r] = own > 0 ? 1 / own : 0;
  }
  Coefficients<d> x(matrix.grid.places, Coefficient<d>::Zero()), y = x;
  std::uint64_t seed = 1;
  for (const Index p : matrix.places) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    x[p][0] = static_cast<double>(seed >> 11) * 0x1p-53 - 0.5;
  }
  for (int round = 0; round < 12; ++round) {
    apply(matrix, x, y);
    double xx = 0, xy = 0;
    for (Index r = 0; r < matrix.rows(); ++r) {
      const Index p = matrix.places[r];
      if (matrix.inverse_diagonal[r] == 0) continue;
      xx += x[p][0] * x[p][0] / matrix.inverse_diagonal[r];
      xy += x[p][0] * y[p][0];
    }
    matrix.largest = xy / xx;
    const double scale = 1 / std::sqrt(xx);
    for (Index r = 0; r < matrix.rows(); ++r)
      x[matrix.places[r]] = scale * matrix.inverse_diagonal[r] * y[matrix.places[r]];
  }
  matrix.largest *= 1.1;  // power iterations approach it from below
}

}  // namespace

template <int d>
SplineMatrix<d> spline_matrix(const BondOperator<d>& N, const SplineGrid<d>& grid,
                              const ParticlesByCell<d>& by_cell) {
  constexpr int splines = power(4, d), window = power(6, d);
  SplineMatrix<d> matrix;
  matrix.grid = grid;
  std::vector<char> used(grid.places, 0);
  const auto place_in_cell = [&](const SplineValues<d>& s, int m) {
    Index at = grid.place(s.cell);
    for (int k = 0; k < d; ++k, m /= 4) at += m % 4 * grid.stride[k];
    return at;
  };
  const Index cells = static_cast<Index>(by_cell.begin.size()) - 1;
  for (Index cell = 0; cell < cells; ++cell) {
    const auto s = splines_at<d>(grid, N.X[by_cell.particles[by_cell.begin[cell]]]);
    for (int m = 0; m < splines; ++m) used[place_in_cell(s, m)] = 1;
  }
  make_rows(matrix, used);
  const auto row_of = rows_by_place(matrix);
  for (std::size_t colour = 0; colour + 1 < by_cell.colour_begin.size(); ++colour) {
#pragma omp parallel
    {
      RowMajor P, G, product;
#pragma omp for schedule(static)
      for (Index cell = by_cell.colour_begin[colour]; cell < by_cell.colour_begin[colour + 1]; ++cell) {
        const Index many = by_cell.begin[cell + 1] - by_cell.begin[cell];
        P.resize(many * (d + 1), splines);
        G.setZero(many * (d + 1), window);
        SplineValues<d> s;
        for (Index n = 0; n < many; ++n) {
          const Index i = by_cell.particles[by_cell.begin[cell] + n];
          s = splines_at<d>(grid, N.X[i]);
          const auto own = local_prolongation<d>(s);
          P.template middleRows<d + 1>(n * (d + 1)) = own;
          add_response<d>(N, grid, i, s, own, G.template middleRows<d + 1>(n * (d + 1)));
        }
        product.noalias() = P.transpose() * G;
        for (int m = 0; m < splines; ++m) {
          double* row = matrix.row(row_of[place_in_cell(s, m)]);
          for (int c = 0; c < window; ++c) {
            int offset = 0;
            for (int k = 0, a = m, b = c, step = 1; k < d; ++k, a /= 4, b /= 6, step *= width)
              offset += (b % 6 - 1 - a % 4 + spline_reach) * step;
            row[offset] += product(m, c);
          }
        }
      }
    }
  }
  finish(matrix);
  return matrix;
}

namespace {

/// Along one axis: what a fine spline k of a column passes to coarse splines, 1/8 (1 4 6 4 1).
constexpr std::array<double, 5> two_scale = {0.125, 0.5, 0.75, 0.5, 0.125};

Index half_down(Index n) {
  return n >= 0 ? n / 2 : -((1 - n) / 2);
}
Index half_up(Index n) {
  return -half_down(-n);
}

/// Replaces the axis `axis` of a row, whose columns are k - spline_reach .. k + spline_reach, by coarse
/// columns; the coarse offset is counted from `base`. Sizes of axes before and after are products of what
/// they have now.
void coarsen_axis(const std::vector<double>& from, std::vector<double>& to, Index before, Index after,
                  Index k, Index base) {
  to.assign(before * width * after, 0.0);
  for (Index o = 0; o < width; ++o) {
    const Index column = k + o - spline_reach;
    for (Index K = half_up(column - 1); K <= half_down(column + 3); ++K) {
      const double weight = two_scale[column - 2 * K + 3];
      const Index O = K - base + spline_reach;
      if (O < 0 || O >= width) continue;
      for (Index a = 0; a < after; ++a)
        for (Index b = 0; b < before; ++b)
          to[(a * width + O) * before + b] += weight * from[(a * width + o) * before + b];
    }
  }
}

}  // namespace

template <int d>
SplineMatrix<d> coarser(const SplineMatrix<d>& fine) {
  SplineMatrix<d> matrix;
  matrix.grid = coarser(fine.grid);
  // coarse splines to which fine spline k belongs
  const auto each_parent = [](const std::array<Index, d>& k, auto&& action) {
    std::array<Index, d> K;
    for (int n = 0; n < power(3, d); ++n) {
      double weight = 1;
      bool is = true;
      for (int a = 0, rest = n; a < d; ++a, rest /= 3) {
        K[a] = half_up(k[a] - 1) + rest % 3;
        const Index m = k[a] - 2 * K[a] + 3;
        is = is && m >= 0;
        if (is) weight *= two_scale[m];
      }
      if (is) action(K, weight);
    }
  };
  std::vector<char> used(matrix.grid.places, 0);
  for (const Index place : fine.places)
    each_parent(fine.grid.spline(place), [&](const auto& K, double) { used[matrix.grid.place(K)] = 1; });
  make_rows(matrix, used);
  const auto row_of = rows_by_place(matrix);
  std::vector<double> now, next;
  for (Index r = 0; r < fine.rows(); ++r) {
    const auto k = fine.grid.spline(fine.places[r]);
    // columns for a parent K reach from K - 4 to K + 4; for base B = first parent, parents B .. B + 2
    std::array<Index, d> base;
    now.assign(fine.row(r), fine.row(r) + row_size<d>);
    Index before = 1, after = row_size<d> / width;
    for (int a = 0; a < d; ++a) {
      base[a] = half_up(k[a] - 5) + spline_reach;  // the first coarse column is base - spline_reach
      coarsen_axis(now, next, before, after, k[a], base[a]);
      std::swap(now, next);
      before *= width;
      after /= width;
    }
    each_parent(k, [&](const auto& K, double weight) {
      double* row = matrix.row(row_of[matrix.grid.place(K)]);
      for (int n = 0; n < row_size<d> / width; ++n) {
        Index to = 0, from = 0, step = width;
        bool is = true;
        for (int a = 1, rest = n; a < d; ++a, rest /= width, step *= width) {
          const Index shifted = rest % width + base[a] - K[a];  // offset of this column in K's row
          is = is && shifted >= 0 && shifted < width;
          to += shifted * step;
          from += rest % width * step;
        }
        if (!is) continue;
        for (Index o = 0; o < width; ++o) {
          const Index shifted = o + base[0] - K[0];
          if (shifted >= 0 && shifted < width) row[to + shifted] += weight * now[from + o];
        }
      }
    });
  }
  finish(matrix);
  return matrix;
}

template <int d>
void apply(const SplineMatrix<d>& matrix, const Coefficients<d>& x, Coefficients<d>& result) {
  constexpr int lines = row_size<d> / width;
  const auto offset = line_offsets<d>(matrix.grid);
#pragma omp parallel for schedule(static)
  for (Index r = 0; r < matrix.rows(); ++r) {
    const double* row = matrix.row(r);
    Coefficient<d> even = Coefficient<d>::Zero(), odd = even;
    for (int n = 0; n < lines; ++n, row += width) {
      const Coefficient<d>* c = x.data() + matrix.places[r] + offset[n];
      for (int o = 0; o < width; ++o) (o % 2 ? odd : even) += row[o] * c[o];
    }
    result[matrix.places[r]] = even + odd;
  }
}

#define PLUMB_INSTANTIATE(d)                                                              \
  template SplineMatrix<d> spline_matrix<d>(const BondOperator<d>&, const SplineGrid<d>&, \
                                            const ParticlesByCell<d>&);                   \
  template SplineMatrix<d> coarser<d>(const SplineMatrix<d>&);                            \
  template void apply<d>(const SplineMatrix<d>&, const Coefficients<d>&, Coefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
