#include "plumbline/compatible/conjugate_gradients.hpp"

#include "plumbline/compatible/constraints.hpp"

namespace plumb {
namespace {

/// Enough for twice the reduction asked for, at the rate that is measured.
constexpr int most_iterations = 200;
/// A residual this many times above its least has lost touch with the true one.
constexpr double diverged = 10;

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

}  // namespace

template <int d>
int solve_by_iterations(const BondOperator<d>& N, const Multilevel<d>& multilevel,
                        const QuadraticFields<d>& fields, Multipliers<d> r, double goal, Multipliers<d>& x) {
  x.assign(r.size(), MultiplierBlock<d>::Zero());
  Multipliers<d> z = x, p = x, Np = x;
  double before = 0, least = largest<d>(r);
  for (int n = 0; n < most_iterations; ++n) {
    const double now = largest<d>(r);
    if (!(now > goal) || now > diverged * least) return n;
    least = std::min(least, now);
    precondition(N, multilevel, r, z);
    if (N.volume_weight > 0) add_quadratic_part<d>(fields, N.X, r, z);
    const double rz = product<d>(r, z);
    combine<d>(1, z, n == 0 ? 0 : rz / before, p);
    before = rz;
    apply(N, p, Np);
    const double pNp = product<d>(p, Np);
    if (!(pNp > 0) || !(rz > 0)) return n;
    combine<d>(rz / pNp, p, 1, x);
    combine<d>(-rz / pNp, Np, 1, r);
  }
  return most_iterations;
}

template int solve_by_iterations<1>(const BondOperator<1>&, const Multilevel<1>&, const QuadraticFields<1>&,
                                    Multipliers<1>, double, Multipliers<1>&);
template int solve_by_iterations<2>(const BondOperator<2>&, const Multilevel<2>&, const QuadraticFields<2>&,
                                    Multipliers<2>, double, Multipliers<2>&);
template int solve_by_iterations<3>(const BondOperator<3>&, const Multilevel<3>&, const QuadraticFields<3>&,
                                    Multipliers<3>, double, Multipliers<3>&);

}  // namespace plumb
