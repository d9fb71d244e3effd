#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/results.hpp"
#include "reports/section.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::static_manufactured {
namespace {

using Json = nlohmann::ordered_json;

/// One body with one table. Compatible ones declare order 2; paper 004 declares nothing.
struct Equilibrium {
  Refinement study;
  bool compatible = true;
};

Refinement study_of(const std::string& id, const std::string& name, const std::string& file,
                    std::vector<std::string> set = {}) {
  return {"static-manufactured-" + id, name, file + ".toml", std::move(set)};
}

const std::vector<std::string> finite_strain{"method.scheme=implicit", "study.parameters.amplitude=0.2"};

/// The table of paper 004 with supports of each particle's own spacing, 2.05 of them.
std::vector<std::string> by_paper_004(const std::string& alpha) {
  return {"method.scheme=implicit",  "study.parameters.amplitude=0.2",
          "method.paper=\"004\"",    "method.kernel=quintic",
          "method.pair=none",        "method.gradient=standard",
          "method.beta=0.683333",    "method.support=spacing",
          "hourglass.alpha=" + alpha};
}

std::vector<std::string> with(std::vector<std::string> set, const std::string& more) {
  set.push_back(more);
  return set;
}

const std::vector<Equilibrium>& equilibria() {
  static const std::vector<Equilibrium> all{
      {study_of("plate", "plate, lattice", "static_plate_finite")},
      {study_of("plate-jitter", "plate, jitter 0.2", "static_plate_finite", {"body.jitter=0.2"})},
      {study_of("plate-blue", "plate, blue noise, hourglass energy", "static_plate_finite",
                {"body.cloud=blue-noise", "method.beta=1.2", "hourglass.alpha=0.2"})},
      {study_of("plate-blue-bare", "plate, blue noise, no hourglass energy", "static_plate_finite",
                {"body.cloud=blue-noise", "method.beta=1.2"})},
      {study_of("graded-linear", "plate, spacing 2:1, small strain", "static_plate_graded")},
      {study_of("graded", "plate, spacing 2:1", "static_plate_graded", finite_strain)},
      {study_of("graded-jitter", "plate, spacing 2:1, jitter 0.2", "static_plate_graded",
                with(finite_strain, "body.jitter=0.2"))},
      {study_of("graded-004-0", "the same lattice by paper 004, alpha 0", "static_plate_graded",
                by_paper_004("0")),
       false},
      {study_of("graded-004-1", "the same lattice by paper 004, alpha 1", "static_plate_graded",
                by_paper_004("1")),
       false},
      {study_of("cube", "cube, lattice", "static_cube_finite")},
      {study_of("cube-jitter", "cube, jitter 0.2", "static_cube_finite", {"body.jitter=0.2"})},
      {study_of("ring", "ring, rings of particles", "static_ring_finite")},
      {study_of("cavity", "cube with a round cavity", "static_cavity_finite")}};
  return all;
}

Section write(const Results& results) {
  Section s;
  s.question = "Do equilibria of large strains converge, on which clouds and bodies?";
  s.tables = {fits_table("static-manufactured-fits", "Fitted orders of static studies", {})};
  std::vector<Refinement> drawn;
  int passed = 0, all = 0;
  for (const Equilibrium& of : equilibria()) {
    const Json result = results.json(of.study.id);
    add_fits(s.tables[0], of.study.name, of.study.id, result, "static-manufactured-levels");
    s.tables[0].jobs.push_back(of.study.id);
    drawn.push_back(of.study);
    if (!of.compatible) continue;
    s.checks.push_back(study_check(of.study.name + ": order in L₂", result, "l2"));
    s.checks.back().job = of.study.id;
    ++all;
    if (s.checks.back().verdict == "pass") ++passed;
  }
  s.answer = fmt::format("With compatible bonds {} of {} studies have order 2 in L₂.", passed, all);
  s.figures = {
      levels_figure(results, "static-manufactured-levels", "Static studies", drawn,
                    "Displacements are exact on the whole surface; -Div P of the field acts inside.")};
  s.notes = {
      "Strains are up to 0.3 on the plate and 0.3 in the cube; \"small strain\" is the linear study with the same field.",
      "Spacing 2:1: cells of d for X < 1 and of d/2 beyond. Compatible bonds have one smoothing length, of the coarse cells; paper 004 has a support for each particle, of 2.05 of its own spacings.",
      "On blue noise without hourglass energy the finest level ends in another equilibrium: its error is four times that of the level before. With alpha 0.2 all levels converge.",
      "The verdict says whether the orders of pairs of levels settle: \"not-asymptotic\" where they still move."};
  return s;
}

}  // namespace

/// Static manufactured solutions at finite strain: lattices, irregular and graded clouds, three dimensions, curved bodies.
SectionPlan planned(bool) {
  SectionPlan plan{511, "static-manufactured", "Static manufactured solutions", {}, write};
  for (const Equilibrium& of : equilibria()) plan.jobs.push_back(refinement_job(of.study, "static"));
  return plan;
}

}  // namespace plumb::reports::sections::static_manufactured
