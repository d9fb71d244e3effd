#pragma once
#include <string>
#include <vector>

#include "plumbline/scene/simulation.hpp"

namespace plumb {

/// One line of what a scene solves: "force", "adjoint: minus the derivative ..", "THEORY (5.1), (5.3)".
struct Statement {
  std::string topic, text, theory;
};

/// What the scene solves, from the body to its supports, with the equations. Names of the catalogues are
/// explained by the docstrings of their headers.
template <int d>
std::vector<Statement> account_of(const Scene& scene, const Simulation<d>& simulation);

/// What the first time step dt [s] follows from, as a clause: "cfl = 0.5 times ..".
template <int d>
Statement step_reason(const Scene& scene, const Simulation<d>& simulation, double dt);

}  // namespace plumb
