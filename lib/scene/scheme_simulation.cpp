#include "lib/scene/scheme_simulation.hpp"

#include "lib/actions/does_work.hpp"
#include "lib/run/any_scheme.hpp"
#include "lib/scene/actions_of_scene.hpp"
#include "lib/scene/go_implicitly.hpp"
#include "lib/scene/initial_motion.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/scene/walls_of_scene.hpp"
#include "lib/schemes/element/element.hpp"
#include "lib/schemes/eulerian/eulerian.hpp"
#include "lib/schemes/mixed/mixed.hpp"
#include "lib/schemes/updated/updated.hpp"

namespace plumb {
namespace {

double damping_of(const Scene& scene) {
  return scene.method.damping ? scene.method.damping->rate : 0;
}

/// Elements by Verlet, or as [implicit] says.
template <int d>
Simulation<d> element_simulation(Specimen<d> specimen, const Scene& scene, SchemeStart<d> start) {
  Element<d> scheme(std::move(specimen), scene.method.element, std::move(start.actions), damping_of(scene));
  const Slots slots = scheme.layout();
  auto state = scheme.start(start.motion);
  const auto moving =
      std::make_shared<Moving<Element<d>>>(Moving<Element<d>>{std::move(scheme), std::move(state), {}});
  Simulation<d> simulation = as_simulation<d>(moving, step_control(scene));
  if (scene.method.element.by_newton())
    go_implicitly(simulation,
                  implicit_body<d>(
                      std::shared_ptr<ElementState>(moving, &moving->state), slots,
                      [moving] { return moving->scheme.stored_energy(); },
                      [moving]() -> const Actions<d>& { return moving->scheme.actions(); }),
                  scene);
  return simulation;
}

template <int d>
Simulation<d> simulation_of(const Scene& scene, SchemeStart<d> start) {
  const StepControl control = step_control(scene);
  Specimen<d> specimen{std::move(start.cloud), scene.material.law(), scene.material.elastic()};
  const std::string& name = scene.method.scheme;
  if ((name == Updated<d>::name || name == Eulerian<d>::name) && scene.body.layout == Layout::mirror)
    throw InputError("layout = \"mirror\" contradicts scheme = \"" + name + "\"",
                     "its sums have no images behind a roller", "use layout = \"node\" or \"cell\"");
  if (name == Updated<d>::name)
    return as_simulation<d>(Updated<d>(std::move(specimen), scene.method.updated, start.actions,
                                       damping_of(scene), std::move(start.walls), start.touch),
                            start.motion, control);
  if (name == Eulerian<d>::name)
    return as_simulation<d>(Eulerian<d>(std::move(specimen), scene.method.eulerian, start.actions,
                                        damping_of(scene), std::move(start.walls), start.touch),
                            start.motion, control);
  if (scene.method.scheme == "element")
    return element_simulation<d>(std::move(specimen), scene, std::move(start));
  std::optional<Surface<d>> surface;
  if (scene.method.mixed.gradient == "compatible") surface = surface_of<d>(scene.body, specimen.cloud);
  return as_simulation<d>(Mixed<d>(std::move(specimen), scene.method.mixed, start.actions, damping_of(scene),
                                   std::move(start.walls), surface),
                          start.motion, control);
}

}  // namespace

bool has_own_body(const std::string& scheme) {
  return scheme == "mixed" || scheme == "updated" || scheme == "eulerian" || scheme == "element";
}

bool solved_by_newton(const Method& method) {
  return method.scheme == "implicit" || (method.scheme == "element" && method.element.by_newton());
}

template <int d>
Simulation<d> make_scheme_simulation(const Scene& scene, SchemeStart<d> start) {
  const bool works = does_work(start.actions);
  const double spacing = start.cloud.spacing;
  Simulation<d> simulation = simulation_of(scene, std::move(start));
  simulation.spacing = spacing;
  if (!simulation.external_work && works) simulation.has_other_work = true;
  std::vector<Statement> more;
  if (scene.method.damping) more.push_back({"damping", scene.method.damping->in_words(), "THEORY (6.7)"});
  if (!scene.others.empty()) more.push_back(bodies_of(scene));
  for (const ContactOptions& contact : scene.contacts) more.push_back(said_of(contact, scene.material));
  if (!more.empty())
    simulation.account = [account = simulation.account, more] {
      auto all = account();
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
  return simulation;
}

template <int d>
Simulation<d> make_scheme_simulation(const Scene& scene) {
  SchemeStart<d> start{make_cloud<d>(scene), {}, {}};
  const auto facets = [&] { return surface_of<d>(scene.body, start.cloud).facets; };
  const double time_scale = time_scale_of(scene);
  start.actions = actions_of_scene<d>(start.cloud, scene, facets, time_scale);
  refuse_contradictions<d>(start.cloud, start.actions, time_scale);
  start.motion = initial_motion<d>(scene, start.cloud);
  start.walls = walls_of_scene<d>(scene, start.cloud.spacing);
  start.touch = touch_of_scene(scene);
  return make_scheme_simulation<d>(scene, std::move(start));
}

template Simulation<1> make_scheme_simulation<1>(const Scene&, SchemeStart<1>);
template Simulation<2> make_scheme_simulation<2>(const Scene&, SchemeStart<2>);
template Simulation<3> make_scheme_simulation<3>(const Scene&, SchemeStart<3>);
template Simulation<1> make_scheme_simulation<1>(const Scene&);
template Simulation<2> make_scheme_simulation<2>(const Scene&);
template Simulation<3> make_scheme_simulation<3>(const Scene&);

}  // namespace plumb
