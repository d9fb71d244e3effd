#pragma once
#include <string>
#include <vector>

#include "lib/input/section.hpp"
#include "lib/scene/scene.hpp"

/// One reader per section of scene and study files; each refuses unknown keys. Used by read_scene.cpp and
/// study.cpp.
namespace plumb {

/// `with_lattice`: spacing or particles are read and resolved (scenes); otherwise they are unknown keys
/// (studies). `dimension` 0: as many as body.size has.
Body read_body(const Section& section, int dimension, bool with_lattice);
/// Reads spacing or particles of a body whose shape, size and layout are known, and gives it both.
void resolve_lattice(const Section& section, Body& body, int dimension);
/// Who asks for a material: a body, which has mass, or a single point.
enum class MaterialOf { body, point };
/// [material] with the parameters that its law declares. `dimension`: 2 may have plane = "stress".
MaterialChoice read_material(const Section& section, int dimension, MaterialOf of = MaterialOf::body);
/// Refuses a law with history in a body of a scheme that has no room for it.
void refuse_history(const Section& root, const MaterialChoice& material, const Method& method);
/// Refuses misprints of paper 004 beside parts and laws that are not those of their equations.
void refuse_misprints(const Section& root, const MaterialChoice& material, const Method& method);
/// Refuses in one dimension what needs more of them.
void refuse_on_a_line(const Section& root, int dimension, const Method& method);
/// Lists the sections that read_method reads: [method] and those of its parts.
std::vector<std::string> method_sections();
/// Reads the sections of schemes, and refuses those of other schemes than that of `method`. A part of read_method().
void read_scheme(const Section& root, Method& method);
/// Reads the scheme with its optional parts. What is not given is that of `paper`, or suits the body:
/// compatible bonds have beta 1.2 unless a lattice fills a box. Paper 000 has [jst].
Method read_method(const Section& root, const Body& body);
std::optional<Initial> read_initial(const Section& root, int dimension);
std::vector<Boundary> read_boundaries(const Section& root, int dimension);
/// Reads [output] of a scene whose bodies are known.
std::optional<Output> read_output(const Section& root, const Scene& scene);
/// Reads what [output] says of the exact displacement; empty if it says nothing.
std::vector<Expression> read_exact(const Section& root, int dimension);

/// Refuses beside layout = "mirror" what knows nothing of images.
void refuse_beside_mirror(const Section& root, Layout layout, const Method& method);

/// Pairs of keys of which an override of one replaces the other.
const Alternatives& scene_alternatives();

}  // namespace plumb
