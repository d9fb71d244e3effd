#pragma once
#include <vector>

#include "oned/cloud.hpp"

namespace plumb::oned {

/// What a correction does to the kernel at one place.
struct ProfileRow {
  double x;          ///< [m]
  double alpha;      ///< of the first-order kernel (6), by (8)
  double beta;       ///< likewise, by (7) [1/m]
  double VW;         ///< sum V W of the plain kernel: 1 is what a correction aims at
  double VW0, VW1;   ///< the same of the Shepard and of the first-order kernel
  double condition;  ///< of the moment matrix [m0 m1; m1 m2], lengths in R
  double negative;   ///< sum V |W1| where W1 < 0: 0 if the weights are a mean
};

/// The correction at every point of `at`, particle or not, in that order. InputError as explore().
std::vector<ProfileRow> correction_profile(const Discretisation& discretisation,
                                           const std::vector<double>& at);

/// So many points from 0 to L, both ends included. InputError if there are fewer than 2 or more than 1000000.
std::vector<double> even_points(double length, Index count);

}  // namespace plumb::oned
