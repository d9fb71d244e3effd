#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "lib/convergence/order_fit.hpp"
#include "reports/named.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::cantilever_004 {
namespace {

using Json = nlohmann::ordered_json;

constexpr double of_the_field = 2.805728e-3;  ///< strain energy of (62)-(64) in plane stress [J]
constexpr double of_the_load =
    2.77284e-3;  ///< half of the work of the end load: the "exact" one of the paper

/// A way to solve the cantilever on lattices of several spacings, or on an irregular cloud.
struct Way {
  std::string id, name;
  std::vector<std::string> set;
};

std::vector<Way> ways_on_lattices() {
  const std::string paper = R"(method.paper="004")";
  return {{"alpha-1", "paper 004, alpha 1", {paper}},
          {"alpha-0", "paper 004, alpha 0", {paper, "hourglass.alpha=0"}},
          {"compatible", "compatible bonds", {"method.gradient=compatible"}},
          {"quadratic",
           "quadratic elements",
           {"method.scheme=element", "element.solve=newton", "element.order=quadratic"}}};
}

std::vector<Way> ways_on_clouds() {
  const std::string paper = R"(method.paper="004")", support = "method.support=nearest:30";
  return {{"alpha-1", "paper 004, alpha 1", {paper, support}},
          {"alpha-0", "paper 004, alpha 0", {paper, support, "hourglass.alpha=0"}},
          {"compatible", "compatible bonds", {"method.gradient=compatible", "method.beta=1.2"}}};
}

/// Case of the paper: its particles, the cloud that stands for it, and what it prints.
struct Case {
  std::string cloud;
  double error, energy, hourglass;
};

std::vector<Case> cases(bool long_run) {
  std::vector<Case> all{{"286", 0.0859, 3.011e-3, 2.422e-6},
                        {"695", 0.0729, 2.948e-3, 1.487e-6},
                        {"2609", 0.0273, 2.891e-3, 7.785e-7}};
  if (long_run) all.push_back({"14250", 0.0208, 2.819e-3, 3.625e-7});
  return all;
}

/// Spacings that divide the box: 595, 1750 and 3861 particles, and 12103. Quadratic elements need even numbers of cells.
std::vector<std::string> spacings(const Way& way, bool long_run) {
  if (way.id == "quadratic") return {"0.5", "0.25"};
  std::vector<std::string> all{"0.5", "0.3333333333333333", "0.25"};
  if (long_run) all.emplace_back("0.16666666666666666");
  return all;
}

std::string lattice_id(const Way& way, const std::string& spacing) {
  return fmt::format("cantilever-{}-{}", way.id, spacing.substr(2, 2));
}

std::string cloud_id(const Way& way, const Case& of) {
  return fmt::format("cantilever-{}-cloud-{}", way.id, of.cloud);
}

double hourglass_of(const Json& result) {
  const Json& energy = result.at("energy");
  if (!energy.contains("terms") || !energy.at("terms").contains("hourglass")) return 0;
  return energy.at("terms").at("hourglass").get<double>();
}

double error_of(const Json& result) {
  return number(result.at("error"), "displacement");
}

/// The paper's case where the row stands for one.
void add_row(DataTable& table, const std::string& cloud, const std::string& way, const std::string& job,
             const Json& result, const Case* of) {
  const double energy = number(result.at("energy"), "strain");
  const auto printed = [of](double Case::*member) { return of ? Entry(of->*member) : Entry(); };
  table.rows.push_back({cloud, number(result, "particles"), way, error_of(result), printed(&Case::error),
                        energy, printed(&Case::energy), 100 * (energy / of_the_field - 1),
                        100 * (energy / of_the_load - 1), hourglass_of(result), printed(&Case::hourglass),
                        number(result.at("timing"), "cpu_s")});
  table.row_jobs.push_back(job);
  table.jobs.push_back(job);
}

DataTable runs_table(const Results& results, bool long_run) {
  DataTable table{"cantilever-runs",
                  "Cantilever of paper 004: error of u over the field (62)-(64), strain energy against both "
                  "readings of the exact one",
                  {{"cloud"},
                   {"particles", "", 0},
                   {"solved by"},
                   {"error of u", "", 3},
                   {"paper", "", 3},
                   {"strain energy", "J", 5},
                   {"paper's", "J", 4},
                   {"off the field's", "%", 3},
                   {"off the load's work", "%", 3},
                   {"hourglass energy", "J", 3},
                   {"its paper's", "J", 4},
                   {"CPU time", "s", 3}},
                  {}};
  for (const Case& of : cases(long_run))
    for (const Way& way : ways_on_clouds())
      add_row(table, "irregular", way.name, cloud_id(way, of), results.json(cloud_id(way, of)), &of);
  for (const Way& way : ways_on_lattices())
    for (const auto& spacing : spacings(way, long_run))
      add_row(table, "lattice", way.name, lattice_id(way, spacing), results.json(lattice_id(way, spacing)),
              nullptr);
  return table;
}

/// Spacings of a lattice of as many cells as particles, and errors.
OrderFit fit_of(const Results& results, const Way& way, bool long_run) {
  std::vector<Level> levels;
  for (const auto& spacing : spacings(way, long_run))
    levels.push_back({std::stod(spacing), error_of(results.json(lattice_id(way, spacing)))});
  return fit_order(levels);
}

DataTable orders_table(const Results& results, bool long_run) {
  DataTable table{"cantilever-orders",
                  "Order of the error of u on lattices",
                  {{"solved by"}, {"order", "", 3}, {"95 % interval"}, {"levels", "", 0}},
                  {}};
  for (const Way& way : ways_on_lattices()) {
    if (way.id == "quadratic") continue;  // two levels, at the floor that the field leaves
    const OrderFit fit = fit_of(results, way, long_run);
    table.rows.push_back({way.name, fit.order, fmt::format("[{:.2f}, {:.2f}]", fit.lower, fit.upper),
                          static_cast<double>(spacings(way, long_run).size())});
    for (const auto& spacing : spacings(way, long_run)) table.jobs.push_back(lattice_id(way, spacing));
  }
  return table;
}

Figure error_figure(const Results& results, bool long_run) {
  Picture picture{"Error of u over cost", {"CPU time", "s", Scale::log}, {"error of u", "", Scale::log}};
  picture.labels = Labels::legend;
  Figure figure{"cantilever-error", picture, "Cantilever of paper 004 on lattices.", {}};
  for (const Way& way : ways_on_lattices()) {
    Series series{way.name, {}, {}};
    for (const auto& spacing : spacings(way, long_run)) {
      const Json result = results.json(lattice_id(way, spacing));
      series.x.push_back(number(result.at("timing"), "cpu_s"));
      series.y.push_back(error_of(result));
      figure.jobs.push_back(lattice_id(way, spacing));
    }
    figure.picture.series.push_back(series);
  }
  return figure;
}

Section write(const Results& results, bool long_run) {
  Section s;
  s.question = "What does the scheme of paper 004 make of its cantilever?";
  s.tables = {runs_table(results, long_run), orders_table(results, long_run)};
  s.figures = {error_figure(results, long_run)};
  const auto error = [&](const Case& of, const char* way) {
    return error_of(results.json(cloud_id(by_id(ways_on_clouds(), way), of)));
  };
  const Case coarse = cases(long_run).front(), fine = cases(long_run).back();
  s.answer = fmt::format(
      "On irregular clouds of {} and {} particles its error is {:.3g} and {:.3g} with hourglass energy, {:.3g} and "
      "{:.3g} without (paper: {:g} and {:g}); compatible bonds have {:.3g} and {:.3g}.",
      coarse.cloud, fine.cloud, error(coarse, "alpha-1"), error(fine, "alpha-1"), error(coarse, "alpha-0"),
      error(fine, "alpha-0"), coarse.error, fine.error, error(coarse, "compatible"),
      error(fine, "compatible"));
  const Way elements = by_id(ways_on_lattices(), "quadratic");
  const std::string finest = spacings(elements, long_run).back();
  const Json exact = results.json(lattice_id(elements, finest));
  const double energy = number(exact.at("energy"), "strain");
  s.checks = {{"quadratic elements: strain energy",
               "2.80726e-3 J within 1e-4: another program's of that order", fmt::format("{:.6g} J", energy),
               pass_if(std::abs(energy / 2.80726e-3 - 1) <= 1e-4), lattice_id(elements, finest)},
              {"quadratic elements: error of u over the field of plane stress",
               "0.002544 within 1e-6: the field is not that of the body",
               fmt::format("{:.6f}", error_of(exact)), pass_if(std::abs(error_of(exact) - 0.002544) <= 1e-6),
               lattice_id(elements, finest), CheckKind::regression}};
  s.notes = {
      "The field (62)-(64) solves plane stress and not the block: exact answers are 0.0025 off it. The paper's exact energy, 2.77284e-3 J, is half of the work of the end load and leaves out that of the displaced end; the field has 2.805728e-3 J.",
      "The paper's clouds are not printed: ours of 286, 695, 2609 and (long reports) 14250 have a lattice on the surface and Lloyd's relaxation of random points inside, supports of the 30 nearest."};
  return s;
}

}  // namespace

