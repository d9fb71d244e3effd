#include "plumbline/compatible/conjugate_gradients.hpp"

#include <algorithm>

#include "plumbline/compatible/constraints.hpp"

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

/// In blocks that do not depend on the number of threads.
template <int d>
double product(const Multipliers<d>& a, const Multipliers<d>& b) {
  constexpr Index block = 1024;
  const Index n = static_cast<Index>(a.size()), blocks = (n + block - 1) / block;
  std::vector<double> parts(blocks, 0.0);
#pragma omp parallel for schedule(static)
  for (Index k = 0; k < blocks; ++k)
    for (Index i = k * block; i < std::min(n, (k + 1) * block); ++i)
      parts[k] += a[i].cwiseProduct(b[i]).sum();
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

/// y = a x + b y.
template <int d>
void combine(double a, const Multipliers<d>& x, double b, Multipliers<d>& y) {
#pragma omp parallel for schedule(static)
  for (Index i = 0; i < static_cast<Index>(x.size()); ++i) y[i] = a * x[i] + b * y[i];
}

/// z, made conjugate to the directions, becomes the first of them.
template <int d>
void take_direction(const BondOperator<d>& N, Multipliers<d>& z, Directions<d>& directions) {
  for (const auto& before : directions) combine<d>(-product<d>(z, before.Np) / before.pNp, before.p, 1, z);
  if (directions.size() < most_directions)
    directions.push_back({Multipliers<d>(z.size()), Multipliers<d>(z.size()), 0});
  std::rotate(directions.begin(), directions.end() - 1, directions.end());
  Direction<d>& now = directions.front();
  now.p.swap(z);
  apply(N, now.p, now.Np);
  now.pNp = product<d>(now.p, now.Np);
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
    const auto& [p, Np, pNp] = directions.front();
    const double rp = product<d>(r, p);
    if (!(pNp > 0) || !(rp > 0)) return n;
    combine<d>(rp / pNp, p, 1, x);
    combine<d>(-rp / pNp, Np, 1, r);
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
