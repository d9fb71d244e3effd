#include "lib/schemes/tlsph/compatible/solver/spline_rows.hpp"

namespace plumb {
namespace {

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
  to.assign(before * row_width * after, 0.0);
  for (Index o = 0; o < row_width; ++o) {
    const Index column = k + o - spline_reach;
    for (Index K = half_up(column - 1); K <= half_down(column + 3); ++K) {
      const double weight = two_scale[column - 2 * K + 3];
      const Index O = K - base + spline_reach;
      if (O < 0 || O >= row_width) continue;
      for (Index a = 0; a < after; ++a)
        for (Index b = 0; b < before; ++b)
          to[(a * row_width + O) * before + b] += weight * from[(a * row_width + o) * before + b];
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
    for (int n = 0; n < int_power(3, d); ++n) {
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
    Index before = 1, after = row_size<d> / row_width;
    for (int a = 0; a < d; ++a) {
      base[a] = half_up(k[a] - 5) + spline_reach;  // the first coarse column is base - spline_reach
      coarsen_axis(now, next, before, after, k[a], base[a]);
      std::swap(now, next);
      before *= row_width;
      after /= row_width;
    }
    each_parent(k, [&](const auto& K, double weight) {
      double* row = matrix.row(row_of[matrix.grid.place(K)]);
      for (int n = 0; n < row_size<d> / row_width; ++n) {
        Index to = 0, from = 0, step = row_width;
        bool is = true;
        for (int a = 1, rest = n; a < d; ++a, rest /= row_width, step *= row_width) {
          const Index shifted = rest % row_width + base[a] - K[a];  // offset of this column in K's row
          is = is && shifted >= 0 && shifted < row_width;
          to += shifted * step;
          from += rest % row_width * step;
        }
        if (!is) continue;
        for (Index o = 0; o < row_width; ++o) {
          const Index shifted = o + base[0] - K[0];
          if (shifted >= 0 && shifted < row_width) row[to + shifted] += weight * now[from + o];
        }
      }
    });
  }
  finish(matrix);
  return matrix;
}

template SplineMatrix<1> coarser<1>(const SplineMatrix<1>&);
template SplineMatrix<2> coarser<2>(const SplineMatrix<2>&);
template SplineMatrix<3> coarser<3>(const SplineMatrix<3>&);

}  // namespace plumb
