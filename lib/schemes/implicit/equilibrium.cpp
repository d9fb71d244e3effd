#include "plumbline/schemes/implicit/equilibrium.hpp"

namespace plumb {

template <int d>
StaticResult<d> find_equilibrium(const Solid<d>& solid, const Actions<d>& actions, double end_time,
                                 const ImplicitOptions& options, State<d>& state,
                                 const OnLoadStep<d>& on_step) {
  StaticResult<d> result;
  LoadPath<d> path(solid, actions, end_time, options, state);
  result.failure = path.go_to(end_time, state, [&](const State<d>& now, const LoadStep& step) {
    result.steps.push_back(step);
    if (on_step) on_step(now, step);
  });
  result.rejected = path.rejected();
  result.reactions = path.reactions(state);
  return result;
}

#define PLUMBLINE_INSTANTIATE(d)                                                           \
  template StaticResult<d> find_equilibrium<d>(const Solid<d>&, const Actions<d>&, double, \
                                               const ImplicitOptions&, State<d>&, const OnLoadStep<d>&);
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
