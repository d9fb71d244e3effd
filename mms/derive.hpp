#pragma once
#include <array>

#include "lib/core/types.hpp"
#include "mms/ad/dual.hpp"
#include "mms/ad/jet.hpp"

namespace plumb::mms {

/// Motion at one point and time: everything that the equation of motion needs of u(X, t).
template <int d>
struct Motion {
  Vec<d> displacement;         ///< u [m]
  Vec<d> velocity;             ///< u_t [m/s]
  Vec<d> acceleration;         ///< u_tt [m/s^2]
  Mat<d> F;                    ///< I + Grad u
  std::array<Mat<d>, d> dF{};  ///< dF[B] = dF/dX_B [1/m]
};

/// First derivation: one evaluation of the displacement in second-order jets over (X, t).
template <int d, class S>
Motion<d> motion_of(const S& solution, const Vec<d>& X, double t) {
  using J = Jet<d + 1>;
  Vec<d, J> Xj;
  for (int A = 0; A < d; ++A) Xj[A] = J::variable(X[A], A);
  const Vec<d, J> u = solution.template displacement<d>(Xj, J::variable(t, d));
  Motion<d> m;
  for (int i = 0; i < d; ++i) {
    m.displacement[i] = u[i].value;
    m.velocity[i] = u[i].slope[d];
    m.acceleration[i] = u[i].second(d, d);
    for (int A = 0; A < d; ++A) {
      m.F(i, A) = (i == A ? 1 : 0) + u[i].slope[static_cast<std::size_t>(A)];
      for (int B = 0; B < d; ++B) m.dF[static_cast<std::size_t>(B)](i, A) = u[i].second(A, B);
    }
  }
  return m;
}

/// Div P [Pa/m] at a point: P evaluated once in dual numbers that carry dF/dX_B.
template <int d, class M>
Vec<d> stress_divergence(const M& material, const Motion<d>& motion) {
  Mat<d, Dual<d>> F;
  for (int i = 0; i < d; ++i)
    for (int A = 0; A < d; ++A) {
      F(i, A) = Dual<d>(motion.F(i, A));
      for (std::size_t B = 0; B < d; ++B) F(i, A).slope[B] = motion.dF[B](i, A);
    }
  const Mat<d, Dual<d>> P = material.first_piola(F);
  Vec<d> divergence = Vec<d>::Zero();
  for (int i = 0; i < d; ++i)
    for (int A = 0; A < d; ++A) divergence[i] += P(i, A).slope[static_cast<std::size_t>(A)];
  return divergence;
}

}  // namespace plumb::mms
