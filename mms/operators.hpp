#pragma once
#include <array>

#include "mms/study.hpp"

namespace plumb::mms {

/// The operators of a scheme, in the order of OperatorLevel::error.
inline constexpr std::array<std::string_view, 3> operator_names{"F", "Div P", "Laplacian"};
/// Parts of the body: inside no sum sees a cut support, not even at second hand (a quarter of the body's
/// least extent away from its surface); the boundary is what lies within two support radii of it.
inline constexpr std::array<std::string_view, 2> part_names{"inside", "boundary"};

/// Errors on the exact field of one time, without any time step.
struct OperatorLevel {
  Index n = 0;         ///< particles
  double spacing = 0;  ///< [m]
  /// error[operator][part]: L2 over the particles of the part (inside with the square of the distance from
  /// its rim as weight), relative to the root mean square of the exact quantity over the body. F: deformation
  /// gradient, relative to F - I; Div P: force per volume without loads, against Div P - P B/V: by THEORY
  /// (11.4) the force on a particle with the outward boundary area B holds the traction -P B. Laplacian: of
  /// the displacement with the weights of (6.3).
  std::array<std::array<double, 2>, 3> error{};
  /// Integration constraint: root mean square inside of |force| d / |stress| under the uniform stress I. Zero
  /// if a uniform stress leaves no force; of order p it limits Div P to order p - 1.
  double constraint = 0;
};

/// Holds the order of one operator on a part of the body.
struct OperatorFit {
  std::string name, part;  ///< a name of operator_names or "constraint"; a name of part_names
  OrderFit fit;
  std::string verdict;  ///< the trend: nothing is declared
};

/// Holds the errors of all operators on all levels, with their orders.
struct OperatorResult {
  std::vector<OperatorLevel> levels;
  std::vector<OperatorFit> fits;
  /// Is that of plumb::status_of() from the inside: nothing is declared. At the boundary most schemes spread the
  /// traction over several layers of particles, so that Div P does not converge there from point to point.
  std::string status;
};

/// Applies the study's scheme to the exact displacements of its end time, on every spacing. Throws InputError
/// if the coarsest spacing leaves no inside, or if the field is zero then.
OperatorResult run_operators(const Study& study, const StudyProgress& progress = {});

}  // namespace plumb::mms
