#pragma once
#include <functional>
#include <optional>

#include "lib/material/law.hpp"

namespace plumb {

/// What a law says at one point. Quantities that it has not are empty.
struct PointState {
  Mat<3> F;       ///< deformation gradient; under plane stress with the F_33 that was found
  Mat<3> cauchy;  ///< Cauchy stress P F^T / J [Pa]
  double equivalent =
      0;  ///< [Pa]: of laws that yield what they compare with the yield stress, else von Mises
  std::optional<double> plastic_strain;
  std::optional<double> temperature;  ///< [K]
  std::optional<double> damage;
  std::optional<int> iterations;  ///< of the return mapping
};

/// A point of a material: each call goes on from the deformation of the call before. Where J is not positive,
/// or no F_33 is found, the stress means nothing or is not a number. Under plane stress only F_11, F_12, F_21
/// and F_22 are read. Points of elastic laws may be asked from several threads.
using MaterialPoint = std::function<PointState(const Mat<3>& F)>;

/// A point at rest of the law of that choice. InputError for an unknown law or parameters that it refuses.
MaterialPoint make_point(const LawChoice& choice, const Elastic& elastic);

/// Von Mises stress sqrt(3/2) |dev sigma| [Pa].
double von_mises(const Mat<3>& sigma);

}  // namespace plumb
