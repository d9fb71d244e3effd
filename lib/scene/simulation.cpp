#include "plumbline/scene/simulation.hpp"

#include "plumbline/scene/implicit_as_simulation.hpp"
#include "plumbline/scene/scheme_simulation.hpp"

namespace plumb {

template <int d>
BuiltScene<d> make_simulation(const Scene& scene) {
  if (has_own_body(scene.method.scheme)) return {make_scheme_simulation<d>(scene), nullptr};
  const auto body = std::make_shared<TlsphSimulation<d>>(make_tlsph<d>(scene));
  if (scene.method.scheme == "implicit") return {implicit_as_simulation<d>(body, scene), body};
  return {as_simulation<d>(body, scene.material), body};
}

template BuiltScene<2> make_simulation<2>(const Scene&);
template BuiltScene<3> make_simulation<3>(const Scene&);

}  // namespace plumb
