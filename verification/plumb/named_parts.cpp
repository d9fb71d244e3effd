#include "verification/plumb/named_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "lib/core/type_list.hpp"
#include "lib/input/unit_names.hpp"
#include "lib/input/units.hpp"
#include "lib/material/law.hpp"
#include "lib/scene/names.hpp"
#include "lib/schemes/tlsph/bonds/estimator_catalogue.hpp"
#include "mms/manufactured.hpp"
#include "verification/plumb/parts.hpp"

namespace plumb::app {
namespace {

/// What names mean that have no header with a docstring of their own; by kind and name.
const std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>>& meanings() {
  static const std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>> all{
      {{"cloud", "lattice"}, {"particles on a regular lattice that fills the body", ""}},
      {{"cloud", "blue-noise"}, {"random particles that keep a distance from each other", ""}},
      {{"layout", "cell"}, {"particles in the middle of cells, none on the surface", ""}},
      {{"layout", "node"}, {"particles on corners of cells, so on the surface too", ""}},
      {{"layout", "mirror"}, {"like cell, with images behind rollers", ""}},
      {{"pair", "W1"},
       {"sums of constant and of linear fields are exact at every particle", "THEORY (2.2), (2.7)"}},
      {{"pair", "W0"},
       {"sums of constant fields are exact, the gradient is corrected for linear ones",
        "THEORY (2.4), (2.6)"}},
      {{"gradient", "compatible"},
       {"area vectors nearest to a start table that are closed and exact", "THEORY (11.1), (11.4)"}},
      {{"momentum", "variational"},
       {"the adjoint form with a correction that makes linear fields exact", ""}},
      {{"wave speed", "linear"}, {"that of the material at rest, constant", "THEORY (7.3)"}},
      {{"wave speed", "stretch"}, {"grows with the stretch between two particles", "THEORY (7.3)"}},
      {{"wave speed", "stretch-inverse"}, {"falls with the stretch between two particles", "THEORY (7.3)"}},
      {{"compatible start", "standard"},
       {"the table of the standard gradient is projected", "THEORY (11.1)"}},
      {{"compatible start", "improved"},
       {"the table of the improved gradient is projected", "THEORY (11.1)"}},
      {{"compatible volume", "unknown"}, {"volumes are found together with the area vectors", ""}},
      {{"compatible volume", "fixed"}, {"volumes are those of the Voronoi cells", ""}},
      {{"compatible surface", "shape"}, {"the surface is that of the body's shape", ""}},
      {{"compatible surface", "estimated"}, {"the surface is guessed from the particles", ""}},
      {{"material", "johnson-cook"},
       {"hardening, rates, heating and damage, of schemes that integrate stress by rates", "THEORY (4.17)"}},
      {{"plane", "strain"}, {"of bodies in 2D: no strain across the plane", ""}},
      {{"plane", "stress"}, {"of bodies in 2D: no stress across the plane", "THEORY (4.10)"}},
      {{"jst level", "symmetric"}, {"as the paper prints it", "THEORY (6.1)"}},
      {{"jst level", "transpose"}, {"L^T V L, dissipative by construction", "THEORY (6.4)"}},
      {{"boundary kind", "clamped"}, {"the velocity is zero", ""}},
      {{"boundary kind", "roller"}, {"the velocity normal to a face is zero", ""}},
      {{"boundary kind", "velocity"}, {"the velocity is given by formulas", ""}},
      {{"boundary kind", "displacement"}, {"the displacement is given by formulas", ""}},
      {{"boundary kind", "traction"}, {"a force per reference area, which keeps its direction", ""}},
      {{"boundary kind", "pressure"}, {"a pressure, which follows the surface", ""}},
      {{"paper", "000"}, {"improved gradient, symmetrised force, RK3 and JST, as printed", ""}},
      {{"paper", "001"}, {"Eulerian kernels with the Shepard force and hourglass control, signs mended", ""}},
      {{"paper", "002"}, {"updated Lagrangian SPH with two clocks and the mean rotation, as printed", ""}},
      {{"paper", "004"}, {"equilibria with uncorrected kernels and hourglass energy, as printed", ""}},
      {{"pair", "none"}, {"the kernel is not corrected, its gradient by L^-1 (paper 004)", ""}},
      {{"scheme", "eulerian"},
       {"Eulerian kernels with hourglass control of paper 001, with neighbours that change", ""}},
      {{"scheme", "updated"}, {"updated Lagrangian SPH of paper 002, with neighbours that change", ""}},
      {{"scheme", "element"}, {"finite elements on the nodes of a box lattice, for comparison", ""}},
      {{"paper", "003"}, {"the mixed system with tributary volumes and upwinding, as printed", ""}},
      {{"scheme", "tlsph"}, {"total Lagrangian SPH of paper 000, in displacements", ""}},
      {{"scheme", "implicit"}, {"equilibria and the midpoint rule by Newton's method, paper 004", ""}},
      {{"scheme", "mixed"}, {"first-order system for velocity and deformation, paper 003", ""}},
      {{"compatible table", "auto"}, {"the closed form where there is one, else projected", ""}},
      {{"compatible table", "closed-form"}, {"exact products of lines, of node lattices of a box", ""}},
      {{"compatible table", "projected"}, {"the nearest table, by one linear solve at set-up", ""}}};
  return all;
}

NamedPart described(const std::string& kind, const std::string& key, const std::string& name) {
  NamedPart named{kind, key, name, "", ""};
  const auto found = meanings().find({kind, name});
  if (found != meanings().end()) std::tie(named.meaning, named.theory) = found->second;
  const auto part = std::find_if(std::begin(parts), std::end(parts),
                                 [&](const Part& p) { return p.kind == kind && p.name == name; });
  if (part != std::end(parts)) {
    named.meaning = part->meaning;
    named.theory = part->theory;
  }
  return named;
}

/// "the side where x is least".
std::string meaning_of_face(const std::string& face) {
  return std::string("the side where ") + face[0] + (face[1] == '-' ? " is least" : " is greatest");
}

std::vector<NamedParameter> parameters_of(const std::string& law) {
  std::vector<NamedParameter> all;
  for (const LawParameter& about : parameters_of_law(law))
    all.push_back({std::string(about.name), std::string(about.quantity.unit), std::string(about.meaning),
                   about.required});
  return all;
}

}  // namespace

std::vector<NamedPart> named_parts() {
  std::vector<NamedPart> all;
  for (const auto& choice : scene_choices())
    for (const auto& name : choice.names) {
      all.push_back(described(choice.meaning, choice.key, name));
      if (choice.meaning == "face") all.back().meaning = meaning_of_face(name);
      if (choice.meaning == "material") all.back().parameters = parameters_of(name);
    }
  for (const auto& name : names_of(EstimatorCatalogue{})) {
    all.push_back(described("gradient", "--estimator of plumb oned", name));
    all.back().kind = "estimator";
  }
  for (const auto& solution : mms::solution_list())
    all.push_back({"solution", "study.solution", solution.name, solution.summary, ""});
  for (const auto& unit : unit_names()) {
    const Measured one = parse_measured("1 " + unit);
    all.push_back(
        {"unit", "any quantity", unit, fmt::format("{:.10g} {}", one.value, text_of(one.dimension)), ""});
  }
  return all;
}

}  // namespace plumb::app
