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

/// A solution of the catalogue on its domain.
struct Frozen {
  std::string solution, parameter, origin, size, spacings;
  bool exact = false;  ///< F is the same everywhere: what is left is Newton's method
};

const std::string coarse = "[0.25, 0.125, 0.0625, 0.03125]", fine = "[0.125, 0.0625, 0.03125, 0.015625]",
                  coarse_3d = "[0.125, 0.1, 0.0833333333333333, 0.0625]",
                  fine_3d = "[0.1, 0.0833333333333333, 0.0625, 0.0416666666666667]";

/// All but swinging plate, trigonometric cube and Lame's ring, which have studies of their own. Waves of several lengths, and rings that
/// are turned against each other, need finer levels.
const std::vector<Frozen>& catalogue() {
  static const std::vector<Frozen> all{
      {"affine-patch", "", "[0, 0]", "[1, 1]", coarse, true},
      {"churchill-bar", "amplitude=0.05", "[0, 0]", "[1, 1]", fine},
      {"generalized-vortex", "amplitude=1", "[-1.25, -1.25]", "[2.5, 2.5]",
       "[0.03125, 0.0208333333333333, 0.015625, 0.0104166666666667]"},
      {"kirsch-plate", "tension=0.1", "[-2, -2]", "[4, 4]", coarse},
      {"lame-mode", "amplitude=0.1", "[0, 0]", "[1, 1]", coarse},
      {"loaded-bar", "amplitude=0.05", "[0, 0]", "[1, 1]", coarse},
      {"plane-cantilever", "load=0.01", "[0, -1.5]", "[8, 3]", "[0.5, 0.25, 0.125, 0.0625]"},
      {"rigid-rotation", "", "[0, 0]", "[1, 1]", coarse, true},
      {"standing-wave", "amplitude=0.05", "[0, 0]", "[1, 1]", coarse},
      {"stretched-column", "", "[-0.5, 0]", "[1, 2]", coarse},
      {"travelling-wave", "amplitude=0.05", "[0, 0]", "[1, 1]", fine},
      {"affine-patch", "", "[0, 0, 0]", "[1, 1, 1]", coarse_3d, true},
      {"churchill-bar", "amplitude=0.05", "[0, 0, 0]", "[1, 1, 1]", fine_3d},
      {"loaded-bar", "amplitude=0.05", "[0, 0, 0]", "[1, 1, 1]", coarse_3d},
      {"rigid-rotation", "", "[0, 0, 0]", "[1, 1, 1]", coarse_3d, true},
      {"standing-wave", "amplitude=0.05", "[0, 0, 0]", "[1, 1, 1]", coarse_3d},
      {"stretched-column", "", "[-0.5, -0.5, 0]", "[1, 1, 2]", coarse_3d},
      {"travelling-wave", "amplitude=0.05", "[0, 0, 0]", "[1, 1, 1]", fine_3d}};
  return all;
}

Refinement study_of(const Frozen& of) {
  const bool flat = of.size.find(',') == of.size.rfind(',');
  std::vector<std::string> set{"study.solution=" + of.solution, "body.origin=" + of.origin,
                               "body.size=" + of.size, "study.spacings=" + of.spacings};
  if (!of.parameter.empty()) set.push_back("study.parameters." + of.parameter);
  if (!flat) set.emplace_back("implicit.solver=iterative");
  return study_of(of.solution + (flat ? "" : "-3d"), of.solution + (flat ? ", plane" : ", space"),
                  "static_catalogue", std::move(set));
}

/// Order of errors, or that there are none.
Check frozen_check(const Frozen& of, const Json& result) {
  const Refinement study = study_of(of);
  Check check;
  if (of.exact) {
    double worst = 0;
    for (const Json& level : result.at("levels")) worst = std::max(worst, number(level, "relative_l2"));
    check = {study.name + ": error of u", "1e-8: residuals are 1e-10 of the forces",
             fmt::format("{:.2g}", worst), pass_if(worst <= 1e-8)};
  } else {
    check = study_check(study.name + ": order in L₂", result, "l2");
  }
  check.job = study.id;
  return check;
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
      {study_of("cube-blue", "cube, blue noise, hourglass energy", "static_cube_finite",
                {"study.spacings=[0.166666666666667, 0.125, 0.1, 0.0833333333333333]",
                 "body.cloud=blue-noise", "method.beta=1.2", "hourglass.alpha=0.2"})},
      {study_of("ball", "ball", "static_ball_finite")},
      {study_of(
          "disc", "disc", "static_ball_finite",
          {"study.solution=swinging-plate", "study.spacings=[0.2, 0.1, 0.05, 0.025]", "study.periods=0.25",
           "study.parameters.amplitude=0.2", "body.centre=[1, 1]", "body.radius=1"})},
      {study_of("ring", "ring, rings of particles", "static_ring_finite")},
      {study_of("cavity", "cube with a round cavity", "static_cavity_finite")}};
  return all;
}

Section write(const Results& results) {
  Section s;
  s.question = "Do equilibria of large strains converge, on which clouds and bodies?";
  s.tables = {
      fits_table("static-manufactured-fits", "Fitted orders of static studies", {}),
      fits_table("static-manufactured-catalogue",
                 "Fitted orders of all solutions of the catalogue, frozen at a fifth of their periods", {})};
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
  for (const Frozen& of : catalogue()) {
    const Refinement study = study_of(of);
    const Json result = results.json(study.id);
    if (!of.exact) {
      add_fits(s.tables[1], study.name, study.id, result, "static-manufactured-levels");
      drawn.push_back(study);
    }
    s.checks.push_back(frozen_check(of, result));
    ++all;
    if (s.checks.back().verdict == "pass") ++passed;
  }
  s.answer =
      fmt::format("With compatible bonds {} of {} studies have order 2 in L₂, or no error.", passed, all);
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
SectionPlan planned(Extent) {
  SectionPlan plan{511, "static-manufactured", "Static manufactured solutions", {}, write};
  for (const Equilibrium& of : equilibria()) plan.jobs.push_back(refinement_job(of.study, "static"));
  for (const Frozen& of : catalogue()) plan.jobs.push_back(refinement_job(study_of(of), "static"));
  plan.least = Extent::full;
  return plan;
}

}  // namespace plumb::reports::sections::static_manufactured
