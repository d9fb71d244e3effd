#include "lib/linear/cholesky.hpp"

#include <omp.h>

#include <Eigen/CholmodSupport>
#include <mutex>

namespace plumb {
namespace {

/// Keeps other threads out, and CHOLMOD from starting threads of its own: it asks for four in each of its small loops, whatever
/// OMP_NUM_THREADS says, and waking them takes longer than most loops.
class Alone {
 public:
  Alone() { omp_set_max_active_levels(0); }
  ~Alone() { omp_set_max_active_levels(levels_); }
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

 private:
  static std::mutex& in_use() {
    static std::mutex one_at_a_time;
    return one_at_a_time;
  }
  std::lock_guard<std::mutex> lock_{in_use()};
  int levels_ = omp_get_max_active_levels();
};

}  // namespace

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
