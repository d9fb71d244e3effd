#pragma once
#include <string>
#include <vector>

#include "mms/study.hpp"

namespace plumb::mms {

/// Errors of one integrator, the step halved again and again.
struct TemporalOrder {
  std::string integrator;  ///< a name of the catalogue, or "rk3, loads at t^n" for (30) as printed
  double declared;         ///< order of the integrator; 1 for loads at t^n
  /// Time step [s], nodal L2 norm of the difference to the reference, and how much of that may be round-off.
  std::vector<Level> levels;
  OrderFit fit;         ///< of the levels above the floor
  std::string verdict;  ///< of judge()
};

/// Holds the orders of the integrators in time, on one cloud.
struct TemporalResult {
  double spacing;         ///< of the cloud [m]: the study's first
  Index n;                ///< particles
  double reference_step;  ///< of RK3 [s]
  double spatial_error;   ///< nodal L2 norm of the reference against the exact solution
  std::vector<TemporalOrder> orders;
  std::string status;  ///< of plumb::status_of()
};

/// Whether the level of that number is at the floor of round-off, so that it is shown and not fitted.
bool at_floor(const TemporalOrder& order, std::size_t level);

/// Time errors alone: the study's first cloud is run with fixed steps by every integrator, against RK3 with
/// a quarter of the finest step on the same cloud, so that space does not enter. Six steps, each half of the
/// one before; the first is cfl times d over C_p, or time_step, rounded so that it divides the time. Also
/// (30) as printed, with the loads of all stages at t^n. Levels at the floor of round-off are not fitted:
/// what the roundings of the reference's steps leave. The field of each run is a part of the sitting; throws
/// SittingEnded if that ends.
TemporalResult run_temporal(const Study& study, const StudyProgress& progress, Sitting& sitting);
/// Runs the study in one sitting.
inline TemporalResult run_temporal(const Study& study) {
  Sitting whole;
  return run_temporal(study, {}, whole);
}

}  // namespace plumb::mms
