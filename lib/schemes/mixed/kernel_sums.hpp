#pragma once
#include <vector>

#include "lib/geometry/neighbours.hpp"

/// The kernel sums of paper 003 in the material configuration: (36) to (43).
namespace plumb {

/// Kernel of every particle. Weights and gradients are those of the neighbour ("scatter").
struct KernelSums {
  std::vector<double> h;  ///< smoothing length (37): 0.6 times the distance of the farthest neighbour [m]
  std::vector<double> volume;  ///< V_b in the sums: tributary volumes [m^d] or 1
};

/// f_h of (37).
inline constexpr double smoothing_factor = 0.6;

/// Evaluates the quadratic kernel, up to a factor that corrections cancel, times h^d: -(dW/dr)/r and W, with 1/h.
/// Distances never reach 2h, since h is at least 0.6 r.
template <class T>
T kernel_slope(const T& r, const T& inverse_h) {
  return (T(1) - T(0.5) * r * inverse_h) * inverse_h / r;
}
template <class T>
T kernel_value(const T& r, const T& inverse_h) {
  const T t = T(1) - T(0.5) * r * inverse_h;
  return t * t;
}

/// h and volumes of a cloud with this neighbour list. InputError for a particle whose neighbours do not span
/// the space.
template <int d>
KernelSums kernel_sums(const Cloud<d>& cloud, const Neighbours& list, bool equal_volumes);

/// g_ab = V_b C*[grad W_b(a)] of (42) [1/m], for every entry of the list of a; zero for a itself.
template <int d>
std::vector<Vec<d>> corrected_gradients(const Cloud<d>& cloud, const Neighbours& list, const KernelSums& sums,
                                        Index a);

}  // namespace plumb
