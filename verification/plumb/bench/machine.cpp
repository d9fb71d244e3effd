#include "verification/plumb/bench/machine.hpp"

#include <omp.h>

#include <algorithm>
#include <vector>

#include "lib/core/pack.hpp"

namespace plumb::app::bench {
namespace {

constexpr int repeats = 8;

/// Least wall time of some repeats [s].
template <class F>
double least_time(F&& work) {
  double least = 1e9;
  for (int n = 0; n < repeats; ++n) {
    const double start = omp_get_wtime();
    work();
    least = std::min(least, omp_get_wtime() - start);
  }
  return least;
}

double fma_rate(int threads) {
  constexpr int chains = 12;  // more than latency x throughput of any x86-64 core (10)
  constexpr long rounds = 2'000'000;
  using Real = Pack<native_width>;
  double kept = 0;
  const double seconds = least_time([&] {
#pragma omp parallel num_threads(threads) reduction(+ : kept)
    {
      Real sum[chains];
      for (int c = 0; c < chains; ++c) sum[c] = Real(c);
      const double almost_one = 0.999999;
      const Real factor = Real::load_once(AlignedVector(native_width, almost_one).data()), offset(1e-6);
      for (long r = 0; r < rounds; ++r)
        for (Real& chain : sum) chain = chain * factor + offset;
      for (const Real& chain : sum) kept += chain[0];
    }
  });
  const volatile double sink = kept;  // the sums are used
  static_cast<void>(sink);
  return 2.0 * native_width * chains * static_cast<double>(rounds) * threads / seconds * 1e-9;
}

double triad_rate(int threads) {
  constexpr long size = 4'000'000;
  std::vector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
  const double seconds = least_time([&] {
#pragma omp parallel for schedule(static) num_threads(threads)
    for (long i = 0; i < size; ++i) a[i] = b[i] + 3.0 * c[i];
    const volatile double sink = a[size / 2];
    static_cast<void>(sink);
  });
  return 24.0 * static_cast<double>(size) / seconds * 1e-9;
}

}  // namespace

Machine measure_machine(int threads) {
  return {threads, fma_rate(threads), triad_rate(threads)};
}

}  // namespace plumb::app::bench