/// The cantilever of paper 004 at the paper's numbers of particles and on lattices, with what its field and its energy are off by.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  SectionPlan plan{509, "cantilever-004", "Cantilever of paper 004", {}, [long_run](const Results& results) {
                     return write(results, long_run);
                   }};
  const auto add = [&](const std::string& id, const std::string& file, const std::string& extra,
                       std::vector<std::string> set, std::vector<std::string> inputs) {
    Job job{id, {"run", file, "--out", "{out}", "--set", extra}, std::move(inputs)};
    for (const auto& one : set) job.arguments.insert(job.arguments.end(), {"--set", one});
    plan.jobs.push_back(std::move(job));
  };
  const std::string lattice = "verification/scenes/cantilever.toml",
                    irregular = "verification/scenes/irregular-cantilever.toml";
  for (const Way& way : ways_on_lattices())
    for (const auto& spacing : spacings(way, long_run))
      add(lattice_id(way, spacing), lattice, "body.spacing=" + spacing, way.set, {lattice});
  for (const Case& of : cases(long_run))
    for (const Way& way : ways_on_clouds()) {
      const std::string cloud = "verification/scenes/clouds/cantilever-" + of.cloud + ".csv";
      std::vector<std::string> set = way.set;
      // factors of its tangent take 9 GB and 260 s, as supports of 30 neighbours tie each particle to some 500
      if (of.cloud == "14250") set.emplace_back("implicit.solver=iterative");
      add(cloud_id(way, of), irregular, "body.file=" + cloud, std::move(set), {irregular, cloud});
    }
  plan.least = Extent::full;
  return plan;
}

}  // namespace plumb::reports::sections::cantilever_004
