#include "lib/schemes/implicit/stored_energy.hpp"

#include <algorithm>
#include <memory>

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/time/commit_history.hpp"

namespace plumb {
namespace {

/// Sums of some ten rounded products.
constexpr double rounding = 1e-12;

/// The force has an energy if D is the transposed of V G, the adjoint form. THEORY (5.3).
template <int d>
void require_energy(const Solid<d>& solid, const LinearOperators& operators) {
  SparseMatrix difference = operators.gradient.transpose();
  for (Index n = 0; n < difference.cols(); ++n) difference.col(n) *= -solid.cloud.V[n / (d * d)];
  difference += operators.force;
  if (difference.norm() <= rounding * operators.force.norm()) return;
  throw InputError(
      "this internal force has no energy",
      "equilibrium is sought as a stationary point of the energy, and the force is not its derivative",
      "use momentum = \"adjoint\"");
}

/// The body with those of its terms that are energies.
template <int d>
Solid<d> energies_of(Solid<d> solid) {
  for (const auto& term : solid.terms)
    if (term.whole)
      throw InputError("[" + term.name + "] beside the implicit scheme",
                       "it changes forces as a whole, so that they have no energy", "leave it out");
  std::erase_if(solid.terms, [](const Term<d>& term) { return !term.energy && !term.internal; });
  return solid;
}

/// The body and a state of it that each question moves.
template <int d>
struct Asked {
  Solid<d> solid;
  State<d> state;
  Workspace<d> workspace = {};
  Outcome outcome = {};  ///< of the last residual
};

/// The sum of what has the force as its derivative: strain energy or potential of the increment, and the energies of terms.
template <int d>
double potential_of(const Solid<d>& solid, const State<d>& state) {
  const auto& history = solid.sweeps.history;
  double sum = sum_over_blocks(solid, [&](const Block& block) {
    return (history ? history->potential : solid.sweeps.energy)(solid.bonds, state.u, block,
                                                                solid.volume.data());
  });
  for (const auto& term : solid.terms)
    if (term.energy) sum += term.energy(solid, state);
  return sum;
}

template <int d>
std::optional<Eigen::VectorXd> residual_of(Asked<d>& asked, const Eigen::VectorXd& u) {
  const Solid<d>& solid = asked.solid;
  set_unknowns(solid, u, asked.state.u);
  Field force = solid.make_field(d);
  asked.outcome =
      evaluate(solid, asked.workspace, asked.state, 0, [&](const Block& block, BlockForce<d>& of_block) {
        for (int k = 0; k < d; ++k)
          std::copy_n(of_block.at(k, block.begin()), block.end() - block.begin(), force[k] + block.begin());
      });
  if (!asked.outcome) return std::nullopt;
  Eigen::VectorXd result(u.size());
  for (Index i = 0; i < solid.cloud.size(); ++i)
    result.segment<d>(d * i) = -solid.cloud.V[i] * vector_at<d>(force, solid.bonds.slots.of(i));
  return result;
}

}  // namespace

template <int d>
StoredEnergy<d> stored_energy(const Solid<d>& body) {
  const auto asked = std::make_shared<Asked<d>>(Asked<d>{energies_of(body), make_state(body)});
  const Solid<d>& solid = asked->solid;
  StoredEnergy<d> made;
  made.cloud = solid.cloud;
  made.elastic = solid.elastic;
  made.slots = solid.bonds.slots;
  made.operators = linear_operators(solid);
  require_energy(solid, made.operators);
  made.energy = [asked](const Eigen::VectorXd& u) {
    set_unknowns(asked->solid, u, asked->state.u);
    return potential_of(asked->solid, asked->state);
  };
  made.residual = [asked](const Eigen::VectorXd& u) { return residual_of(*asked, u); };
  made.tangent = [tangent = solid.sweeps.tangent](const Mat<d>& F, Index) { return tangent(F); };
  if (solid.sweeps.history) {
    made.tangent = [asked](const Mat<d>& F, Index place) {
      return asked->solid.sweeps.history->tangent(F, asked->solid.bonds.slots.of(place));
    };
    made.commit = [asked](const Eigen::VectorXd& u) {
      set_unknowns(asked->solid, u, asked->state.u);
      commit_history(asked->solid, asked->state);
    };
  }
  made.trouble = [asked] { return asked->outcome.trouble; };
  made.round_off = energy_round_off(solid);
  return made;
}

template StoredEnergy<1> stored_energy<1>(const Solid<1>&);
template StoredEnergy<2> stored_energy<2>(const Solid<2>&);
template StoredEnergy<3> stored_energy<3>(const Solid<3>&);

}  // namespace plumb
