#pragma once
#include <array>
#include <vector>

#include "plumbline/boundary/supports.hpp"
#include "plumbline/geometry/cloud.hpp"
#include "plumbline/scene/scene.hpp"

namespace plumb {

/// What expressions of X, Y, Z are asked at.
std::array<double, 3> in_space(const auto& X) {
  std::array<double, 3> point{0, 0, 0};
  for (int k = 0; k < X.size(); ++k) point[k] = X[k];
  return point;
}

/// One formula per component, at X [m].
template <int d>
Vec<d> evaluate_at(const std::vector<Expression>& expressions, const Vec<d>& X) {
  Vec<d> value;
  for (int k = 0; k < d; ++k) value[k] = expressions[k].at(in_space(X));
  return value;
}

/// What the [[boundary]] tables of a scene hold, particle by particle and component by component. Throws
/// InputError where one holds nothing.
template <int d>
std::vector<Support<d>> supports_of_scene(const Cloud<d>& cloud, const Scene& scene);

/// Two boundaries may meet in a particle if they say the same of each component; otherwise InputError.
template <int d>
void refuse_contradictions(const Cloud<d>& cloud, std::vector<Support<d>> supports);

}  // namespace plumb
