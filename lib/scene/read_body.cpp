#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/scene/cloud_file.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/readers.hpp"

namespace plumb {
namespace {

/// What makes a body more than a piece of a line.
void refuse_more_than_a_bar(const Section& section, int dimension) {
  if (dimension != 1) return;
  const auto refuse = [&](const char* key, const std::string& what) {
    section.fail(key, what + " in one dimension", "the body is a bar: a piece of a line",
                 "leave it out, or use dimension = 2 or 3");
  };
  if (section.has("file")) refuse("file", "particles or a surface of a file");
  if (section.has("hole")) refuse("hole", "a hole");
  const std::string shape = section.choice_or({"shape", "what the particles fill"}, "box", shape_names());
  if (shape != "box") refuse("shape", fmt::format("shape \"{}\"", shape));
  const std::string cloud = section.choice_or(
      {"cloud", "how particles are placed: on a lattice, or at random with a least distance"}, "lattice",
      cloud_names());
  if (cloud != "lattice") refuse("cloud", fmt::format("cloud \"{}\"", cloud));
}

/// The lengths that the shape of that name has.
ShapeLengths read_lengths(const Section& section, const std::string& shape, int dimension) {
  ShapeLengths lengths;
  for (const auto& entry : lengths_of_shape(shape)) {
    if (!entry.required && !section.has(entry.name)) continue;
    const auto whole = static_cast<std::size_t>(dimension);
    switch (entry.kind) {
      case ShapeLength::Kind::length:
        lengths[entry.name] = {section.number({entry.name, entry.meaning}, quantity::length, Sign::positive)};
        break;
      case ShapeLength::Kind::point:
        lengths[entry.name] = section.numbers({entry.name, entry.meaning}, whole, quantity::length);
        break;
      case ShapeLength::Kind::direction:
        lengths[entry.name] = section.numbers({entry.name, entry.meaning}, whole, quantity::number);
        break;
      case ShapeLength::Kind::points:
        lengths[entry.name] = section.points({entry.name, entry.meaning}, whole, quantity::length);
        break;
    }
  }
  return lengths;
}

/// Calls make<dimension>(), and gives its InputError the section's place.
template <class Make>
void at_section(const Section& section, const char* key, int dimension, Make&& make) {
  try {
    if (dimension == 2) make.template operator()<2>();
    if (dimension == 3) make.template operator()<3>();
  } catch (const InputError& error) {
    section.fail(key, error.problem(), error.why(), error.suggestion());
  }
}

ShapeChoice read_hole(const Section& section, int dimension) {
  ShapeChoice hole{section.choice_or({"shape", "what is taken off"}, "ball", shape_names()), {}};
  hole.lengths = read_lengths(section, hole.name, dimension);
  at_section(section, "shape", dimension, [&]<int d>() { shape_named<d>(hole.name, hole.lengths); });
  section.reject_unknown();
  return hole;
}

void read_box(const Section& section, Body& body, int dimension) {
  body.size = section.numbers({"size", "edge lengths of the box"}, static_cast<std::size_t>(dimension),
                              quantity::length, Sign::positive);
  const int given = static_cast<int>(body.size.size());
  if (given > 3) section.fail("size", fmt::format("{} values", given), "a body has 1, 2 or 3 dimensions");
  body.origin.assign(body.size.size(), 0.0);
  if (section.has("origin"))
    body.origin = section.numbers({"origin", "lowest corner of the box; zeros where it is left out"},
                                  body.size.size(), quantity::length);
}

/// Origin and size become those of the box around the shape. One that fills it is a box.
void take_box(const Section& section, Body& body, int dimension) {
  at_section(section, section.has("file") ? "file" : "shape", dimension, [&]<int d>() {
    const Shape<d> shape = shape_named<d>(body.shape, body.lengths);
    const Box<d>& box = shape.box;
    if (!box.size.allFinite())
      throw InputError(fmt::format("a body of shape \"{}\"", body.shape), "it has no bounds",
                       "use it as a [[body.hole]] that cuts another shape");
    body.origin.assign(box.origin.data(), box.origin.data() + d);
    body.size.assign(box.size.data(), box.size.data() + d);
    if (shape.clip) return;
    body.shape = "box";
    body.lengths.clear();
  });
}

/// The body of a study tells its dimension, by the numbers of its centre.
void require_centre(const Section& section, const std::string& shape) {
  for (const auto& entry : lengths_of_shape(shape))
    if (entry.name == "centre") return;
  section.fail("shape", fmt::format("\"{}\" in a study", shape),
               "the dimension of a study is that of its body, which a centre tells",
               "use \"ball\", or a box with [[body.hole]]");
}

int dimension_of_centre(const Section& section, const ShapeLengths& lengths) {
  const auto centre = lengths.find("centre");
  const std::size_t numbers = centre == lengths.end() ? 0 : centre->second.size();
  if (numbers != 2 && numbers != 3)
    section.fail("centre", fmt::format("{} numbers", numbers), "it tells the dimension of the study",
                 "give 2 or 3");
  return static_cast<int>(numbers);
}

/// Shapes other than boxes.
void read_shape(const Section& section, Body& body, int dimension) {
  if (dimension == 0) require_centre(section, body.shape);
  body.lengths = read_lengths(section, body.shape, dimension);
  if (dimension == 0) dimension = dimension_of_centre(section, body.lengths);
  take_box(section, body, dimension);
}

std::string read_name(const Section& section) {
  return section.text_or({"name", "what [[contact]] calls the body"}, "body");
}

/// Where cells have half the spacing.
void read_finer(const Section& section, Body& body, int dimension) {
  body.finer = section.formula(
      {"finer", "condition on X, Y, Z: cells have half the spacing where it holds at their middle"},
      dimension, quantity::number);
  if (body.shape != "box" || !body.holes.empty() || body.cloud != "lattice")
    section.fail("finer", "for a body that is no lattice in a box", "cells of a box are divided",
                 "leave it out, or the shape, the holes and cloud");
  if (body.layout != Layout::node)
    section.fail(
        "finer",
        fmt::format("contradicts layout = \"{}\"", body.layout == Layout::mirror ? "mirror" : "cell"),
        "particles are the corners of cells", "use layout = \"node\"");
}

/// Particles of a file. A shape, where one is given, bounds them.
Body read_body_of_file(const Section& section, int dimension) {
  Body body;
  body.name = read_name(section);
  body.shape = section.choice_or("shape", body.shape, shape_names());
  if (body.shape != "box")
    read_shape(section, body, dimension);
  else if (section.has("size"))
    read_box(section, body, dimension);
  else if (section.has("origin"))
    section.fail("origin", "without size", "the box is that around the points", "leave it out, or give size");
  for (const Section& hole :
       section.sections({"hole", "shapes that are taken off the body, one section each"}))
    body.holes.push_back(read_hole(hole, dimension));
  read_cloud_file(section, body, dimension);
  section.reject_unknown();
  return body;
}

}  // namespace

Body read_body(const Section& section, int dimension, bool with_lattice) {
  Body body;
  if (with_lattice) body.name = read_name(section);
  refuse_more_than_a_bar(section, dimension);
  body.shape = section.choice_or("shape", body.shape, shape_names());
  const bool surface =
      section.has("file") &&
      is_surface_file(section.text(
          {"file",
           "points that another program placed (CSV, VTK, HDF5), or an STL surface; relative to the scene"}));
  if (section.has("file") && !surface) return read_body_of_file(section, dimension);
  body.cloud = section.choice_or("cloud", body.cloud, cloud_names());
  if (surface) {
    read_surface_file(section, body, dimension);
    take_box(section, body, dimension);
  } else if (body.shape == "box")
    read_box(section, body, dimension);
  else
    read_shape(section, body, dimension);
  const int given = static_cast<int>(body.size.size());
  refuse_more_than_a_bar(section, given);  // of a study, whose size says the dimension
  for (const Section& hole : section.sections("hole")) body.holes.push_back(read_hole(hole, given));
  const std::string layout = section.choice_or(
      {"layout",
       "node: particles on the surface; cell: half a spacing inside; mirror: as cell, with images behind rollers"},
      "node", layout_names());
  body.layout = layout == "cell" ? Layout::cell : layout == "mirror" ? Layout::mirror : Layout::node;
  body.jitter = section.number_or({"jitter", "random displacement of inner particles over the spacing"},
                                  body.jitter, quantity::number, Sign::not_negative);
  if (body.jitter >= 0.5)
    section.fail("jitter", fmt::format("{} is too large", body.jitter),
                 "it is a fraction of the spacing below 0.5, or particles could meet");
  body.seed = static_cast<std::uint64_t>(
      section.integer_or({"seed", "of the random numbers: the same seed gives the same cloud"},
                         static_cast<long>(body.seed), 0));
  if (section.has("finer")) read_finer(section, body, given);
  if (with_lattice) resolve_lattice(section, body, given);
  section.reject_unknown();
  return body;
}

}  // namespace plumb
