#pragma once
#include <functional>
#include <vector>

#include "lib/material/history_field.hpp"
#include "lib/schemes/tlsph/loops/solid.hpp"

namespace plumb {

/// What a body of a law with history remembers. The loops of the body read it, and a step commits it once, at
/// its end; evaluations map back from the history of the step's start and leave it alone. It belongs to the
/// body: copies of its loops share it.
template <int d>
struct BodyHistory {
  std::vector<HistoryValue> values;  ///< the last is the plastic work per reference volume [J/m^3]
  Field field;                       ///< by slot
  /// Moves the history of the slots of a block to the end of a step that has led to these displacements.
  std::function<void(const BondTable<d>&, const Field& u, const Block&)> commit;
  /// Gives the first Piola-Kirchhoff stress [Pa] of a slot at its committed history.
  std::function<Mat<3>(const Mat<3>& F, Index slot)> first_piola;
  /// Sums over the slots of a block the potentials [J] of the increment from the committed history, of which the stress is the
  /// first derivative.
  std::function<double(const BondTable<d>&, const Field& u, const Block&, const double* volume)> potential;
  /// Gives the second derivative of that of one slot [Pa].
  std::function<Tangent<d>(const Mat<d>& F, Index slot)> tangent;

  const HistoryValue& plastic_work() const { return values.back(); }
  int components() const { return plastic_work().first + 1; }
};

}  // namespace plumb
