#include <fmt/format.h>

#include <algorithm>

#include "lib/material/johnson_cook.hpp"
#include "lib/run/output_fields.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/readers.hpp"
#include "lib/scene/tlsph.hpp"

namespace plumb {
namespace {

std::array<double, 3> read_spin(const Section& section, int dimension) {
  if (dimension == 1)
    section.fail("spin", "in one dimension", "a bar moves along its line and does not turn", "give velocity");
  if (dimension == 2 && !section.is_array("spin"))
    return {0.0, 0.0,
            section.number({"spin", "angular velocity about the centre of mass; about z in 2D"},
                           quantity::angular_velocity)};
  const auto spin = section.numbers("spin", 3, quantity::angular_velocity);
  if (dimension == 2 && (spin[0] != 0.0 || spin[1] != 0.0))
    section.fail("spin", "leaves the plane", "in 2D a body turns about z only", "write [0, 0, w]");
  return {spin[0], spin[1], spin[2]};
}

Face read_face(const Section& section, int dimension) {
  const std::string name = section.choice_or({"face", "the face of the body's box where the boundary is"}, "",
                                             face_names(dimension));
  return {name[0] - 'x', name[1] == '-' ? -1 : +1};
}

/// The key that bears the name of the kind, and the ramp.
void read_what_is_prescribed(const Section& section, int dimension, const std::string& kind,
                             Boundary& boundary) {
  const auto formulas = [&](const Key& key, const Quantity& quantity) {
    return section.formulas(key, dimension, quantity, Variables::space_and_time);
  };
  for (const char* key : {"velocity", "displacement", "traction", "pressure"})
    if (section.has(key) && kind != key)
      section.fail(key, fmt::format("contradicts kind = \"{}\"", kind),
                   fmt::format("only kind = \"{}\" has one", key), "leave it out or change the kind");
  if (boundary.kind == BoundaryKind::velocity)
    boundary.velocity = formulas({"velocity", "formulas of X, Y, Z, t"}, quantity::velocity);
  if (boundary.kind == BoundaryKind::displacement)
    boundary.displacement = formulas({"displacement", "formulas of X, Y, Z, t"}, quantity::length);
  if (boundary.kind == BoundaryKind::traction)
    boundary.traction =
        formulas({"traction", "force per reference area, keeps its direction; formulas of X, Y, Z, t"},
                 quantity::stress);
  if (boundary.kind == BoundaryKind::pressure)
    boundary.pressure =
        section.formula({"pressure", "into the body, follows the surface; formula of X, Y, Z, t"}, dimension,
                        quantity::stress, Variables::space_and_time);
  boundary.ramp = section.optional_number({"ramp", "what is prescribed grows smoothly from 0 in this time"},
                                          quantity::time, Sign::positive);
  if (boundary.ramp && (kind == "clamped" || kind == "roller"))
    section.fail("ramp", fmt::format("contradicts kind = \"{}\"", kind),
                 "nothing is prescribed that could grow", "leave it out");
}

Boundary read_boundary(const Section& section, int dimension) {
  Boundary boundary;
  const bool on_face = section.has("face");
  const bool by_formula = section.has("where");
  if (on_face && by_formula)
    section.fail("where", "contradicts face", "a boundary is given by one of them", "write two boundaries");
  if (!on_face && !by_formula)
    section.fail("", "missing key face or where", "a boundary must say where it is",
                 fmt::format("add face = \"{}\"", face_names(dimension).front()));
  if (on_face) boundary.face = read_face(section, dimension);
  if (by_formula)
    boundary.where = section.formula(
        {"where", "condition on X, Y, Z that picks the particles of the boundary, such as \"Z < 0.1\""},
        dimension, quantity::number);
  if (!section.has("kind"))
    section.fail("kind", "missing key", "it has no default", "valid: " + join(boundary_kind_names()));
  const std::string kind = section.choice_or({"kind", "what is prescribed there"}, "", boundary_kind_names());
  boundary.kind = boundary_kind_named(kind);
  if (boundary.kind == BoundaryKind::roller && by_formula)
    section.fail("kind", "a roller needs a face", "a set of particles has no normal direction",
                 "use face instead of where");
  read_what_is_prescribed(section, dimension, kind, boundary);
  section.reject_unknown();
  return boundary;
}

/// A hole or a curve may leave no material there.
template <int d>
void require_material(const Section& section, const Body& body, const Probe& probe) {
  const double distance = shape_of<d>(body).distance(Eigen::Map<const Vec<d>>(probe.at.data()));
  const double longest = *std::max_element(body.size.begin(), body.size.end());
  if (distance > 1e-9 * longest)  // rounding of typed coordinates
    section.fail("at", fmt::format("there is no material at ({:.9g})", fmt::join(probe.at, ", ")),
                 fmt::format("the body is {:.4g} m away", distance), "move the probe into it");
}

/// Whose box has a point; of none the first body.
const Body& body_at(const Scene& scene, const std::vector<double>& at) {
  for (const Body& body : scene.others) {
    bool within = true;
    for (std::size_t k = 0; k < at.size(); ++k)
      within = within && at[k] >= body.origin[k] && at[k] <= body.origin[k] + body.size[k];
    if (within) return body;
  }
  return scene.body;
}

Probe read_probe(const Section& section, const Scene& scene) {
  Probe probe;
  probe.name = section.text({"name", "what results call it"});
  probe.at = section.numbers({"at", "reference point; the nearest particle is followed"},
                             scene.body.size.size(), quantity::length);
  const Body& body = body_at(scene, probe.at);
  for (std::size_t k = 0; k < body.size.size(); ++k) {
    const double from_origin = probe.at[k] - body.origin[k];
    const double margin = 1e-9 * body.size[k];  // rounding of typed coordinates
    if (from_origin < -margin || from_origin > body.size[k] + margin)
      section.fail(
          "at", fmt::format("{} = {} m is outside the body", "XYZ"[k], probe.at[k]),
          fmt::format("it reaches from {:.9g} to {:.9g} m", body.origin[k], body.origin[k] + body.size[k]));
  }
  if (probe.at.size() == 2) require_material<2>(section, body, probe);
  if (probe.at.size() == 3) require_material<3>(section, body, probe);
  section.reject_unknown();
  return probe;
}

/// Names of the catalogue, each once.
std::vector<std::string> read_fields(const Section& section) {
  std::vector<std::string> fields =
      section.texts({"fields", "fields of files beside displacement and velocity"}, output_field_names());
  const auto valid = output_field_names();
  for (auto at = fields.begin(); at != fields.end(); ++at) {
    if (std::find(valid.begin(), valid.end(), *at) == valid.end()) {
      const InputError error = unknown_name("field", *at, valid);
      section.fail("fields", error.problem(), error.why(), error.suggestion());
    }
    if (std::find(fields.begin(), at, *at) != at)
      section.fail("fields", fmt::format("\"{}\" stands there twice", *at), "it is shown once",
                   "leave one out");
  }
  return fields;
}

}  // namespace

std::optional<Initial> read_initial(const Section& root, int dimension) {
  const auto section = root.optional_section({"initial", "what the body starts with"});
  if (!section) return std::nullopt;
  Initial initial;
  const bool formulas = section->has("velocity");
  const bool spins = section->has("spin");
  const bool displaced = section->has("displacement");
  if (displaced)
    initial.displacement =
        section->formulas({"displacement", "formulas of X, Y, Z"}, dimension, quantity::length);
  if (formulas)
    initial.velocity = section->formulas({"velocity", "formulas of X, Y, Z"}, dimension, quantity::velocity);
  if (spins) initial.spin = read_spin(*section, dimension);
  const bool warm = section->has("temperature");
  if (warm)
    initial.temperature =
        section->formula({"temperature", "formula of X, Y, Z, for a law that has a temperature"}, dimension,
                         JohnsonCook::kelvin);
  if (formulas && spins)
    section->fail("spin", "contradicts velocity", "the initial velocity is given by one of them",
                  "add the spin to the formulas");
  section->reject_unknown();
  if (!formulas && !spins && !displaced && !warm)
    section->fail("", "missing key velocity, spin, displacement or temperature",
                  "the section is there but sets nothing", "leave out [initial] for a body at rest");
  return initial;
}

std::vector<Boundary> read_boundaries(const Section& root, int dimension) {
  std::vector<Boundary> boundaries;
  for (const auto& section : root.sections({"boundary", "what is held or loaded, one section each"})) {
    const Boundary boundary = read_boundary(section, dimension);
    const bool taken =
        boundary.face && std::any_of(boundaries.begin(), boundaries.end(), [&](const auto& other) {
          return other.face == boundary.face && is_load(other.kind) == is_load(boundary.kind);
        });
    if (taken)
      section.fail("face", "a second boundary on this face",
                   "a face may be held in one way and loaded in one way", "leave one of them out");
    boundaries.push_back(boundary);
  }
  return boundaries;
}

std::vector<Expression> read_exact(const Section& root, int dimension) {
  const auto section = root.optional_section("output");
  if (!section || !section->has("exact")) return {};
  return section->formulas({"exact", "displacement that the answer is compared with"}, dimension,
                           quantity::length, Variables::space_and_time);
}

std::optional<Output> read_output(const Section& root, const Scene& scene) {
  const auto section = root.optional_section({"output", "what is written; without it the summary only"});
  if (!section) return std::nullopt;
  Output output;
  output.every = section->optional_number(
      {"every", "time from one row and frame to the next; without it the first and the last state"},
      quantity::time, Sign::positive);
  output.checkpoint = section->optional_number(
      {"checkpoint", "time between files from which a run can go on"}, quantity::time, Sign::positive);
  output.vtk = section->flag_or({"vtk", "particles as .vtp files with a .pvd"}, output.vtk);
  output.series =
      section->flag_or({"series", "energies, momenta and probes against time as CSV"}, output.series);
  section->has("exact");  // known: read_exact() has it
  output.budget = section->flag_or(
      {"budget", "momenta and energy by the cause that changed them, every step, as CSV"}, output.budget);
  if (section->has("fields")) output.fields = read_fields(*section);
  for (const auto& part : section->sections({"probe", "particles that are followed, one section each"})) {
    const Probe probe = read_probe(part, scene);
    for (const auto& other : output.probes)
      if (other.name == probe.name)
        part.fail("name", fmt::format("a second probe \"{}\"", probe.name), "results are listed by name");
    output.probes.push_back(probe);
  }
  section->reject_unknown();
  return output;
}

}  // namespace plumb
