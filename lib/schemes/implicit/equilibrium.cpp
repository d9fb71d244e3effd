#include "lib/schemes/implicit/equilibrium.hpp"

#include "lib/schemes/implicit/misprints.hpp"

namespace plumb {

template <int d>
StaticResult<d> find_equilibrium(StoredEnergy<d> energy, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, BodyMotion& motion,
                                 const OnLoadStep& on_step) {
  StaticResult<d> result;
  LoadPath<d> path(std::move(energy), actions, end_time, options, motion);
  result.failure = path.go_to(end_time, motion, [&](const BodyMotion& now, const LoadStep& step) {
    result.steps.push_back(step);
    if (on_step) on_step(now, step);
  });
  result.rejected = path.rejected();
  result.reactions = path.reactions(motion);
  return result;
}

template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state, const OnLoadStep& on_step) {
  BodyMotion motion = motion_of<d>(solid.bonds.slots, state);
  const auto result = find_equilibrium<d>(with_misprints(stored_energy(solid), options), actions, end_time,
                                          options, motion, on_step);
  set_motion<d>(solid.bonds.slots, motion, state);
  return result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                                        \
  template StaticResult<d> find_equilibrium<d>(StoredEnergy<d>, const Actions<d>&, double,              \
                                               const ImplicitOptions&, BodyMotion&, const OnLoadStep&); \
  template StaticResult<d> find_equilibrium<d>(const Solid<d>&, const Actions<d>&, double,              \
                                               const ImplicitOptions&, State<d>&, const OnLoadStep&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
