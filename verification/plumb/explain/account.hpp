#pragma once
#include <string>
#include <vector>

#include "lib/scene/tlsph.hpp"

namespace plumb::app {

/// What the scene solves, from the body to its supports, with the equations. Names of the catalogues are
/// explained by the docstrings of their headers.
template <int d>
std::vector<Statement> account_of(const Scene& scene, const TlsphBody<d>& simulation);

/// What the first time step dt [s] follows from, as a clause: "cfl = 0.5 times ..".
template <int d>
Statement step_reason(const Scene& scene, const TlsphBody<d>& simulation, double dt);

}  // namespace plumb::app
