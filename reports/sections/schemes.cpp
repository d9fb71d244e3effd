#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/named.hpp"
#include "reports/scheme_look.hpp"
#include "reports/section.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::schemes {
namespace {

using Json = nlohmann::ordered_json;

const std::string file = "schemes_plate.toml";

/// The schemes of the house on one solution: as papers print them, and mended.
std::vector<Refinement> entries(bool long_run) {
  const auto entry = [&](std::string id, std::string name, std::vector<std::string> set) {
    if (long_run) set.emplace_back("study.spacings=[0.2,0.1,0.05,0.025,0.0125]");
    return Refinement{"schemes-" + id, std::move(name), file, std::move(set)};
  };
  return {entry("000", "paper 000, as printed", {R"(method.paper="000")"}),
          entry("tlsph", "total Lagrangian, improved table", {"method.gradient=improved"}),
          entry("compatible", "total Lagrangian, default (compatible)", {"method.gradient=compatible"}),
          entry("003", "paper 003, as printed", {R"(method.paper="003")"}),
          entry("mixed", "mixed, upwinding R^T S R", {"method.scheme=mixed"}),
          entry("mixed-none", "mixed, no upwinding", {"method.scheme=mixed", "mixed.upwind=none"}),
          entry("mixed-reconstructed", "mixed, the paper's upwinding, equal volumes",
                {"method.scheme=mixed", "mixed.upwind=reconstructed"}),
          entry("element", "finite elements, linear", {"method.scheme=element"}),
          entry("element-reduced", "finite elements, one point",
                {"method.scheme=element", "element.order=reduced"})};
}

/// Gives a series the look of its scheme: variants of a mended scheme are dashed, or have hollow points.
Series with_look(Series series, const std::string& id) {
  const bool total = id == "schemes-000" || id == "schemes-tlsph" || id == "schemes-compatible";
  const bool elements = id.starts_with("schemes-element");
  series = look_of(series,
                   total      ? "000"
                   : elements ? "elements"
                              : "003",
                   id == "schemes-000" || id == "schemes-003" || id == "schemes-element-reduced");
  series.hollow = series.hollow || id == "schemes-tlsph" || id == "schemes-mixed-none";
  series.dashed = series.dashed || id == "schemes-mixed-reconstructed";
  return series;
}

/// Relative errors in L2 over the CPU time of the steps, a line per scheme.
Figure cost_figure(const Results& results, const std::vector<Refinement>& schemes) {
  Picture p{
      "Error against run time", {"CPU time", "s", Scale::log}, {"relative error in L₂", "", Scale::log}};
  p.labels = Labels::legend;
  std::vector<std::string> jobs;
  for (const auto& scheme : schemes) {
    Series series{scheme.name, {}, {}};
    const Json levels = results.json(scheme.id).at("levels");
    for (const auto& level : levels) {
      if (level.at("relative_l2").is_null()) continue;
      series.x.push_back(number(level, "cpu_s"));
      series.y.push_back(number(level, "relative_l2"));
    }
    p.series.push_back(with_look(series, scheme.id));
    jobs.push_back(scheme.id);
  }
  return {"schemes-cpu", p, "The same runs over the CPU time of their steps, without set-up.", jobs};
}

/// The scheme with the least error on the finest level.
std::string answer_of(const Results& results, const std::vector<Refinement>& schemes) {
  std::string best;
  double least = 0;
  for (const auto& scheme : schemes) {
    const Json levels = results.json(scheme.id).at("levels");
    if (levels.back().at("relative_l2").is_null()) continue;
    const double error = number(levels.back(), "relative_l2");
    if (best.empty() || error < least) best = scheme.name, least = error;
  }
  return fmt::format("On the finest lattice \"{}\" has the least relative error, {:.2g}.", best, least);
}

Section write(const Results& results, bool long_run) {
  const auto schemes = entries(long_run);
  Section s;
  s.question = "How do the schemes compare on the same problem?";
  s.answer = answer_of(results, schemes);
  std::vector<std::string> jobs;
  for (const auto& scheme : schemes) jobs.push_back(scheme.id);
  DataTable fits = fits_table("schemes-fits", "Orders", jobs);
  DataTable levels = levels_table("schemes-levels", "Levels", jobs);
  for (const auto& scheme : schemes) {
    const Json result = results.json(scheme.id);
    add_fits(fits, scheme.name, scheme.id, result, "schemes-errors");
    add_levels(levels, scheme.name, scheme.id, result);
  }
  s.figures = {levels_figure(results, "schemes-errors", "Error against spacing", schemes,
                             "Swinging plate, finite strain, U = 0.01 m, ν = 0.3, at T/8."),
               cost_figure(results, schemes)};
  s.tables = {fits, levels};
  for (auto& series : s.figures[0].picture.series)
    series = with_look(series, named(schemes, series.label, &Refinement::name).id);
  // The declared order is that of central sums: checked where the scheme has them.
  for (const char* id :
       {"schemes-compatible", "schemes-mixed-none", "schemes-element", "schemes-element-reduced"})
    s.checks.push_back(study_check(by_id(schemes, id).name + ": order in L₂", results.json(id), "l2"));
  for (const char* id : {"schemes-000", "schemes-tlsph", "schemes-003"})
    if (const auto check = exclusion_check(by_id(schemes, id).name + ": order 2 in L₂ is excluded",
                                           results.json(id), "l2", 2.0))
      s.checks.push_back(*check);
  s.notes = {
      "Loads, clouds, norms and fits are the same for all; gradients and stresses are the scheme's own.",
      "Paper 003 sums with tributary volumes, as its (41) prints: that costs an order on the faces. With "
      "equal volumes the same system is of second order."};
  return s;
}

}  // namespace

/// Every scheme of the house on one manufactured solution.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{405, "schemes", "The schemes on one problem", {}, [long_run](const Results& results) {
                     return write(results, long_run);
                   }};
  for (const auto& entry : entries(long_run)) plan.jobs.push_back(refinement_job(entry));
  return plan;
}

}  // namespace plumb::reports::sections::schemes
