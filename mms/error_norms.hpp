#pragma once
#include <array>
#include <string_view>

namespace plumb::mms {

/// Absolute norms of an error. In d dimensions L2 norms have the unit of the quantity times m^(d/2).
struct ErrorNorms {
  double l2 = 0;           ///< (44): square root of the integral of |u - u_h|^2
  double h1 = 0;           ///< (45): seminorm, the same for the gradients
  double linf = 0;         ///< largest |u - u_h|
  double velocity_l2 = 0;  ///< of u_t
  double stress_l2 = 0;    ///< of P, Frobenius norm

  template <class Self, class Visit>
  static void members(Self& self, Visit&& visit);
};

/// One norm by its name.
struct NormName {
  std::string_view name, meaning;
  double ErrorNorms::*value;
};
inline constexpr std::array<NormName, 5> norm_names{
    {{"l2", "L2", &ErrorNorms::l2},
     {"h1", "H1", &ErrorNorms::h1},
     {"linf", "max", &ErrorNorms::linf},
     {"velocity_l2", "velocity, L2", &ErrorNorms::velocity_l2},
     {"stress_l2", "stress, L2", &ErrorNorms::stress_l2}}};

template <class Self, class Visit>
void ErrorNorms::members(Self& self, Visit&& visit) {
  for (const NormName& norm : norm_names) visit(norm.name.data(), self.*norm.value);  // each ends with a zero
}

}  // namespace plumb::mms
