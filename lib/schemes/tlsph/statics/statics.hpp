#pragma once
#include <vector>

#include "lib/schemes/tlsph/loops/linearise.hpp"

namespace plumb {

/// One component of the displacement that is given.
struct Prescribed {
  Index unknown;  ///< d x particle + component
  double value;   ///< [m]
};

/// Small displacements in equilibrium: K u = load on all unknowns that are not prescribed. `load` is the
/// force on each unknown [N] (per metre of thickness in 2D). Works for any momentum form, symmetric or not
/// (sparse LU). Throws InputError if the body can move freely.
Eigen::VectorXd equilibrium(const SparseMatrix& stiffness, const Eigen::VectorXd& load,
                            const std::vector<Prescribed>& prescribed);

/// A vibration K u = omega^2 M u of the unknowns that are not held.
struct Vibration {
  double angular_frequency;  ///< omega [rad/s]
  Eigen::VectorXd shape;     ///< of all unknowns; zero where held
};

/// The vibration nearest to a guess: inverse iteration with the shift omega_guess^2 from the guessed shape.
/// Throws std::runtime_error if it does not converge (the guess lies half-way between two frequencies).
Vibration vibration_near(const Linearised& body, double omega_guess, const Eigen::VectorXd& shape_guess,
                         const std::vector<Index>& held);

}  // namespace plumb
