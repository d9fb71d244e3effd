#include <fmt/format.h>

#include "lib/scene/readers.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/unused_keys.hpp"

namespace plumb {
namespace {

/// The length of steps may stand in [method], where that of explicit steps is, or in [implicit]. A motion has no number of steps that
/// would do for every scene.
void take_step(const Section& root, Method& method) {
  const auto section = root.optional_section({"implicit", "how Newton's method goes"});
  const bool given = section && (section->has("steps") || section->has("time_step"));
  if (method.time_step && given)
    root.section("method").fail("time_step", "contradicts the steps of [implicit]",
                                "both say how long a step is", "leave one of them out");
  if (method.time_step) method.implicit.time_step = method.time_step;
  if (method.implicit.moves() && !given && !method.time_step)
    section->fail("dynamics", "steps of unknown length", "nothing limits an implicit step but its error",
                  "add time_step = \"1 ms\", some twentieth of the shortest period that matters");
}

}  // namespace

void refuse_misprints(const Section& root, const MaterialChoice& material, const Method& method) {
  const ImplicitOptions& chosen = method.implicit;
  const auto refuse = [&](const char* problem, const char* why, const char* suggestion) {
    root.section("implicit").fail("misprints", problem, why, suggestion);
  };
  if (chosen.misprints.empty()) return;
  if (method.scheme == "element")
    refuse("contradicts scheme = \"element\"", "they are those of paper 004",
           "use scheme = \"implicit\", or leave it out");
  const bool of_paper = method.hourglass && method.hourglass->weight == "slope";
  if (!of_paper && (chosen.misprinted("27") || chosen.misprinted("29")))
    refuse("(27) and (29) without their hourglass energy", "they are the forces and the stiffness of (21)",
           "add [hourglass] weight = \"slope\", or paper = \"004\"");
  const bool of_law = material.model == "neo-hookean-logarithmic" && material.plane == Plane::strain;
  if (!of_law && chosen.misprinted("61"))
    refuse("(61) of another law",
           "it is the tangent of neo-hookean-logarithmic, in the plane of plane strain",
           "use model = \"neo-hookean-logarithmic\", or leave it out");
}

void read_scheme(const Section& root, Method& method) {
  if (const auto section = root.optional_section({"element", "finite elements on the nodes of a box"});
      section && method.scheme == "element")
    method.element = ElementOptions::read(*section);
  const bool by_newton = method.scheme == "element" && method.element.by_newton();
  if (method.scheme == "element" && !by_newton && root.has("implicit"))
    root.section("implicit")
        .fail("", fmt::format("contradicts solve = \"{}\"", method.element.solve),
              "it says how Newton's method goes", "use [element] solve = \"newton\", or leave it out");
  for (const char* name : {"mixed", "implicit", "updated", "eulerian", "element"})
    if (root.has(name) && method.scheme != name && !(by_newton && std::string_view(name) == "implicit"))
      root.section(name).fail("", fmt::format("contradicts scheme = \"{}\"", method.scheme),
                              fmt::format("it belongs to scheme = \"{}\"", name), "leave one of them out");
  for (const char* name : {"viscosity", "artificial_stress"})
    if (root.has(name) && method.scheme != "eulerian")
      root.section(name).fail("", fmt::format("contradicts scheme = \"{}\"", method.scheme),
                              "it belongs to scheme = \"eulerian\"", "leave one of them out");
  if (const auto section = root.optional_section({"mixed", "the mixed scheme, paper 003"})) {
    method.mixed = MixedOptions::read(*section, method.mixed);
    section->reject_unknown();
  }
  if (const auto section = root.optional_section(
          {"implicit", "how equilibria are sought, or steps in time are made, by Newton's method"}))
    method.implicit = ImplicitOptions::read(*section);
  if (solved_by_newton(method)) {
    take_step(root, method);
    method.unused = unused_by_scheme(root, method.scheme, keys_unused_by_newton());
  }
  if (const auto section = root.optional_section({"updated", "the updated Lagrangian scheme, paper 002"})) {
    method.updated = UpdatedOptions::read(*section, method.updated);
    section->reject_unknown();
  }
  if (const auto section =
          root.optional_section({"eulerian", "the scheme with Eulerian kernels, paper 001"})) {
    method.eulerian = EulerianOptions::read(*section, method.eulerian);
    section->reject_unknown();
  }
  if (method.scheme == "eulerian") read_sections_beside(root, method.eulerian);
  if (method.cfl)
    method.mixed.cfl = method.updated.cfl = method.eulerian.cfl = method.element.cfl = *method.cfl;
  if (!has_own_body(method.scheme)) return;
  method.mixed.projects = method.scheme == "mixed" && root.has("projection");
  if (method.mixed.projects && method.mixed.smooth_positions)
    root.section("projection")
        .fail("", "contradicts [mixed] smooth_positions = true",
              "angular momentum is kept about points that move with the velocity, and smoothed ones do not",
              "leave one of them out");
  if (by_newton && root.has("damping"))
    root.section("damping").fail("", "contradicts solve = \"newton\"",
                                 "Newton's method looks for equilibria, or keeps the energy of a motion",
                                 "use [element] solve = \"explicit\", or leave it out");
  if (method.scheme == "mixed" && root.has("dissipation"))
    root.section("dissipation")
        .fail("", "contradicts scheme = \"mixed\"", "its pairs dissipate as [mixed] upwind says",
              "leave it out, or set [mixed] upwind = \"adjoint\"");
  for (const char* name : {"jst", "dissipation", "hourglass", "projection", "compatible"})
    if (root.has(name) && !(method.mixed.projects && std::string_view(name) == "projection"))
      root.section(name).fail("", fmt::format("contradicts scheme = \"{}\"", method.scheme),
                              "it is a part of scheme = \"tlsph\"", "leave one of them out");
}

}  // namespace plumb
