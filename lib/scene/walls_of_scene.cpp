#include "lib/scene/walls_of_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lib/geometry/closed_surface.hpp"
#include "lib/input/stl.hpp"
#include "lib/scene/cloud_file.hpp"

namespace plumb {
namespace {

/// The wall's name: the second of `between`.
std::string read_between(const Section& section, const std::string& otherwise) {
  if (!section.has("between")) return otherwise;
  const std::vector<std::string> names = section.texts({"between", "names of the body and of the wall"});
  if (names.size() != 2)
    section.fail("between", fmt::format("{} names", names.size()), "a contact is between a body and a wall",
                 "write between = [\"body\", \"wall\"]");
  return names[1];
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

ContactOptions read_contact(const Section& section, int dimension, const std::string& name) {
  ContactOptions contact;
  contact.wall = read_between(section, name);
  section.has("file") ? read_triangles(section, dimension, contact) : read_plane(section, dimension, contact);
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
  contact.stiffness =
      section.optional_number({"stiffness", "E* of Hertz; E/(1 - nu^2) of the body where it is left out"},
                              quantity::stress, Sign::positive);
  contact.friction =
      section.number_or({"friction", "Coulomb's coefficient"}, 0, quantity::number, Sign::not_negative);
  section.reject_unknown();
  return contact;
}

double modulus_of(const ContactOptions& contact, const MaterialChoice& material) {
  return contact.stiffness.value_or(material.young / (1 - material.poisson * material.poisson));
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

std::vector<ContactOptions> read_contacts(const Section& root, int dimension) {
  std::vector<ContactOptions> contacts;
  for (const Section& section :
       root.sections({"contact", "rigid walls, planes or closed surfaces of triangles, one section each"})) {
    const std::string name = contacts.empty() ? "wall" : fmt::format("wall {}", contacts.size() + 1);
    ContactOptions contact = read_contact(section, dimension, name);
    if (std::any_of(contacts.begin(), contacts.end(),
                    [&](const ContactOptions& other) { return other.wall == contact.wall; }))
      section.fail("between", fmt::format("a second wall \"{}\"", contact.wall),
                   "results are listed by name");
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

void refuse_walls(const Section& root, const Scene& scene) {
  if (scene.contacts.empty()) return;
  const Section section = root.sections("contact").front();
  const std::string& scheme = scene.method.scheme;
  if (scheme != "updated" && scheme != "eulerian")
    section.fail("", fmt::format("contradicts scheme = \"{}\"", scheme), "that scheme has no contact",
                 "use scheme = \"updated\" or \"eulerian\", or [[boundary]]");
  if (scheme == "updated" && !scene.method.updated.conservative())
    section.fail("", "contradicts balance = \"printed\"", "its geometry may be that of steps before",
                 "use [updated] balance = \"conservative\"");
}

Statement said_of(const ContactOptions& contact, const MaterialChoice& material) {
  return {"contact",
          fmt::format("\"{}\", {}{}: Hertz with E* = {:.6g} Pa, {}", contact.wall,
                      contact.corners.empty() ? "a half-space"
                                              : fmt::format("{} triangles", contact.corners.size() / 9),
                      contact.displacement.empty() ? "" : " that moves", modulus_of(contact, material),
                      contact.friction > 0 ? fmt::format("friction {:g}", contact.friction) : "no friction"),
          "THEORY (19.1), (19.2)"};
}

template <int d>
std::vector<RigidWall<d>> walls_of_scene(const Scene& scene, double spacing) {
  std::vector<RigidWall<d>> walls;
  for (const ContactOptions& contact : scene.contacts) {
    RigidWall<d> wall;
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
