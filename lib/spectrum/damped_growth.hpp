#pragma once
#include "lib/spectrum/linear_operator.hpp"

namespace plumb {

/// A rate of growth [c_p/d].
struct Growth {
  double rate = 0;
  double resolution = 0;  ///< slower growth may be missing; 0: none is
};

/// Fastest growth of a'' = -K a - C a' by all eigenvalues of the first-order system.
template <int d>
Growth dense_damped_growth(LinearOperator<d>& op, const SparseMatrix& K);

/// Finds the growth of large bodies, by Arnoldi's method on the motion after some time. THEORY (9.7). `largest`: of
/// K. Throws std::runtime_error if there is growth and the iteration does not converge.
template <int d>
Growth damped_growth(LinearOperator<d>& op, const SparseMatrix& K, double largest);

}  // namespace plumb
