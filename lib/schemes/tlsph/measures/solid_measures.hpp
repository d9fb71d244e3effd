#pragma once
#include "lib/measures/measures.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// THEORY (8.1), (47a-c) of paper 000 [J] (per metre of thickness in 2D).
struct Energy {
  double kinetic = 0;
  double strain = 0;
  double terms = 0;  ///< of the optional terms that have one (hourglass energy)
  double total() const { return kinetic + strain + terms; }
};

template <int d>
Energy energy_of(const Solid<d>& solid, const State<d>& state);

/// A bound of the round-off in the strain energy of energy_of() near the reference [J]: what is left of
/// energies that cancel. THEORY (8.9).
template <int d>
double energy_round_off(const Solid<d>& solid);

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
