#pragma once
#include <Eigen/Core>
#include <Eigen/LU>
#include <cstddef>
#include <cstdint>

namespace plumb {

/// Particle numbers and counts.
using Index = std::ptrdiff_t;

/// Vector and second-order tensor in d dimensions over the scalar T (double, complex, autodiff, Pack).
template <int d, class T = double>
using Vec = Eigen::Matrix<T, d, 1>;
template <int d, class T = double>
using Mat = Eigen::Matrix<T, d, d>;

}  // namespace plumb
