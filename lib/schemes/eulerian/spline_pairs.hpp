#pragma once
#include <cmath>

#include "lib/kernel/kernels/cubic_spline.hpp"

namespace plumb {

/// The cubic spline between two particles, by their distance r [m].
template <int d>
class SplinePairs {
 public:
  explicit SplinePairs(double h)
      : per_reach(0.5 / h), per_h_(1 / h), value_(std::pow(h, -d)), slope_(std::pow(h, -d - 2)) {}

  double per_reach;  ///< 1/(2h) [1/m]

  /// W'(r)/r [m^-(d+2)]; not positive, and 0 from 2h on. r > 0.
  double operator()(double r) const {
    const double q = r * per_h_;
    return slope_ * (CubicSpline::dw<d>(q) / q);
  }
  /// W(r) [m^-d].
  double value(double r) const { return value_ * CubicSpline::w<d>(r * per_h_); }

 private:
  double per_h_, value_, slope_;
};

}  // namespace plumb
