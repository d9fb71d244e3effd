#include "lib/schemes/updated/pair_sums.hpp"

namespace plumb {

template <int d>
LatticeSums lattice_sums(double beta) {
  const KernelSlope slope = wendland_slope<d>(beta);
  const int reach = static_cast<int>(2 * beta);
  LatticeSums sums{0, 0, 0};
  for (int a = -reach; a <= reach; ++a)
    for (int b = d > 1 ? -reach : 0; b <= (d > 1 ? reach : 0); ++b)
      for (int c = d == 3 ? -reach : 0; c <= (d == 3 ? reach : 0); ++c) {
        const double square = a * a + b * b + c * c;
        if (square == 0) continue;
        const double w = -slope(std::sqrt(square));
        sums.m += w * a * a;
        sums.xxxx += w * a * a * a * a / square;
        sums.xxyy += w * a * a * b * b / square;
      }
  return sums;
}

template LatticeSums lattice_sums<1>(double);
template LatticeSums lattice_sums<2>(double);
template LatticeSums lattice_sums<3>(double);

}  // namespace plumb
