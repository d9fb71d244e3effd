#pragma once
#include <chrono>

#include "lib/output/sitting.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb::mms {

/// Tells a sitting after each step how far a run is, and how many pairs it evaluates a second; the sitting
/// may end it there.
template <int d>
class Pace {
 public:
  Pace(Sitting& sitting, const TlsphBody<d>& simulation) : sitting_(sitting), simulation_(simulation) {}

  /// Throws SittingEnded if the sitting is to end. A step of a hundred particles takes some 10 us; this is
  /// 0.1 us.
  void tell() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    sitting_.check(
        simulation_.state.time / *simulation_.control.end_time,
        static_cast<double>(simulation_.integrator.workspace->work.pair_evaluations) / elapsed.count());
  }

 private:
  Sitting& sitting_;
  const TlsphBody<d>& simulation_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace plumb::mms
