#pragma once
#include <string>

#include "lib/scene/tlsph.hpp"

namespace plumb::app {

/// Why a run became unstable, as far as the scene tells: a sentence with what to change, or nothing.
/// `first_step`: the first time step of the run [s].
template <int d>
std::string likely_cause(const Scene& scene, const TlsphBody<d>& simulation, double first_step);

}  // namespace plumb::app
