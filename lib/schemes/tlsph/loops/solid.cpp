#include "lib/schemes/tlsph/loops/solid.hpp"

#include <stdexcept>

#include "lib/core/error.hpp"
#include "lib/material/catalogue.hpp"
#include "lib/schemes/tlsph/loops/kinematics.hpp"
#include "lib/schemes/tlsph/loops/make_solid.hpp"
#include "lib/schemes/tlsph/loops/mirror.hpp"

namespace plumb {

/// In the source of law M (law_sweeps.hpp).
template <int d, class M>
Sweeps<d> law_sweeps(const LawChoice& choice, const Elastic& elastic, const BondTable<d>& bonds);

template <int d>
Sweeps<d> sweeps_of_choice(const LawChoice& law, const Elastic& elastic, const BondTable<d>& bonds) {
  Sweeps<d> sweeps;
  if (!with_named(MaterialCatalogue{}, law.name,
                  [&]<class M>(Type<M>) { sweeps = law_sweeps<d, M>(law, elastic, bonds); }))
    throw unknown_name("material model", law.name, names_of(MaterialCatalogue{}));
  return sweeps;
}

template <int d>
Sweeps<d> sweeps_named(std::string_view material, const Elastic& elastic, const BondTable<d>& bonds) {
  return sweeps_of_choice<d>(LawChoice(std::string(material)), elastic, bonds);
}

template <int d>
Solid<d> make_solid(Cloud<d> cloud, const LawChoice& law, const Elastic& elastic,
                    const BondOptions<d>& options) {
  Solid<d> solid;
  solid.bonds = make_bond_table<d>(cloud, options);
  solid.cloud = std::move(cloud);
  solid.elastic = in_dimension(d, elastic, law.plane);
  solid.smoothing_length = options.smoothing_length;
  solid.sweeps = sweeps_of_choice<d>(law, elastic, solid.bonds);
  solid.volume.assign(solid.bonds.slots.count(), 0.0);
  for (Index i = 0; i < solid.cloud.size(); ++i) solid.volume[solid.bonds.slots.of(i)] = solid.cloud.V[i];
  if (solid.bonds.mirror) add_term(solid, mirror_term(solid));
  return solid;
}

template <int d>
Solid<d> make_solid(Cloud<d> cloud, std::string_view material, const Elastic& elastic,
                    const BondOptions<d>& options) {
  return make_solid<d>(std::move(cloud), LawChoice(std::string(material)), elastic, options);
}

template <int d>
void add_term(Solid<d>& solid, Term<d> term) {
  solid.terms.push_back(std::move(term));
}

template <int d>
void prepare(Workspace<d>& workspace, const Solid<d>& solid, const std::vector<Term<d>>& terms) {
  const Index threads = solid.blocks() >= blocks_for_threads ? omp_get_max_threads() : 1;
  if (workspace.P.shares() != threads) workspace.P = make_stress_window(solid);
  if (stores_F(terms) && workspace.F.components() == 0) workspace.F = solid.make_field(d * d);
  if (stores_force(terms) && workspace.stored_force.components() == 0)
    workspace.stored_force = solid.make_field(d);
}

template <int d>
State<d> make_state(const Solid<d>& solid) {
  State<d> state;
  state.u = solid.make_field(d);
  state.v = solid.make_field(d);
  return state;
}

template <int d>
Trouble find_trouble(const Solid<d>& solid, const State<d>& state) {
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const double J = determinant<d, double>(deformation_gradient_of(solid, state, i));
    if (!(J > 0)) return {i, "J = det F", J};
  }
  throw std::logic_error("an evaluation failed at no particle");
}

template Trouble find_trouble<1>(const Solid<1>&, const State<1>&);
template Trouble find_trouble<2>(const Solid<2>&, const State<2>&);
template Trouble find_trouble<3>(const Solid<3>&, const State<3>&);
template Sweeps<1> sweeps_of_choice<1>(const LawChoice&, const Elastic&, const BondTable<1>&);
template Sweeps<1> sweeps_named<1>(std::string_view, const Elastic&, const BondTable<1>&);
template Sweeps<2> sweeps_of_choice<2>(const LawChoice&, const Elastic&, const BondTable<2>&);
template Sweeps<2> sweeps_named<2>(std::string_view, const Elastic&, const BondTable<2>&);
template Sweeps<3> sweeps_of_choice<3>(const LawChoice&, const Elastic&, const BondTable<3>&);
template Sweeps<3> sweeps_named<3>(std::string_view, const Elastic&, const BondTable<3>&);
template Solid<1> make_solid<1>(Cloud<1>, const LawChoice&, const Elastic&, const BondOptions<1>&);
template Solid<2> make_solid<2>(Cloud<2>, const LawChoice&, const Elastic&, const BondOptions<2>&);
template Solid<3> make_solid<3>(Cloud<3>, const LawChoice&, const Elastic&, const BondOptions<3>&);
template Solid<1> make_solid<1>(Cloud<1>, std::string_view, const Elastic&, const BondOptions<1>&);
template Solid<2> make_solid<2>(Cloud<2>, std::string_view, const Elastic&, const BondOptions<2>&);
template Solid<3> make_solid<3>(Cloud<3>, std::string_view, const Elastic&, const BondOptions<3>&);
template void add_term<1>(Solid<1>&, Term<1>);
template void add_term<2>(Solid<2>&, Term<2>);
template void add_term<3>(Solid<3>&, Term<3>);
template void prepare<1>(Workspace<1>&, const Solid<1>&, const std::vector<Term<1>>&);
template void prepare<2>(Workspace<2>&, const Solid<2>&, const std::vector<Term<2>>&);
template void prepare<3>(Workspace<3>&, const Solid<3>&, const std::vector<Term<3>>&);
template State<1> make_state<1>(const Solid<1>&);
template State<2> make_state<2>(const Solid<2>&);
template State<3> make_state<3>(const Solid<3>&);

}  // namespace plumb
