#pragma once
#include "lib/schemes/upwind.hpp"

namespace plumb {

/// The jump of the form R^T S R: w = v_b - v_a - (l_a + l_b) x_ab/2 with spatial velocity gradients l, and
/// the force from the potential sum q.w/2 over the pairs. Dissipative by construction; zero for a rigid
/// rotation of any deformed state; linear and angular momentum are exact. THEORY (16.2), (16.3).
template <int d, int W>
struct AdjointJump {
  static constexpr bool adjoint = true;
  using Real = Pack<W>;

  AdjointJump(const UpwindSite<d>& where, Index i)
      : site(where), gradient(load_tensor<d, W>(where.gradient, i)) {}
  Vec<d, Real> operator()(std::int64_t, Index j, const Vec<d, Real>& dv, const Vec<d, Real>& x) const {
    Vec<d, Real> w = dv;
    for (int a = 0; a < d; ++a)
      for (int b = 0; b < d; ++b)
        w[a] -= Real(0.5) * (gradient(a, b) + Real::load(site.gradient[a * d + b] + j)) * x[b];
    return w;
  }

  const UpwindSite<d>& site;
  Mat<d, Real> gradient;
};

}  // namespace plumb
