#include "lib/scene/simulation.hpp"

#include "lib/scene/go_implicitly.hpp"
#include "lib/scene/scheme_simulation.hpp"

namespace plumb {
namespace {

/// A body of bonds whose equilibria are sought.
template <int d>
Simulation<d> implicit_as_simulation(const std::shared_ptr<TlsphBody<d>>& body, const Scene& scene) {
  Simulation<d> simulation = as_simulation<d>(body, scene.material);
  simulation.scheme = "implicit";
  const std::shared_ptr<State<d>> state(body, &body->state);
  go_implicitly(simulation,
                implicit_body<d>(
                    state, body->solid.bonds.slots,
                    [body] { return stored_energy<d>(std::shared_ptr<const Solid<d>>(body, &body->solid)); },
                    [body]() -> const Actions<d>& { return body->actions; }),
                scene);
  return simulation;
}

}  // namespace

template <int d>
BuiltScene<d> make_simulation(const Scene& scene) {
  if (has_own_body(scene.method.scheme)) return {make_scheme_simulation<d>(scene), nullptr};
  const auto body = std::make_shared<TlsphBody<d>>(make_tlsph<d>(scene));
  if (scene.method.scheme == "implicit") return {implicit_as_simulation<d>(body, scene), body};
  return {as_simulation<d>(body, scene.material), body};
}

template BuiltScene<1> make_simulation<1>(const Scene&);
template BuiltScene<2> make_simulation<2>(const Scene&);
template BuiltScene<3> make_simulation<3>(const Scene&);

}  // namespace plumb
