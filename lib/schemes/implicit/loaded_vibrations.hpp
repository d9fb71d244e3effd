#pragma once
#include <vector>

#include "lib/schemes/implicit/balance.hpp"

namespace plumb {

/// A small vibration about an equilibrium, K(u) x = omega^2 M x. THEORY (15.11).
struct LoadedVibration {
  double
      square;  ///< omega^2 [1/s^2]; negative: the equilibrium is unstable, x grows like exp(sqrt(-square) t)
  Eigen::VectorXd shape;  ///< of all unknowns, with x M x = 1; zero where held
};

/// Returns the `count` lowest vibrations about the displacements u, ascending: K is the tangent of the
/// balance there, M the lumped mass. By subspace iteration with a shift below the lowest one, to 1e-9 of each
/// omega^2. Throws InputError if a pressure follows (K is then not symmetric) and std::runtime_error if the
/// iteration does not converge.
template <int d>
std::vector<LoadedVibration> vibrations_about(Balance<d>& balance, const Eigen::VectorXd& u, int count);

}  // namespace plumb
