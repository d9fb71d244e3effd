#pragma once
#include "lib/measures/energy.hpp"
#include "lib/measures/measures.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// Finds the energies [J] (per metre of thickness in 2D), by THEORY (8.1), (47a-c) of paper 000; `more` has those of optional
/// terms (hourglass energy) and the plastic work of a law with history.
template <int d>
Energy energy_of(const Solid<d>& solid, const State<d>& state);

/// A bound of the round-off in the strain energy of energy_of() near the reference [J]: what is left of
/// energies that cancel. THEORY (8.9).
template <int d>
double energy_round_off(const Solid<d>& solid);

/// Sums up the momenta of a state, and finds the smallest box around its particles [m].
template <int d>
Momentum momentum_of(const Solid<d>& solid, const State<d>& state);
template <int d>
Extent<d> extent_of(const Solid<d>& solid, const State<d>& state);

/// Share of the deformation that neighbouring deformation gradients do not explain: rms of x_ij - (F_i + F_j)
/// X_ij / 2 over nearest pairs (r < 1.1 spacings), relative to rms x_ij. Zero for affine motion. THEORY
/// (8.4).
template <int d>
double hourglass_share(const Solid<d>& solid, const State<d>& state);

}  // namespace plumb
