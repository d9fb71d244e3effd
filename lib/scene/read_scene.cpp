#include "lib/scene/read_scene.hpp"
#include "lib/material/rate_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "lib/scene/readers.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/walls_of_scene.hpp"

namespace plumb {
namespace {

void refuse_pointless_mirror(const Section& root, const Scene& scene) {
  const bool rolls = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                 [](const auto& b) { return b.kind == BoundaryKind::roller; });
  if (scene.body.layout == Layout::mirror && !rolls)
    (root.is_array("body") ? root.sections("body").front() : root.section("body"))
        .fail("layout", "mirror without a roller",
              "ghosts stand behind rollers: "
              "there is nothing to mirror",
              "use cell");
}

/// An interval so short that there is no end of rows can only be a slip of units.
void refuse_endless_output(const Section& root, const Scene& scene) {
  if (!scene.output || !scene.end_time) return;
  constexpr double most_rows = 1e9;
  for (const auto& [key, interval] :
       {std::pair("every", scene.output->every), {"checkpoint", scene.output->checkpoint}})
    if (interval && *scene.end_time / *interval > most_rows)
      root.section("output").fail(key,
                                  fmt::format("{:.3g} intervals until end_time", *scene.end_time / *interval),
                                  fmt::format("at most {:.0g}", most_rows), "check the units");
}

/// [body], or [[body]] with names of their own.
void read_bodies(const Section& root, Scene& scene) {
  const char* what =
      "particles that fill a shape, or those of a file; several bodies: [[body]], one section each";
  if (!root.is_array({"body", what})) {
    scene.body = read_body(root.section({"body", what}), scene.dimension, true);
    return;
  }
  const std::vector<Section> sections = root.sections({"body", what});
  std::set<std::string> names;
  for (const Section& section : sections) {
    Body body = read_body(section, scene.dimension, true);
    if (sections.size() > 1 && !section.has("name"))
      section.fail("name", "missing key", "there are several bodies", "add name = \"..\"");
    if (!names.insert(body.name).second)
      section.fail("name", fmt::format("a second body \"{}\"", body.name), "results are listed by name",
                   "give it another name");
    names.size() == 1 ? scene.body = std::move(body) : scene.others.emplace_back(std::move(body));
  }
}

/// The account of what changed momenta and energy is kept of explicit steps.
void refuse_budget_of_another(const Section& root, const Scene& scene) {
  if (!scene.output || !scene.output->budget) return;
  const Method& method = scene.method;
  if (solved_by_newton(method))
    root.section("output").fail("budget", fmt::format("contradicts scheme = \"{}\"", method.scheme),
                                "an account is kept of explicit steps only",
                                "leave it out, or use a scheme that steps explicitly");
}

/// A temperature of a law that has none, or two of one that has it.
void refuse_temperature(const Section& root, const Scene& scene) {
  if (!scene.initial || !scene.initial->temperature) return;
  const Section section = root.section("initial");
  if (!has_temperature(scene.material.model))
    section.fail("temperature", fmt::format("contradicts model = \"{}\"", scene.material.model),
                 "its stress does not depend on a temperature",
                 "leave it out, or use model = \"johnson-cook\"");
  if (scene.material.parameters.contains("temperature"))
    section.fail("temperature", "contradicts temperature of [material]", "both say what the body starts with",
                 "leave out one of them");
}

/// Conjugate gradients need a symmetric tangent.
void refuse_following_pressure(const Section& root, const Scene& scene) {
  if (scene.method.implicit.solver != LinearSolver::iterative) return;
  for (const Boundary& boundary : scene.boundaries)
    if (boundary.kind == BoundaryKind::pressure)
      root.section("implicit")
          .fail("solver", "\"iterative\" beside a pressure that follows",
                "its tangent is not symmetric, and conjugate gradients need that",
                "use solver = \"direct\", or a traction in place of the pressure");
}

/// What has no rest, or none that a run in time finds.
void refuse_restless(const Section& root, const Scene& scene) {
  const Section section = root.section("relaxation");
  const Method& method = scene.method;
  if (solved_by_newton(method))
    section.fail("",
                 fmt::format("contradicts {}",
                             method.scheme == "element" ? "solve = \"newton\"" : "scheme = \"implicit\""),
                 "it looks for equilibria by itself, without time",
                 "leave it out, or use a scheme that steps in time");
  if (method.scheme == "updated" && !method.updated.conservative())
    section.fail("", "contradicts balance = \"printed\"",
                 "its forces belong to the middle of a step, and none are known of a body at rest",
                 "use [updated] balance = \"conservative\"");
  if (scene.boundaries.empty() && scene.contacts.empty() && !scene.load)
    section.fail("", "nothing holds or loads the body", "the residual is relative to those forces",
                 "add [[boundary]] or [load]");
  if (scene.output && scene.output->budget)
    root.section("output").fail("budget", "contradicts [relaxation]",
                                "a relaxation takes kinetic energy away, which no force does",
                                "leave one of them out");
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file_name,
                  const std::vector<std::string>& overrides) {
  return scene_of(parse_document(text, file_name, overrides, scene_alternatives()), file_name);
}

Scene scene_of(const TomlValue& document, const std::string& file_name, KeyNotes* notes) {
  const Section root(document, "", notes);
  root.mark_known(
      {"scene", "body", "material", "load", "initial", "boundary", "contact", "relaxation", "output"});
  root.mark_known(method_sections());
  if (!document.find("scene") && document.find("study"))
    root.fail("study", "this file is a study", "a scene has [scene]", "use plumb mms for studies");
  root.reject_unknown();
  Scene scene;
  const Section head = root.section({"scene", "what is computed, and for how long"});
  scene.name = head.text_or({"name", "what results call it; the file's name where it is left out"},
                            std::filesystem::path(file_name).stem().string());
  scene.dimension = static_cast<int>(
      std::min(head.integer({"dimension", "1 (uniaxial strain), 2 (plane strain or stress) or 3"}, 0), 9L));
  if (scene.dimension < 1 || scene.dimension > 3)
    head.fail("dimension", std::to_string(scene.dimension) + " is not possible",
              "bodies have 1 (uniaxial strain), 2 (plane strain) or 3", "write 1, 2 or 3");
  scene.end_time = head.optional_number({"end_time", "end of the run"}, quantity::time, Sign::positive);
  scene.max_steps = head.optional_integer({"max_steps", "most steps of the run"}, 1);
  head.reject_unknown();
  if (!scene.end_time && !scene.max_steps)
    head.fail("end_time", "missing key", "neither end_time nor max_steps says when to stop",
              "add end_time = \"0.1 s\" or max_steps = 100");
  read_bodies(root, scene);
  scene.material = read_material(root.section({"material", "the law and its numbers"}), scene.dimension);
  scene.method = read_method(root, scene.body);
  refuse_history(root, scene.material, scene.method);
  refuse_misprints(root, scene.material, scene.method);
  refuse_on_a_line(root, scene.dimension, scene.method);
  scene.load = read_load(root, scene.dimension);
  scene.initial = read_initial(root, scene.dimension);
  refuse_temperature(root, scene);
  scene.boundaries = read_boundaries(root, scene.dimension);
  scene.contacts = read_contacts(root, scene);
  refuse_following_pressure(root, scene);
  scene.relaxation = read_relaxation(root);
  scene.exact = read_exact(root, scene.dimension);
  scene.output = read_output(root, scene);
  if (scene.relaxation) refuse_restless(root, scene);
  refuse_endless_output(root, scene);
  refuse_walls(root, scene);
  refuse_budget_of_another(root, scene);
  refuse_beside_mirror(root, scene.body.layout, scene.method);
  refuse_pointless_mirror(root, scene);
  return scene;
}

std::map<std::string, std::string> scene_settings(const std::string& path,
                                                  const std::vector<std::string>& overrides) {
  return settings_of(parse_document(read_text(path), path, overrides, scene_alternatives()));
}

Scene read_scene(const std::string& path, const std::vector<std::string>& overrides) {
  return parse_scene(read_text(path), path, overrides);
}

}  // namespace plumb
