#include "lib/material/logarithmic_strain.hpp"

#include <Eigen/Eigenvalues>

namespace plumb {

LogarithmicStrain::LogarithmicStrain(const Mat<3>& b) {
  const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(0.5 * (b + b.transpose()));
  square = solver.eigenvalues();
  directions = solver.eigenvectors();
  strain = 0.5 * square.array().log();
}

}  // namespace plumb
