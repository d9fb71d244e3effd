#pragma once

namespace plumb {

/// Steps of the Chebyshev polynomial of the fourth kind for eigenvalues up to `largest`: correction n is
/// old * correction + fresh * D^-1 residual. Needs no lower bound (Lottes, Numer. Linear Algebra Appl. 30,
/// 2023).
struct ChebyshevStep {
  double old, fresh;
};
constexpr ChebyshevStep chebyshev(int n, double largest) {
  return {(2.0 * n - 3) / (2 * n + 1), (8.0 * n - 4) / (2 * n + 1) / largest};
}

}  // namespace plumb
