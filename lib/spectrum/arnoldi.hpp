#pragma once
#include <algorithm>
#include <cmath>
#include <functional>

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

/// A square matrix that is known by what it does to vectors.
struct LinearMap {
  Index size;
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> image;
};

/// Finds the span of the eigenvectors whose eigenvalues have the largest modulus, as far as they converge.
/// `grows`: some modulus is far above 1. Then none at all is an error (std::runtime_error); otherwise two
/// restarts show what there is.
Eigen::MatrixXd outer_span(const LinearMap& map, bool grows);

}  // namespace plumb
