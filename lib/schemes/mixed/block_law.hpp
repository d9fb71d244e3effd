#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/material/history_field.hpp"
#include "lib/material/law.hpp"
#include "lib/schemes/mixed/mixed_state.hpp"

namespace plumb {

/// Deformation gradient and first Piola-Kirchhoff stress [Pa] of one particle in three dimensions.
struct WholePoint {
  Mat<3> F, P;
};

/// A law as loops over slots, chosen once. F is the deformation gradient by slot, d x d.
template <int d>
struct BlockLaw {
  /// P of the slots [begin, end) [Pa], d x d.
  std::function<void(const MixedState<d>&, const Field& F, Index begin, Index end, Field& P)> stress;
  /// Sum V W of the slots [J].
  std::function<double(const MixedState<d>&, const Field& F, const double* volume, Index begin, Index end)>
      energy;
  std::function<WholePoint(const MixedState<d>&, const Field& F, Index slot)> whole;
  /// Sigma_J of the slots [begin, end) [Pa], of laws of F, H and J; empty otherwise.
  std::function<void(const MixedState<d>&, const Field& F, Index begin, Index end, Field& sigma)> of_volume =
      {};
  /// With a history: sum V times the potential of the increment from it [J], and dP/dF of the increment [Pa]; empty without.
  std::function<double(const MixedState<d>&, const Field& F, const double* volume, Index begin, Index end)>
      potential;
  std::function<Eigen::Matrix<double, d * d, d * d>(const MixedState<d>&, const Mat<d>& F, Index slot)>
      tangent;
  /// Moves the history to the end of a step; empty: the law has none.
  std::function<void(MixedState<d>&, const Field& F, Index begin, Index end)> commit;
  std::vector<HistoryValue> history;
  int history_components = 0;
  std::optional<int> plastic_work;  ///< its place in the history [J/m^d]; none without plasticity
};

/// The law of that choice: W(F, H, J) with H and J of the state if they evolve, otherwise W(F) or a law with
/// history. InputError where a law is not one of F, H and J, or a body cannot have it.
template <int d>
BlockLaw<d> block_law(const LawChoice& law, const Elastic& elastic, bool evolves_HJ);

/// Gives the history of every slot the values of an undeformed body.
template <int d>
void start_history(const LawChoice& law, MixedState<d>& state, Index slots);

}  // namespace plumb
