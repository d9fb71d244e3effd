#pragma once
#include "lib/schemes/implicit/implicit_options.hpp"
#include "lib/schemes/implicit/stored_energy.hpp"

namespace plumb {

/// Returns the energy with those equations of paper 004 that `options` take as they are printed, to show what they do; the others
/// are as they must be:
///   (27)  the forces of the hourglass energy have the other sign, so that they are not its derivative;
///   (29)  its stiffness is that of the energy of a displacement, half of the second derivative;
///   (61)  dP/dF of the law neo-hookean-logarithmic lacks -mu J_FF/J.
/// Energies stay what they are.
template <int d>
StoredEnergy<d> with_misprints(StoredEnergy<d> energy, const ImplicitOptions& options);

}  // namespace plumb
