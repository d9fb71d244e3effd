#include "lib/scene/walls_of_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "lib/geometry/closed_surface.hpp"
#include "lib/input/stl.hpp"
#include "lib/scene/cloud_file.hpp"

namespace plumb {
namespace {

/// The number of the body of that name; nothing if none has it.
std::optional<int> body_number(const Scene& scene, const std::string& name) {
  if (scene.body.name == name) return 0;
  for (std::size_t n = 0; n < scene.others.size(); ++n)
    if (scene.others[n].name == name) return static_cast<int>(n) + 1;
  return std::nullopt;
}

/// Names of a body and of a wall or of another body.
void read_between(const Section& section, const Scene& scene, ContactOptions& contact) {
  if (!section.has("between")) return;
  const std::vector<std::string> names =
      section.texts({"between", "names of the body and of the wall, or of two bodies"});
  if (names.size() != 2)
    section.fail("between", fmt::format("{} names", names.size()),
                 "a contact is between a body and a wall, or two bodies",
                 "write between = [\"body\", \"wall\"]");
  contact.wall = names[1];
  if (scene.others.empty()) return;  // there is one body, whatever its name
  contact.body = names[0];
  contact.of_bodies = body_number(scene, contact.wall).has_value();
  if (!body_number(scene, contact.body))
    section.fail("between", fmt::format("there is no body \"{}\"", contact.body),
                 "the first name is that of a body", "give a [[body]] that name");
  if (contact.body == contact.wall)
    section.fail("between", fmt::format("body \"{}\" and itself", contact.body),
                 "particles of one body have the forces of its scheme", "name two bodies");
}

void read_plane(const Section& section, int dimension, ContactOptions& contact) {
  const auto count = static_cast<std::size_t>(dimension);
  contact.point = section.numbers({"point", "a point of the plane"}, count, quantity::length);
  contact.normal = section.numbers({"normal", "direction out of the wall"}, count, quantity::number);
  double square = 0;
  for (const double n : contact.normal) square += n * n;
  if (square == 0)
    section.fail("normal", "a vector of length 0", "it points out of the wall, to where the body is",
                 "write normal = [0, 1], for a floor");
  for (double& n : contact.normal) n /= std::sqrt(square);
}

void read_triangles(const Section& section, int dimension, ContactOptions& contact) {
  if (dimension != 3)
    section.fail("file", fmt::format("triangles in {} dimension{}", dimension, dimension == 1 ? "" : "s"),
                 "they are a surface in three dimensions", "give point and normal of a plane");
  for (const char* key : {"point", "normal"})
    if (section.has(key))
      section.fail(key, "contradicts file", "a wall is a plane or the surface in a file",
                   "leave one of them out");
  const std::string path = file_beside_scene(section);
  const double metre = metres_of_unit(section);
  for (const Triangle& triangle : parse_stl(read_text(path), path))
    for (const Vec<3>& corner : triangle)
      for (int k = 0; k < 3; ++k) contact.corners.push_back(metre * corner[k]);
  TriangleMesh mesh = mesh_of_corners(contact.corners);
  try {
    require_closed(mesh);
  } catch (const InputError& error) {
    section.fail("file", error.problem(), error.why(), error.suggestion());
  }
}

void read_motion(const Section& section, int dimension, ContactOptions& contact) {
  if (section.has("displacement"))
    for (const Expression& formula :
         section.formulas({"displacement", "motion of the wall, formulas of t"}, dimension, quantity::length,
                          Variables::space_and_time)) {
      // a rigid wall has one displacement at a time
      contact.displacement.push_back(formula);
      for (const double X : {1.0, -3.0})
        if (formula.at({X, X, X}, 0.3) != formula.at({0, 0, 0}, 0.3))
          section.fail("displacement", "it depends on the place", "a wall is rigid, and does not turn",
                       "write formulas of t");
    }
}

ContactOptions read_contact(const Section& section, const Scene& scene, const std::string& name) {
  ContactOptions contact;
  contact.wall = name;
  read_between(section, scene, contact);
  if (contact.of_bodies) {
    for (const char* key : {"file", "point", "normal", "displacement"})
      if (section.has(key))
        section.fail(key, fmt::format("\"{}\" is a body", contact.wall),
                     "only walls have a place of their own", "leave it out, or give the wall another name");
  } else {
    section.has("file") ? read_triangles(section, scene.dimension, contact)
                        : read_plane(section, scene.dimension, contact);
    read_motion(section, scene.dimension, contact);
  }
  contact.stiffness =
      section.optional_number({"stiffness", "E* of Hertz; E/(1 - nu^2) of the body where it is left out"},
                              quantity::stress, Sign::positive);
  contact.friction =
      section.number_or({"friction", "Coulomb's coefficient"}, 0, quantity::number, Sign::not_negative);
  section.reject_unknown();
  return contact;
}

void refuse_another(const Section& section, const ContactOptions& contact, const ContactOptions& other) {
  if (contact.of_bodies != other.of_bodies) return;
  if (!contact.of_bodies) {
    if (other.wall == contact.wall)
      section.fail("between", fmt::format("a second wall \"{}\"", contact.wall),
                   "results are listed by name");
    return;
  }
  if ((contact.body == other.body && contact.wall == other.wall) ||
      (contact.body == other.wall && contact.wall == other.body))
    section.fail("between", fmt::format("a second contact of \"{}\" and \"{}\"", contact.body, contact.wall),
                 "two bodies touch in one way", "leave one of them out");
  if (contact.stiffness != other.stiffness)
    section.fail("stiffness", "another one than of the contact before",
                 "all bodies have one material and one E*", "give both the same, or none");
}

double modulus_of(const ContactOptions& contact, const MaterialChoice& material) {
  return contact.stiffness.value_or(material.young / (1 - material.poisson * material.poisson));
}

/// What belongs to one body, in a scene of several.
void refuse_beside_bodies(const Section& root, const Scene& scene) {
  const Section first = root.sections("body").front();
  const auto node = [](const Body& body) { return body.layout != Layout::cell; };
  if (node(scene.body) || std::any_of(scene.others.begin(), scene.others.end(), node))
    first.fail("layout", "several bodies whose particles are on their surface",
               "bodies that touch would have particles at one place",
               "use layout = \"cell\" for all of them");
  for (const Boundary& boundary : scene.boundaries)
    if (boundary.face || is_load(boundary.kind)) {
      const Section section = root.sections("boundary").front();
      if (boundary.face)
        section.fail("face", "beside several bodies", "it is a face of the box around one body",
                     "use where = \"..\"");
      section.fail("kind", "a load on the surface beside several bodies", "their surface is not known",
                   "use [load]");
    }
  if (scene.initial && scene.initial->spin)
    root.section("initial").fail("spin", "beside several bodies", "it is about the centre of one body",
                                 "use velocity, with a formula of X for each of them");
}

template <int d>
std::function<BesideSurface<d>(const Vec<d>&)> wall_surface(const ContactOptions& contact) {
  if constexpr (d == 3)
    if (!contact.corners.empty()) {
      TriangleMesh mesh = mesh_of_corners(contact.corners);
      require_closed(mesh);
      return [surface = std::make_shared<const ClosedSurface>(std::move(mesh))](const Vec<3>& x) {
        return surface->beside(x);
      };
    }
  return half_space<d>(Eigen::Map<const Vec<d>>(contact.point.data()),
                       Eigen::Map<const Vec<d>>(contact.normal.data()));
}

}  // namespace

std::vector<ContactOptions> read_contacts(const Section& root, const Scene& scene) {
  std::vector<ContactOptions> contacts;
  for (const Section& section : root.sections(
           {"contact",
            "rigid walls (planes or closed surfaces of triangles) and pairs of bodies, one section each"})) {
    const std::string name = contacts.empty() ? "wall" : fmt::format("wall {}", contacts.size() + 1);
    ContactOptions contact = read_contact(section, scene, name);
    for (const ContactOptions& other : contacts) refuse_another(section, contact, other);
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

void refuse_walls(const Section& root, const Scene& scene) {
  if (scene.contacts.empty() && scene.others.empty()) return;
  const Section section = root.sections(scene.contacts.empty() ? "body" : "contact").front();
  const std::string& scheme = scene.method.scheme;
  if (scheme == "mixed" && scene.others.empty()) {
    for (const ContactOptions& contact : scene.contacts)
      if (contact.friction > 0)
        section.fail("friction", "contradicts scheme = \"mixed\"", "its stages have no history of slip",
                     "leave it out, or use scheme = \"updated\" or \"eulerian\"");
    return;
  }
  if (scheme != "updated" && scheme != "eulerian")
    section.fail("", fmt::format("contradicts scheme = \"{}\"", scheme), "that scheme has no contact",
                 scene.others.empty() ? "use scheme = \"updated\" or \"eulerian\", or [[boundary]]"
                                      : "use scheme = \"updated\" or \"eulerian\", or one [body]");
  if (scheme == "updated" && !scene.method.updated.conservative())
    section.fail("", "contradicts balance = \"printed\"", "its geometry may be that of steps before",
                 "use [updated] balance = \"conservative\"");
  if (!scene.others.empty()) refuse_beside_bodies(root, scene);
}

TouchOptions touch_of_scene(const Scene& scene) {
  TouchOptions touch;
  const std::size_t bodies = scene.others.size() + 1;
  for (const ContactOptions& contact : scene.contacts) {
    if (!contact.of_bodies) continue;
    touch.modulus = contact.stiffness;
    if (contact.friction == 0) continue;
    touch.friction.resize(bodies * bodies, 0.0);
    const auto a = static_cast<std::size_t>(body_number(scene, contact.body).value()),
               b = static_cast<std::size_t>(body_number(scene, contact.wall).value());
    touch.friction[a * bodies + b] = touch.friction[b * bodies + a] = contact.friction;
  }
  return touch;
}

Statement bodies_of(const Scene& scene) {
  std::string names = scene.body.name;
  for (const Body& body : scene.others) names += ", " + body.name;
  return {
      "bodies",
      fmt::format("{} ({}): their sums do not see each other; where they touch a penalty presses them apart",
                  scene.others.size() + 1, names),
      "THEORY (19.3)-(19.5)"};
}

Statement said_of(const ContactOptions& contact, const MaterialChoice& material) {
  const std::string friction =
      contact.friction > 0 ? fmt::format("friction {:g}", contact.friction) : "no friction";
  if (contact.of_bodies)
    return {"contact",
            fmt::format("\"{}\" and \"{}\": penalty with E* = {:.6g} Pa, {}", contact.body, contact.wall,
                        modulus_of(contact, material), friction),
            "THEORY (19.3)-(19.6)"};
  return {
      "contact",
      fmt::format(
          "\"{}\", {}{}: Hertz with E* = {:.6g} Pa, {}", contact.wall,
          contact.corners.empty() ? "a half-space" : fmt::format("{} triangles", contact.corners.size() / 9),
          contact.displacement.empty() ? "" : " that moves", modulus_of(contact, material), friction),
      "THEORY (19.1), (19.2)"};
}

template <int d>
std::vector<RigidWall<d>> walls_of_scene(const Scene& scene, double spacing) {
  std::vector<RigidWall<d>> walls;
  for (const ContactOptions& contact : scene.contacts) {
    if (contact.of_bodies) continue;
    RigidWall<d> wall;
    if (!contact.body.empty()) wall.body = body_number(scene, contact.body).value();
    wall.name = contact.wall;
    wall.beside = wall_surface<d>(contact);
    if (!contact.displacement.empty())
      wall.displacement = [formulas = contact.displacement](double time) {
        Vec<d> moved;
        for (int k = 0; k < d; ++k) moved[k] = formulas[static_cast<std::size_t>(k)].at({0, 0, 0}, time);
        return moved;
      };
    wall.modulus = modulus_of(contact, scene.material);
    wall.friction = contact.friction;
    wall.reach = scene.body.layout == Layout::node ? 0 : spacing / 2;
    walls.push_back(std::move(wall));
  }
  return walls;
}

template std::vector<RigidWall<1>> walls_of_scene<1>(const Scene&, double);
template std::vector<RigidWall<2>> walls_of_scene<2>(const Scene&, double);
template std::vector<RigidWall<3>> walls_of_scene<3>(const Scene&, double);

}  // namespace plumb
