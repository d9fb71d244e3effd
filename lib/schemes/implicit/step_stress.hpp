#pragma once
#include <functional>

#include "lib/material/law.hpp"

namespace plumb {

/// An elastic law at one point.
template <int d>
struct PointLaw {
  std::function<double(const Mat<d>& F)> energy;       ///< W [Pa]
  std::function<Mat<d>(const Mat<d>& F)> first_piola;  ///< P [Pa]
  std::function<Mat<d * d>(const Mat<d>& F)> tangent;  ///< dP/dF [Pa]
};
/// InputError for a law without energy, or one that feels a superposed rotation ("linear-elastic").
template <int d>
PointLaw<d> objective_law(const LawChoice& law, const Elastic& elastic);

/// Below this a step changes W by less than its round-off: C_1 - C_0 is taken as nothing. THEORY (15.13)
inline constexpr double no_change = 1e-8;

/// Returns C_1 - C_0 of a step whose F is `before` at its beginning and `middle` at its middle.
template <int d>
Mat<d> change_of_stretch(const Mat<d>& before, const Mat<d>& middle);

/// Returns the stress P [Pa] whose work over the step is the change of W, THEORY (15.13).
template <int d>
Mat<d> stress_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle);

/// Returns its derivative by F at the middle [Pa]. It is not symmetric. THEORY (15.15)
template <int d>
Mat<d * d> tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle);

}  // namespace plumb
