#pragma once
#include <Eigen/Core>
#include <limits>

namespace plumb {

/// What a search by conjugate gradients found.
struct Conjugated {
  Eigen::VectorXd x;
  int iterations = 0;
  double residual = 0;     ///< |b - K x| over |b|, as the recurrence has it
  bool converged = false;  ///< it is at most the tolerance
  bool indefinite =
      false;  ///< K was met with a direction along which it is not positive: x is what was found before
};

/// Solves K x = b for a symmetric positive K by conjugate gradients. `product(v)` is K v; `precondition(r)` a symmetric positive
/// approximation of K^-1 r. Where K turns out not to be positive, x is the sum so far, which is a direction of descent for the
/// potential of which -b is the slope; at the first iteration it is precondition(b). (The class of Eigen does not tell.)
template <class Product, class Precondition>
Conjugated conjugate_gradients(Product&& product, Precondition&& precondition, const Eigen::VectorXd& b,
                               double tolerance, int most) {
  Conjugated found{Eigen::VectorXd::Zero(b.size())};
  const double scale = b.norm();
  if (scale == 0) {
    found.converged = true;
    return found;
  }
  Eigen::VectorXd r = b, z = precondition(r), p = z;
  double rz = r.dot(z);
  for (found.residual = 1; found.iterations < most; ++found.iterations) {
    const Eigen::VectorXd q = product(p);
    const double curvature = p.dot(q);
    if (!(curvature > 0)) {
      found.indefinite = true;
      if (found.iterations == 0) found.x = p;
      return found;
    }
    const double length = rz / curvature;
    found.x += length * p;
    r -= length * q;
    found.residual = r.norm() / scale;
    if (found.residual <= tolerance) {
      found.converged = true;
      ++found.iterations;
      return found;
    }
    z = precondition(r);
    const double next = r.dot(z);
    p = z + next / rz * p;
    rz = next;
  }
  return found;
}

}  // namespace plumb
