#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "lib/core/types.hpp"
#include "mms/error_norms.hpp"

namespace plumb::mms {

/// One run of a refinement study.
struct StudyLevel {
  Index n = 0;         ///< particles
  double spacing = 0;  ///< [m]
  double dt = 0;       ///< first time step [s]
  long steps = 0;
  ErrorNorms nodal;                       ///< NaN if the run failed
  std::optional<ErrorNorms> gauss;        ///< by the paper's quadrature, if asked for
  ErrorNorms exact;                       ///< norms of the exact field: what errors are relative to
  std::optional<ErrorNorms> exact_gauss;  ///< by the paper's quadrature, if asked for
  double cpu_s = 0, wall_s = 0;           ///< of the time steps, without set-up
  double setup_s = 0;                     ///< CPU time of the set-up
  std::int64_t pair_evaluations = 0;
  std::optional<std::string> failure;  ///< cause and time, if the run became unstable

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit) {
    visit("n", self.n);
    visit("d", self.spacing);
    visit("dt", self.dt);
    visit("steps", self.steps);
    visit("nodal", self.nodal);
    visit("gauss", self.gauss);
    visit("exact", self.exact);
    visit("exact_gauss", self.exact_gauss);
    visit("cpu_s", self.cpu_s);
    visit("wall_s", self.wall_s);
    visit("setup_s", self.setup_s);
    visit("pair_evaluations", self.pair_evaluations);
    visit("failure", self.failure);
  }
};

}  // namespace plumb::mms
