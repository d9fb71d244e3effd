#pragma once
#include <boost/multiprecision/cpp_int.hpp>
#include <utility>
#include <vector>

/// A second derivation of everything in oned/, with other means: kernels written again as sums of truncated
/// powers, derivatives by dual numbers instead of Appendix A, estimates by the printed pairwise sums (33),
/// (34), (36) instead of stencils. Scalars: exact rationals or long double. Nothing here comes from lib/ or
/// oned/.
namespace second {

using Rational = boost::multiprecision::cpp_rational;

/// a + b e with e^2 = 0: b is the derivative.
template <class T>
struct Dual {
  T a{0}, b{0};
  Dual() = default;
  Dual(T value, T slope = T(0)) : a(std::move(value)), b(std::move(slope)) {}
  friend Dual operator+(const Dual& x, const Dual& y) { return {T(x.a + y.a), T(x.b + y.b)}; }
  friend Dual operator-(const Dual& x, const Dual& y) { return {T(x.a - y.a), T(x.b - y.b)}; }
  friend Dual operator*(const Dual& x, const Dual& y) { return {T(x.a * y.a), T(x.a * y.b + x.b * y.a)}; }
  friend Dual operator/(const Dual& x, const Dual& y) {
    return {T(x.a / y.a), T((x.b * y.a - x.a * y.b) / (y.a * y.a))};
  }
};

/// max(0, s)^n
template <class T>
Dual<T> positive_power(const Dual<T>& s, int n) {
  if (s.a <= 0) return {};
  Dual<T> product(T(1));
  for (int k = 0; k < n; ++k) product = product * s;
  return product;
}

/// B-splines of degree 3 and 5 as differences of truncated powers; Wendland's phi_{1,1} = (1 - r)^3 (3r + 1)
/// with r = q/2; (1 - q/2)^2. All with unit integral in 1D. The support is 2, 3, 2, 2.
enum class Kernel { cubic, quintic, wendland, quadratic };

template <class T>
Dual<T> kernel(Kernel k, const Dual<T>& q) {
  const auto number = [](int n, int m) { return Dual<T>(T(T(n) / T(m))); };
  switch (k) {
    case Kernel::cubic:
      return number(1, 6) *
             (positive_power(number(2, 1) - q, 3) - number(4, 1) * positive_power(number(1, 1) - q, 3));
    case Kernel::quintic:
      return number(1, 120) *
             (positive_power(number(3, 1) - q, 5) - number(6, 1) * positive_power(number(2, 1) - q, 5) +
              number(15, 1) * positive_power(number(1, 1) - q, 5));
    case Kernel::wendland: {
      const Dual<T> r = q / number(2, 1);
      return number(5, 8) * positive_power(number(1, 1) - r, 3) * (number(3, 1) * r + number(1, 1));
    }
    case Kernel::quadratic:
      break;
  }
  return number(3, 4) * positive_power(number(1, 1) - q / number(2, 1), 2);
}

template <class T>
struct Cloud {
  std::vector<T> X, V;
};

/// V W~_j and V d/dx W~_j of all particles, seen from x.
template <class T>
struct Weights {
  std::vector<T> w, g;
  T alpha{1}, beta{0};
};

/// order -1: plain, 0: Shepard, 1: first order. The evaluation point carries the dual unit, so g is the whole
/// derivative.
template <class T>
Weights<T> weights(const Cloud<T>& cloud, T x, Kernel k, T h, int order) {
  const Dual<T> at(x, T(1));
  std::vector<Dual<T>> w;
  Dual<T> m0, m1, m2;
  for (std::size_t j = 0; j < cloud.X.size(); ++j) {
    const Dual<T> s = Dual<T>(cloud.X[j]) - at;
    // |s|; at s = 0 the slope of a kernel with a cusp is taken as zero
    const Dual<T> r = s.a > 0 ? s : s.a < 0 ? Dual<T>(T(0)) - s : Dual<T>(T(0));
    w.push_back(Dual<T>(T(cloud.V[j] / h)) * kernel(k, r / Dual<T>(h)));
    m0 = m0 + w.back();
    m1 = m1 + w.back() * s;
    m2 = m2 + w.back() * s * s;
  }
  Weights<T> result;
  const Dual<T> beta = order == 1 ? m1 / m2 : Dual<T>();
  const Dual<T> alpha = order == -1 ? Dual<T>(T(1)) : Dual<T>(T(1)) / (m0 - beta * m1);
  for (std::size_t j = 0; j < cloud.X.size(); ++j) {
    const Dual<T> s = Dual<T>(cloud.X[j]) - at;
    const Dual<T> corrected = alpha * (Dual<T>(T(1)) - beta * s) * w[j];
    result.w.push_back(corrected.a);
    result.g.push_back(corrected.b);
  }
  result.alpha = alpha.a;
  result.beta = beta.a;
  return result;
}

/// Divides the gradients by sum V X g: the L correction in 1D.
template <class T>
void normalise(Weights<T>& weights, const Cloud<T>& cloud, T x) {
  T first(0);
  for (std::size_t j = 0; j < cloud.X.size(); ++j) first += weights.g[j] * (cloud.X[j] - x);
  for (T& g : weights.g) g /= first;
}

/// (33) as printed: sum V grad W x_j.
template <class T>
T standard(const Weights<T>& weights, const std::vector<T>& x) {
  T sum(0);
  for (std::size_t j = 0; j < x.size(); ++j) sum += weights.g[j] * x[j];
  return sum;
}

/// (34) with (35): the average of the pairwise gradients without the particle's own.
template <class T>
T bond(const Weights<T>& weights, const Cloud<T>& cloud, std::size_t i, const std::vector<T>& x) {
  T sum(0);
  for (std::size_t j = 0; j < x.size(); ++j)
    if (j != i) sum += weights.w[j] * (x[j] - x[i]) / (cloud.X[j] - cloud.X[i]);
  return sum;
}

/// (34) with (36): the particle's own gradient is the standard estimate.
template <class T>
T improved(const Weights<T>& weights, const Cloud<T>& cloud, std::size_t i, const std::vector<T>& x) {
  return bond(weights, cloud, i, x) + weights.w[i] * standard(weights, x);
}

/// n particles at (i + 1/2) with unit volume.
template <class T>
Cloud<T> cell_cloud(int n) {
  Cloud<T> cloud;
  for (int i = 0; i < n; ++i) {
    cloud.X.push_back(T(T(2 * i + 1) / T(2)));
    cloud.V.push_back(T(1));
  }
  return cloud;
}

}  // namespace second
