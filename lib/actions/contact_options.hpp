#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lib/input/expression.hpp"

namespace plumb {

/// Names a rigid wall that the body may touch, a plane or triangles, or two bodies and how they touch. It is one section
/// [[contact]] of a scene.
struct ContactOptions {
  std::string body;                   ///< the first name of `between`; empty: every body
  bool of_bodies = false;             ///< `wall` is another body: there is neither plane nor triangles
  std::string wall = "wall";          ///< what results call it: the second name of `between`
  std::vector<double> point, normal;  ///< of a plane [m]; the normal points out of the wall. Empty: triangles
  std::vector<double> corners;        ///< of triangles that close a surface [m], nine numbers each
  std::vector<Expression> displacement;  ///< of the wall [m], formulas of t; empty: it does not move
  std::optional<double> stiffness;       ///< E* of Hertz [Pa]; absent: E/(1 - nu^2) of the body
  double friction = 0;                   ///< Coulomb's coefficient
};

}  // namespace plumb
