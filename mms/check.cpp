#include "mms/check.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "lib/material/laws.hpp"
#include "mms/catalogue.hpp"
#include "mms/central_difference.hpp"
#include "mms/derive.hpp"

namespace plumb::mms {
namespace {

using Real = long double;

template <class Function>
auto second_derivative(const Function& f, Real h) {
  const auto pair = [&](int k) { return (f(k * h) + f(-k * h)).eval(); };
  return ((pair(1) * (8.0L / 5) - pair(2) * (1.0L / 5) + pair(3) * (8.0L / 315) - pair(4) * (1.0L / 560) -
           f(0.0L) * (205.0L / 72)) /
          (h * h))
      .eval();
}

template <int d>
Vec<d, Real> shifted(Vec<d, Real> X, int axis, Real by) {
  X[axis] += by;
  return X;
}

/// F = I + Grad u by the complex step Im u(X + i e)/e: no cancellation, so no step to choose.
template <int d, class S>
Mat<d, Real> gradient(const S& solution, const Vec<d, Real>& X, Real t) {
  using Complex = std::complex<Real>;
  constexpr Real e = 1e-30L;
  Mat<d, Real> F = Mat<d, Real>::Identity();
  for (int A = 0; A < d; ++A) {
    Vec<d, Complex> Z = X.template cast<Complex>();
    Z[A] += Complex(0, e);
    const Vec<d, Complex> u = solution.template displacement<d>(Z, Complex(t));
    F.col(A) += u.imag() / e;
  }
  return F;
}

template <int d>
struct Second {
  Vec<d> velocity, inertia, divergence;
  Mat<d> stress;
};

/// The step in space is 1/800 of the domain: eighth order leaves (k h)^8/630 of a wave number k, below 1e-11
/// for k L = 70 (harmonics of a law that is cubic in F at large amplitudes); long double round-off stays at
/// 1e-19 * 800 * kappa/mu.
template <int d, class S, class M>
Second<d> second_derivation(const S& solution, const M& material, double density, const Vec<d>& at,
                            double time) {
  const Vec<d, Real> X = at.template cast<Real>();
  const Real t = time, h = 0.00125L * solution.template domain<d>().length(),
             tau = 0.002L * solution.period();
  const auto in_time = [&](Real e) { return solution.template displacement<d>(X, t + e); };
  const auto stress = [&](const Vec<d, Real>& Y) -> Mat<d, Real> {
    return material.first_piola(gradient<d>(solution, Y, t));
  };
  Vec<d, Real> divergence = Vec<d, Real>::Zero();
  for (int A = 0; A < d; ++A)
    divergence +=
        central_difference([&](Real e) -> Mat<d, Real> { return stress(shifted<d>(X, A, e)); }, h).col(A);
  return {central_difference(in_time, tau).template cast<double>(),
          (density * second_derivative(in_time, tau)).template cast<double>(),
          divergence.template cast<double>(), stress(X).template cast<double>()};
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  Elastic elastic() {
    const double young = log_between(1e3, 1e9), poisson = between(0, 0.4999);
    return {young, poisson, log_between(100, 1e4)};
  }
  Parameters parameters(Parameters values) {
    const std::vector<Parameter> all = values.all();
    for (const Parameter& p : all) values.set(p.name, between(p.least, p.most));
    return values;
  }
  template <int d>
  Vec<d> point(const Domain<d>& domain) {
    Vec<d> X;
    do
      for (int a = 0; a < d; ++a) X[a] = domain.box.origin[a] + between(0, 1) * domain.box.size[a];
    while (!domain.contains(X));
    return X;
  }

 private:
  std::mt19937_64 random_;
};

/// Raises the worst relative differences by those of one random case.
template <int d, class S, class M>
void compare_once(Draw& draw, SolutionCheck& check) {
  const Elastic elastic = draw.elastic();
  const S solution(draw.parameters(S::defaults()), elastic);
  const M material(elastic);
  const Domain<d> domain = solution.template domain<d>();
  const Vec<d> X = draw.point<d>(domain);
  const double t = draw.between(0, 2 * solution.period());
  const Vec<d> N = draw.point<d>(box_domain<d>(Vec<d>::Constant(-1), Vec<d>::Constant(2), held)).normalized();

  const Motion<d> motion = motion_of<d>(solution, X, t);
  const Vec<d> divergence = stress_divergence<d>(material, motion);
  const Vec<d> force = elastic.density * motion.acceleration - divergence;
  const Mat<d> stress = material.first_piola(motion.F);
  const Second<d> second = second_derivation<d>(solution, material, elastic.density, X, t);

  double bend = 0;
  for (const Mat<d>& part : motion.dF) bend += part.norm();
  const double mu = elastic.shear_modulus(), length = domain.length();
  const double strain = (motion.F - Mat<d>::Identity()).norm() + 0.01;
  const double scale = second.inertia.norm() + mu * (bend + strain / length);
  const auto raise = [](double& worst, double value) {
    if (!std::isnan(worst) && !(value <= worst)) worst = value;  // NaN enters and stays
  };
  raise(check.force, (force - (second.inertia - second.divergence)).norm() / scale);
  raise(check.traction, ((stress - second.stress) * N).norm() / (mu * strain));
  raise(check.velocity, (motion.velocity - second.velocity).norm() * solution.period() /
                            (length + motion.displacement.norm()));
}

}  // namespace

std::vector<SolutionCheck> check_solution(std::string_view name, std::size_t points, std::uint64_t seed) {
  std::vector<SolutionCheck> checks;
  const bool known = with_named(SolutionCatalogue{}, name, [&]<class S>(Type<S>) {
    for_each_type(ElasticLaws{}, [&]<class M>(Type<M>) {
      const auto in = [&]<int d>(std::integral_constant<int, d>) {
        if constexpr (S::template in_dimension<d>) {
          SolutionCheck check{std::string(S::name), std::string(M::name), d, points, 0, 0, 0, false};
          Draw draw(seed);
          for (std::size_t k = 0; k < points; ++k) compare_once<d, S, M>(draw, check);
          check.passed = check.force <= check_tolerance && check.traction <= check_tolerance &&
                         check.velocity <= check_tolerance;
          checks.push_back(check);
        }
      };
      in(std::integral_constant<int, 1>{});
      in(std::integral_constant<int, 2>{});
      in(std::integral_constant<int, 3>{});
    });
  });
  if (!known) throw unknown_name("manufactured solution", name, names_of(SolutionCatalogue{}));
  return checks;
}

}  // namespace plumb::mms
