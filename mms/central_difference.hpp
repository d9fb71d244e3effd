#pragma once

namespace plumb::mms {

/// Gives the slope of f at 0 by a central difference of eighth order with step h; f is a function of Real
/// with values that are matrices.
template <class Real, class Function>
auto central_difference(const Function& f, Real h) {
  const auto pair = [&](int k) { return (f(Real(k) * h) - f(Real(-k) * h)).eval(); };
  return ((pair(1) * (Real(4) / 5) - pair(2) * (Real(1) / 5) + pair(3) * (Real(4) / 105) -
           pair(4) * (Real(1) / 280)) /
          h)
      .eval();
}

}  // namespace plumb::mms
