#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/checks.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::statics {
namespace {

using Json = nlohmann::ordered_json;

/// A static body with one number that others have: a displacement of the scene's probe "tip", or its strain
/// energy.
struct Case {
  std::string id, name, scene, quantity, unit;
  int component;    ///< of the displacement; -1: the strain energy
  double factor;    ///< from SI to the unit
  double expected;  ///< in that unit
  std::string source;
};

const std::vector<Case> cases{
    {"cook-strain", "Cook's membrane, plane strain", "cook-membrane", "corner (48, 60) mm rises by", "mm", 1,
     1e3, 32.27, "CalculiX; Code_Aster 32.20, Elmer 32.28"},
    {"cook-stress", "Cook's membrane, plane stress", "cook-membrane", "middle of the right side rises by",
     "mm", 1, 1e3, 23.96 / 0.7, "Cook (1974) and many after him"},
    {"weight", "bar under its weight", "weighing-bar", "lower end sinks by", "mm", 1, -1e3,
     1e3 * 1100 * 9.81 / (2 * 17e6), "closed form"},
    {"lame", "Lamé's ring", "lame-ring", "radial displacement at r = 1.5 m", "µm", 0, 1e6, 1.415556,
     "closed form"},
    {"kirsch", "Kirsch's plate", "kirsch-plate", "side of the hole moves by", "µm", 0, 1e6, 3, "closed form"},
    {"cantilever", "cantilever of paper 004", "cantilever", "tip rises by", "µm", 1, 1e6, 2.77242,
     "quadratic elements, 16 x 8 x 6"},
    {"rod", "pulled rod of paper 004", "pulled-rod", "strain energy", "J", -1, 1, 800, "closed form"},
    {"flag-height", "elastic flag, CSM1", "flag-at-rest", "tip rises by", "mm", 1, 1e3, -66.10,
     "Turek and Hron (2006)"},
    {"flag-along", "elastic flag, CSM1", "flag-at-rest", "tip along the bar", "mm", 0, 1e3, -7.187,
     "Turek and Hron (2006)"},
    {"cube", "pressed cube of paper 004", "pressed-cube", "corner sinks by", "m", 2, -1, 0.5396,
     "triquadratic elements, 10 x 10 x 10"},
};

/// One way to solve a case, and how far off it may be; nothing where that is what it shows.
struct Way {
  std::string id, of, name;
  std::vector<std::string> set;
  std::optional<double> tolerance;
  std::string reason;
  std::string run = {};  ///< the way whose run it shares; nothing: its own
  Extent least = Extent::core;

