#pragma once

namespace plumb {

/// How systems with the tangent are solved.
enum class LinearSolver {
  direct,    ///< by factors of the assembled tangent
  iterative  ///< by conjugate gradients with products alone, preconditioned on two levels
};

}  // namespace plumb
