#include "lib/schemes/tlsph/compatible/solver/spline_smoother.hpp"

#include "lib/schemes/tlsph/compatible/solver/lane_vector.hpp"

namespace plumb {

template <int d>
SplineSmoother<d> spline_smoother(const SplineMatrix<d>& matrix) {
  const auto rough = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  return {matrix.grid, matrix.places, rough(matrix.entries), rough(matrix.inverse_diagonal), matrix.largest};
}

template <int d>
void apply(const SplineSmoother<d>& matrix, const RoughCoefficients<d>& x, RoughCoefficients<d>& result) {
  constexpr int width = 2 * spline_reach + 1, lines = row_size<d> / width;
  using Lanes = LaneVector<float, lanes<d>>;
  const auto offset = line_offsets<d>(matrix.grid);
#pragma omp parallel for schedule(static)
  for (Index r = 0; r < matrix.rows(); ++r) {
    const float* row = matrix.entries.data() + r * row_size<d>;
    Lanes sums[width];  // one chain of additions would wait for each of them
    for (auto& sum : sums) sum = Lanes{};
    for (int n = 0; n < lines; ++n, row += width) {
      const float* c = x[matrix.places[r] + offset[n]].data();
      for (int o = 0; o < width; ++o) sums[o] += row[o] * load_lanes<Lanes>(c + o * lanes<d>);
    }
    for (int o = 1; o < width; ++o) sums[0] += sums[o];
    store_lanes(sums[0], result[matrix.places[r]].data());
  }
}

#define PLUMB_INSTANTIATE(d)                                             \
  template SplineSmoother<d> spline_smoother<d>(const SplineMatrix<d>&); \
  template void apply<d>(const SplineSmoother<d>&, const RoughCoefficients<d>&, RoughCoefficients<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