  std::string job() const { return "statics-" + (run.empty() ? id : run); }
};

const std::vector<std::string> quadratic{"method.scheme=element", "element.solve=newton",
                                         "element.order=quadratic"};
const std::vector<std::string> reduced{"method.scheme=element", "element.solve=newton",
                                       "element.order=reduced"};
const std::vector<std::string> compatible{"method.gradient=compatible"};

const std::vector<std::string> flag_of_8{"body.spacing=0.0025",
                                         "boundary.0.where=(X + 0.05)^2 + (Y - 0.01)^2 < 0.05125^2"};

std::vector<std::string> with(std::vector<std::string> set, const std::string& more) {
  set.push_back(more);
  return set;
}

const std::vector<Way> ways{
    {"cook-strain-2",
     "cook-strain",
     "compatible bonds, d = 2 mm",
     {"output.probe.1.at=[0.048,0.06]"},
     {},
     ""},
    {"cook-strain-1",
     "cook-strain",
     "compatible bonds, d = 1 mm",
     {"body.spacing=0.001", "output.probe.1.at=[0.048,0.06]"},
     0.01,
     "first order at the clamped corners"},
    {"cook-stress-2", "cook-stress", "compatible bonds, d = 2 mm", {"material.plane=stress"}, {}, ""},
    {"cook-stress-1",
     "cook-stress",
     "compatible bonds, d = 1 mm",
     {"material.plane=stress", "body.spacing=0.001"},
     0.01,
     "first order at the clamped corners"},
    {"weight-compatible", "weight", "compatible bonds", compatible, 0.01, "second order, 20 cells along"},
    {"weight-improved", "weight", "default table", {}, {}, ""},
    {"weight-quadratic", "weight", "quadratic elements", quadratic, 1e-9, "the solution is a parabola"},
    {"lame-10", "lame", "compatible bonds, d = 0.1 m", {}, {}, ""},
    {"lame-20",
     "lame",
     "compatible bonds, d = 0.05 m",
     {"body.spacing=0.05"},
     0.01,
     "second order, 20 cells across"},
    {"kirsch-5", "kirsch", "compatible bonds, d = 0.2 m", {}, {}, ""},
    {"kirsch-10",
     "kirsch",
     "compatible bonds, d = 0.1 m",
     {"body.spacing=0.1"},
     0.02,
     "10 cells along the radius"},
    {"cantilever-004", "cantilever", "paper 004, alpha 1", {"method.paper=\"004\""}, {}, ""},
    {"cantilever-compatible", "cantilever", "compatible bonds", compatible, 0.1, "6 cells of depth"},
    {"cantilever-reduced", "cantilever", "one-point elements", reduced, 0.05, "6 cells of depth"},
    {"cantilever-quadratic", "cantilever", "quadratic elements", with(quadratic, "body.spacing=0.25"), 0.002,
     "the same elements, the load by Simpson's rule"},
    {"rod-004", "rod", "paper 004, alpha 1", {"method.paper=\"004\""}, {}, ""},
    {"rod-004-0", "rod", "paper 004, alpha 0", {"method.paper=\"004\"", "hourglass.alpha=0"}, {}, ""},
    {"rod-compatible", "rod", "compatible bonds", compatible, 1e-9, "the patch test"},
    {"rod-reduced", "rod", "one-point elements", reduced, 1e-9, "the patch test"},
    {"flag-height-8", "flag-height", "at rest in time, 8 cells across", flag_of_8, {}, ""},
    {"flag-height-20",
     "flag-height",
     "at rest in time, 20 cells across",
     {},
     0.01,
     "the published numbers have four digits",
     {},
     Extent::full},
    {"flag-along-8", "flag-along", "at rest in time, 8 cells across", flag_of_8, {}, "", "flag-height-8"},
    {"flag-along-20",
     "flag-along",
     "at rest in time, 20 cells across",
     {},
     0.01,
     "the published numbers have four digits",
     "flag-height-20",
     Extent::full},
    {"cube-004", "cube", "paper 004, alpha 1", {"method.paper=\"004\""}, {}, ""},
    {"cube-004-0", "cube", "paper 004, alpha 0", {"method.paper=\"004\"", "hourglass.alpha=0"}, {}, ""},
    {"cube-compatible", "cube", "compatible bonds, alpha 1", with(compatible, "hourglass.alpha=1"), {}, ""},
    {"cube-reduced", "cube", "one-point elements", reduced, {}, ""},
    {"cube-quadratic", "cube", "quadratic elements, 4 x 4 x 4", quadratic, 0.06,
     "the same elements have 0.5116"},
};

Job job_of(const Way& way) {
  const std::string file = "verification/scenes/" + by_id(cases, way.of).scene + ".toml";
  Job job{way.job(), {"run", file, "--out", "{out}"}, {file}};
  for (const auto& set : way.set) job.arguments.insert(job.arguments.end(), {"--set", set});
  return job;
}

double measured(const Json& result, const Case& of) {
  if (of.component < 0) return of.factor * number(result.at("energy"), "strain");
  return of.factor * result.at("probes").at("tip").at("displacement").at(of.component).get<double>();
}

std::vector<Way> ways_of(Extent extent) {
  std::vector<Way> shown = ways;
  std::erase_if(shown, [extent](const Way& way) { return way.least > extent; });
  return shown;
}

Section write(const Results& results, Extent extent) {
  Section s;
  s.question = "Do static answers have the numbers that others have?";
  DataTable table{"statics",
                  "Static cases: ours, that of others, off by",
                  {{"case"},
                   {"quantity"},
                   {"solved by"},
                   {"unit"},
                   {"ours", "", 6},
                   {"of others", "", 6},
                   {"off by", "%", 3},
                   {"source"},
                   {"particles", "", 0},
                   {"CPU time", "s", 3}},
                  {}};
  int near = 0, all = 0;
  for (const Way& way : ways_of(extent)) {
    const Case of = by_id(cases, way.of);
    const std::string job = way.job();
    const Json result = results.json(job);
    const double ours = measured(result, of), off = ours / of.expected - 1;
    table.rows.push_back({of.name, of.quantity, way.name, of.unit, ours, of.expected, 100 * off, of.source,
                          number(result, "particles"), number(result.at("timing"), "cpu_s")});
    table.row_jobs.push_back(job);
    table.jobs.push_back(job);
    ++all;
    if (std::abs(off) < 0.01) ++near;
    if (!way.tolerance) continue;
    Check check = number_check(of.name + ", " + way.name + ": " + of.quantity, ours, of.expected,
                               *way.tolerance, way.reason);
    check.job = job;
    s.checks.push_back(std::move(check));
  }
  s.answer = fmt::format("{} of {} ways are within 1 % of the number of others.", near, all);
  s.tables = {table};
  s.notes = {
      "Paper 004 has uncorrected kernels normalised by L⁻¹: a uniform stress leaves forces at the surface, "
      "so that it fails the "
      "patch test (pulled rod) where compatible bonds and elements pass it.",
      "The cube is near a limit point: the last quarter of the load doubles the displacement, and elements "
      "of 4, 6 and 10 cells "
      "along an edge have 0.5116, 0.5312 and 0.5396 m."};
  return s;
}

}  // namespace

/// Published static cases by the implicit scheme, beside finite elements.
SectionPlan planned(Extent extent) {
  SectionPlan plan{506, "statics", "Static cases", {}, [extent](const Results& results) {
                     return write(results, extent);
                   }};
  for (const auto& way : ways_of(extent))
    if (way.run.empty()) plan.jobs.push_back(job_of(way));
  return plan;
}

}  // namespace plumb::reports::sections::statics
