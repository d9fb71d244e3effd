#include "lib/schemes/implicit/stored_energy.hpp"

#include <algorithm>
#include <memory>

#include "lib/core/error.hpp"
#include "lib/schemes/tlsph/loops/body_history.hpp"
#include "lib/schemes/tlsph/loops/commit_history.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"

namespace plumb {
namespace {

/// Those of the terms of a body that are energies.
template <int d>
std::vector<Term<d>> energies_of(std::vector<Term<d>> terms) {
  for (const auto& term : terms)
    if (term.whole)
      throw InputError("[" + term.name + "] beside the implicit scheme",
                       "it changes forces as a whole, so that they have no energy", "leave it out");
  std::erase_if(terms, [](const Term<d>& term) { return !term.energy && !term.internal; });
  return terms;
}

/// The body with the terms that count, and a state of it that each question moves.
template <int d>
struct Asked {
  std::shared_ptr<const Solid<d>> solid;
  std::vector<Term<d>> terms;
  State<d> state;
  Workspace<d> workspace = {};
  Outcome outcome = {};  ///< of the last residual
};

/// The sum of what has the force as its derivative: strain energy or potential of the increment, and the energies of terms.
template <int d>
double potential_of(const Asked<d>& asked) {
  const Solid<d>& solid = *asked.solid;
  const State<d>& state = asked.state;
  const auto& history = solid.sweeps.history;
  double sum = sum_over_blocks(solid, [&](const Block& block) {
    return (history ? history->potential : solid.sweeps.energy)(solid.bonds, state.u, block,
                                                                solid.volume.data());
  });
  for (const auto& term : asked.terms)
    if (term.energy) sum += term.energy(solid, state);
  return sum;
}

template <int d>
std::optional<Eigen::VectorXd> residual_of(Asked<d>& asked, const Eigen::VectorXd& u) {
  const Solid<d>& solid = *asked.solid;
  set_unknowns(solid, u, asked.state.u);
  Field force = solid.make_field(d);
  asked.outcome = evaluate(
      solid, asked.terms, asked.workspace, asked.state, 0, [&](const Block& block, BlockForce<d>& of_block) {
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
StoredEnergy<d> stored_energy(std::shared_ptr<const Solid<d>> body) {
  const Solid<d>& solid = *body;
  const auto asked =
      std::make_shared<Asked<d>>(Asked<d>{std::move(body), energies_of(solid.terms), make_state(solid)});
  StoredEnergy<d> made;
  made.cloud = solid.cloud;
  made.elastic = solid.elastic;
  made.slots = solid.bonds.slots;
  made.operators = std::make_shared<const EnergyOperators<d>>(energy_operators(solid, asked->terms));
  made.energy = [asked](const Eigen::VectorXd& u) {
    set_unknowns(*asked->solid, u, asked->state.u);
    return potential_of(*asked);
  };
  made.residual = [asked](const Eigen::VectorXd& u) { return residual_of(*asked, u); };
  made.tangent = [tangent = solid.sweeps.tangent](const Mat<d>& F, Index) { return tangent(F); };
  if (solid.sweeps.history) {
    made.tangent = [asked](const Mat<d>& F, Index place) {
      return asked->solid->sweeps.history->tangent(F, asked->solid->bonds.slots.of(place));
    };
    made.commit = [asked](const Eigen::VectorXd& u) {
      set_unknowns(*asked->solid, u, asked->state.u);
      commit_history(*asked->solid, asked->state);
    };
  }
  made.trouble = [asked] { return asked->outcome.trouble; };
  made.round_off = energy_round_off(solid);
  return made;
}

#define PLUMBLINE_INSTANTIATE(d) template StoredEnergy<d> stored_energy<d>(std::shared_ptr<const Solid<d>>);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
