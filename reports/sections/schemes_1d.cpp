#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/named.hpp"
#include "reports/section.hpp"
#include "reports/studies.hpp"

namespace plumb::reports::sections::schemes_1d {
namespace {

using Json = nlohmann::ordered_json;

/// The schemes of the house on the standing wave of a bar.
std::vector<Refinement> entries() {
  const auto entry = [](std::string id, std::string name, std::vector<std::string> set) {
    return Refinement{"schemes-1d-" + id, std::move(name), "standing_bar.toml", std::move(set)};
  };
  return {entry("tlsph", "total Lagrangian, default", {}),
          entry("mixed", "mixed, upwinding R^T S R", {"method.scheme=mixed"}),
          entry("mixed-none", "mixed, no upwinding", {"method.scheme=mixed", "mixed.upwind=none"}),
          entry("element", "finite elements, linear", {"method.scheme=element"})};
}

Section write(const Results& results) {
  const auto schemes = entries();
  Section s;
  s.question = "Does a bar have the order of the scheme?";
  std::vector<std::string> jobs;
  for (const auto& scheme : schemes) jobs.push_back(scheme.id);
  DataTable fits = fits_table("schemes-1d-fits", "Orders", jobs);
  DataTable levels = levels_table("schemes-1d-levels", "Levels", jobs);
  std::string orders;
  for (const auto& scheme : schemes) {
    const Json result = results.json(scheme.id);
    add_fits(fits, scheme.name, scheme.id, result, "schemes-1d-errors");
    add_levels(levels, scheme.name, scheme.id, result);
    orders += fmt::format("{}{:.2f} ({})", orders.empty() ? "" : ", ", number(fit_of(result, "l2"), "order"),
                          scheme.name);
  }
  s.answer = "Orders of the displacement in L₂: " + orders + ".";
  s.figures = {levels_figure(
      results, "schemes-1d-errors", "Error against spacing", schemes,
      "Standing wave of a bar in uniaxial strain, finite strain, ν = 0.3, at 9/8 of its period.")};
  s.tables = {fits, levels};
  for (const char* id : {"schemes-1d-tlsph", "schemes-1d-mixed-none", "schemes-1d-element"})
    s.checks.push_back(study_check(by_id(schemes, id).name + ": order in L₂", results.json(id), "l2"));
  s.notes = {
      "In one dimension nothing moves across the bar: its modulus is λ + 2μ, and energies are per cross-section."};
  return s;
}

}  // namespace

/// Every scheme that steps in time on a bar.
SectionPlan planned(Extent) {
  SectionPlan plan{406, "schemes-1d", "The schemes on a bar", {}, write};
  for (const auto& entry : entries()) plan.jobs.push_back(refinement_job(entry));
  return plan;
}

}  // namespace plumb::reports::sections::schemes_1d
