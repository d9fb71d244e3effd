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

/// Returns the stress P [Pa] whose work over the step is the change of W, THEORY (15.13).
template <int d>
Mat<d> stress_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle);

/// Returns its derivative by F at the middle [Pa]. It is not symmetric. THEORY (15.15)
template <int d>
Mat<d * d> tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle);
/// Returns the symmetric matrix near it that has F_m in place of F_1 [Pa].
template <int d>
Mat<d * d> symmetric_tangent_of_step(const PointLaw<d>& law, const Mat<d>& before, const Mat<d>& middle);

}  // namespace plumb
