#include "lib/scene/loaded_body.hpp"

#include <fmt/format.h>

#include "lib/core/error.hpp"
#include "lib/scene/actions_of_scene.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/element/element.hpp"

namespace plumb {
namespace {

/// Displacements and velocities of all particles, in their order.
template <int d>
BodyMotion motion_of_saved(const SavedState& saved, Index particles) {
  const auto read = [&](const char* name) {
    const SavedField* field = field_named(saved.fields, name);
    if (!field || field->values.size() != static_cast<std::size_t>(d * particles))
      throw InputError(fmt::format("the checkpoint has no {} of {} particles", name, particles),
                       "it is of another scene", "name the checkpoint that this scene's run has written");
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(field->values.data(), static_cast<Index>(field->values.size())));
  };
  return {read("displacement"), read("velocity"), saved.now.time, saved.now.step};
}

/// Loads of a search for equilibrium grow with the time; those of a motion are there from the beginning.
PathPoint reached(const Scene& scene, double time) {
  const bool grows = solved_by_newton(scene.method) && !scene.method.implicit.moves() && scene.end_time;
  return {time, grows ? time / *scene.end_time : 1};
}

}  // namespace

template <int d>
LoadedBody<d> loaded_body(const Scene& scene, const SavedState& saved) {
  if (scene.method.scheme == "mixed")
    throw InputError("a loaded state of scheme = \"mixed\"",
                     "its deformation gradients are unknowns of their own",
                     "use scheme = \"tlsph\", \"implicit\" or \"element\"");
  LoadedBody<d> body;
  body.at = reached(scene, saved.now.time);
  if (scene.method.scheme == "element") {
    Cloud<d> cloud = make_cloud<d>(scene.body);
    const auto facets = [&] { return surface_of<d>(scene.body, cloud).facets; };
    Actions<d> actions = actions_of_scene<d>(cloud, scene, facets, time_scale_of(scene));
    const Element<d> elements({std::move(cloud), scene.material.law(), scene.material.elastic()},
                              scene.method.element, std::move(actions));
    body.energy = elements.stored_energy();
    body.actions = elements.actions();
  } else {
    const auto simulation = std::make_shared<const TlsphBody<d>>(make_tlsph<d>(scene));
    body.energy = stored_energy<d>(std::shared_ptr<const Solid<d>>(simulation, &simulation->solid));
    body.actions = simulation->actions;
  }
  body.motion = motion_of_saved<d>(saved, body.energy.cloud.size());
  return body;
}

template LoadedBody<1> loaded_body<1>(const Scene&, const SavedState&);
template LoadedBody<2> loaded_body<2>(const Scene&, const SavedState&);
template LoadedBody<3> loaded_body<3>(const Scene&, const SavedState&);

}  // namespace plumb
