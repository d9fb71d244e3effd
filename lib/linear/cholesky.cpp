#include "lib/linear/cholesky.hpp"

#include <Eigen/CholmodSupport>

#include "lib/linear/alone.hpp"

namespace plumb {
struct Cholesky::Factor {
  Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> cholmod;
};

Cholesky::Cholesky() {
  const Alone alone;
  factor_ = std::make_unique<Factor>();
  // a pivot that is not positive is no news to the user, and standard output is for results
  factor_->cholmod.cholmod().print = 0;
}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyse(const Matrix& matrix) {
  const Alone alone;
  factor_->cholmod.analyzePattern(matrix);
}

bool Cholesky::factorise(const Matrix& matrix, double shift) {
  const Alone alone;
  factor_->cholmod.setShift(shift);
  factor_->cholmod.factorize(matrix);
  return factor_->cholmod.info() == Eigen::Success;
}

Eigen::MatrixXd Cholesky::solve(const Eigen::MatrixXd& right) const {
  const Alone alone;
  return factor_->cholmod.solve(right);
}

}  // namespace plumb
