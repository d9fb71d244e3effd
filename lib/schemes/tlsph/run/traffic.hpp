#pragma once
#include "lib/schemes/tlsph/time/integrator.hpp"

namespace plumb {

/// Bytes that an update (one evaluation of F, stress and force for one particle, and what the integrator does
/// with it) reads and writes, by the model THEORY (10.8): every array once for each pass over it, tables only
/// where each particle has rows of its own. The same on every machine.
template <int d>
double bytes_per_update(const Solid<d>& solid, const ChosenIntegrator<d>& integrator);

}  // namespace plumb
