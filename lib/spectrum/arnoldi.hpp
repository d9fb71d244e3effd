#pragma once
#include <Spectra/GenEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/spectrum/eigen_pairs.hpp"

namespace plumb {

/// Size of the Krylov space: twice the number wanted and some, as the authors of ARPACK advise.
inline int krylov_space(Index unknowns, int count) {
  return static_cast<int>(std::min<Index>(unknowns, 2 * count + 20));
}

/// A start of length 1 that holds every mode; its numbers do not matter.
inline Eigen::VectorXd broad_start(Index size) {
  Eigen::VectorXd start(size);
  for (Index n = 0; n < size; ++n) start[n] = std::sin(12.9898 * static_cast<double>(n + 1));
  return start.normalized();
}

/// The logarithm of the least modulus that outer_span() is sure to find beside a disc of radius 1: it
/// converges like modulus^-(some 100 applications), here to 1e-11.
inline const double arnoldi_resolution = std::log(1.3);

/// The span of vectors of an operator with its eigenvalues of largest modulus, as far as they converge.
/// `grows`: some modulus is far above 1. Then none at all is an error (std::runtime_error); otherwise two
/// restarts show what there is. Operator: as Spectra wants it.
template <class Operator>
Eigen::MatrixXd outer_span(Operator& op, bool grows) {
  const int wanted = static_cast<int>(std::min<Index>(20, op.rows() - 2));
  Spectra::GenEigsSolver<Operator> solver(op, wanted, krylov_space(op.rows(), wanted));
  solver.init();
  const auto found = solver.compute(Spectra::SortRule::LargestMagn, grows ? 100 : 2, 1e-8);
  if (grows && found == 0) throw std::runtime_error("the iteration for growing motion did not converge");
  return real_span(solver.eigenvectors());
}

}  // namespace plumb
