#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::near_incompressible {
namespace {

using Json = nlohmann::ordered_json;

const std::string file = "verification/studies/swinging_plate_finite_strain.toml";
const std::vector<double> ratios{0.3, 0.45, 0.495, 0.4995, 0.49995};
constexpr double spacing = 0.1;

struct Scheme {
  std::string momentum, gradient;
};

std::vector<Scheme> schemes() {
  std::vector<Scheme> all;
  for (const char* momentum : {"adjoint", "symmetrised"})
    for (const char* gradient : {"standard", "improved", "compatible"}) all.push_back({momentum, gradient});
  return all;
}

Job job() {
  std::string nu = "material.poisson=";
  for (const double ratio : ratios) nu += fmt::format("{}{:g}", ratio == ratios.front() ? "" : ",", ratio);
  return {"near-incompressible",
          {"mms", file, "--work-precision", "--repeats", "1", "--set", "study.spacings=[0.2,0.1]", "--set",
           "method.integrator=verlet", "--set", "method.beta=1.2", "--vary", nu, "--vary",
           "method.momentum=adjoint,symmetrised", "--vary", "method.gradient=standard,improved,compatible"},
          {file}};
}

double error_at(const Json& points, double nu, const Scheme& scheme, double d) {
  const std::string label = fmt::format("poisson {:g}, {}, {}", nu, scheme.momentum, scheme.gradient);
  for (const auto& point : points)
    if (text(point, "method") == label && std::abs(number(point, "d") - d) < 1e-9)
      return number(point, "error");
  throw MissingResult(label);
}

Section write(const Results& results) {
  const Json points = results.json("near-incompressible").at("points");
  Section s;
  s.question = "Does the error grow as the material becomes incompressible?";
  Picture p{"Relative L₂ error at d = 0.1 m",
            {"1/2 - ν", "", Scale::log},
            {"relative error in L₂", "", Scale::log}};
  p.labels = Labels::legend;
  DataTable table{"near-incompressible",
                  "Relative L₂ error at d = 0.1 m",
                  {{"momentum"}, {"gradient"}},
                  {},
                  {"near-incompressible"}};
  for (const double nu : ratios) table.columns.push_back({fmt::format("ν = {:g}", nu), "", 3});
  table.columns.push_back({fmt::format("order from d = {:g} at {:g}", 2 * spacing, ratios.back()), "", 2});
  double least = 1e9, most = 0;
  std::string best, worst;
  for (const auto& scheme : schemes()) {
    Series series{scheme.momentum + ", " + scheme.gradient, {}, {}};
    std::vector<Entry> row{scheme.momentum, scheme.gradient};
    for (const double nu : ratios) {
      const double error = error_at(points, nu, scheme, spacing);
      row.emplace_back(error);
      series.x.push_back(0.5 - nu);
      series.y.push_back(error);
    }
    row.emplace_back(std::log2(error_at(points, ratios.back(), scheme, 2 * spacing) / series.y.back()));
    table.rows.push_back(row);
    const double growth = series.y.back() / series.y.front();
    if (growth < least) least = growth, best = series.label;
    if (!(growth <= most)) most = growth, worst = series.label;
    p.series.push_back(series);
  }
  s.answer = fmt::format(
      "From ν = 0.3 to 0.49995 the error of \"{}\" changes by a factor of {:.2g}, that of \"{}\" by {:.2g}.",
      best, least, worst, most);
  s.figures = {{"near-incompressible",
                p,
                "Swinging plate, U = 0.01 m, at 9T/8, β = 1.2, W1, node layout, Verlet.",
                {"near-incompressible"}}};
  s.tables = {table};
  s.notes = {
      "A factor near or below 1 means no locking. β = 1.2, because at 0.9 the standard and the improved "
      "estimate are one operator inside."};
  return s;
}

}  // namespace

/// The near-incompressible family: error at a fixed spacing against Poisson's ratio.
SectionPlan planned(Extent) {
  return {330, "incompressible", "Nearly incompressible materials", {job()}, write};
}

}  // namespace plumb::reports::sections::near_incompressible
