#pragma once
#include <omp.h>

#include <mutex>

namespace plumb {

/// Keeps other threads out of CHOLMOD, LAPACK and the BLAS under them, which need not be built for several callers, as long as it lives; and
/// keeps CHOLMOD from starting threads of its own: it asks for four in each of its small loops, whatever OMP_NUM_THREADS says, and waking
/// them takes longer than most loops.
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

}  // namespace plumb
