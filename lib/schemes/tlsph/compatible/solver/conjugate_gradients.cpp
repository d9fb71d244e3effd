#include "lib/schemes/tlsph/compatible/solver/conjugate_gradients.hpp"

#include <algorithm>

#include "lib/schemes/tlsph/compatible/solver/constraints.hpp"

namespace plumb {
namespace {

/// Enough for twice the reduction asked for, at the rate that is measured.
constexpr int most_iterations = 200;
/// The approximate inverse is not symmetric, so that a new direction is not conjugate to the old ones by
/// itself. Measured: 4 of them save a fifth of the iterations of 1, 12 hardly more.
constexpr std::size_t most_directions = 4;
/// A residual this many times above its least has lost touch with the true one. The first steps, which take
/// out smooth errors, may raise it tenfold.
constexpr double diverged = 1000;

template <int d>
using Fields = std::vector<const Multipliers<d>*>;

/// a . b for every b, in blocks that do not depend on the number of threads. All are read together: on large
/// clouds reading them is most of the work.
template <int d>
std::vector<double> products(const Multipliers<d>& a, const Fields<d>& b) {
  constexpr Index block = 1024;
  const Index n = static_cast<Index>(a.size()), blocks = (n + block - 1) / block;
  const std::size_t many = b.size();
  std::vector<double> parts(blocks * many, 0.0), sums(many, 0.0);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < blocks; ++k)
    for (Index i = k * block; i < std::min(n, (k + 1) * block); ++i)
      for (std::size_t m = 0; m < many; ++m) parts[k * many + m] += a[i].cwiseProduct((*b[m])[i]).sum();
  for (std::size_t p = 0; p < parts.size(); ++p) sums[p % many] += parts[p];
  return sums;
}

/// z, made conjugate to the directions, becomes the first of them. They are nearly conjugate to each other,
/// so all their parts of z may be found before any is taken out.
template <int d>
void take_direction(const BondOperator<d>& N, Multipliers<d>& z, Directions<d>& directions) {
  Fields<d> images;
  for (const auto& before : directions) images.push_back(&before.Np);
  std::vector<double> part = products<d>(z, images);
  for (std::size_t m = 0; m < part.size(); ++m) part[m] /= directions[m].pNp;
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(z.size()); ++i)
    for (std::size_t m = 0; m < part.size(); ++m) z[i] -= part[m] * directions[m].p[i];
  if (directions.size() < most_directions)
    directions.push_back({Multipliers<d>(z.size()), Multipliers<d>(z.size()), 0});
  std::rotate(directions.begin(), directions.end() - 1, directions.end());
  directions.front().p.swap(z);
  apply(N, directions.front().p, directions.front().Np);
}

}  // namespace

template <int d>
int solve_by_iterations(const BondOperator<d>& N, const Multilevel<d>& multilevel, Multipliers<d> r,
                        double goal, Directions<d>& directions, Multipliers<d>& x) {
  x.assign(r.size(), MultiplierBlock<d>::Zero());
  Multipliers<d> z(r.size());
  BondWork<d> work = work_for(multilevel);
  double least = largest<d>(r);
  for (int n = 0; n < most_iterations; ++n) {
    const double now = largest<d>(r);
    if (!(now > goal) || now > diverged * least) return n;
    least = std::min(least, now);
    precondition(N, multilevel, r, work, z);
    take_direction(N, z, directions);
    Direction<d>& along = directions.front();
    const auto found = products<d>(along.p, {&along.Np, &r});
    along.pNp = found[0];
    if (!(found[0] > 0) || !(found[1] > 0)) return n;
    const double step = found[1] / found[0];
#pragma omp parallel for schedule(static)
    for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {
      x[i] += step * along.p[i];
      r[i] -= step * along.Np[i];
    }
  }
  return most_iterations;
}

#define PLUMB_INSTANTIATE(d)                                                                                \
  template int solve_by_iterations<d>(const BondOperator<d>&, const Multilevel<d>&, Multipliers<d>, double, \
                                      Directions<d>&, Multipliers<d>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
