#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/named.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::mixed_columns {
namespace {

using Json = nlohmann::ordered_json;

/// A column of paper 003 with the value that refinements of schemes tend to.
struct PaperColumn {
  std::string id, name, unit;
  double right, uncertain;
};
const std::vector<PaperColumn> paper_columns{{"tension", "height of the tip at 0.3 s", "m", 5.03743, 1e-5},
                                             {"bending", "x of the tip at 0.45 s", "m", 2.632, 6e-3},
                                             {"twist", "angle of the tip at 0.1 s", "deg", 313.7, 1}};

struct ColumnScheme {
  std::string id, name;
  std::vector<std::string> set;
};
const std::vector<ColumnScheme> column_schemes{
    {"mixed",
     "mixed, upwinding R^T S R",
     {"method.scheme=mixed", "mixed.volumes=equal", "mixed.kinematics=tied", "mixed.upwind=adjoint"}},
    {"jst",
     "adjoint, improved F, JST",
     {"method.scheme=tlsph", "method.gradient=improved", "jst.eta4=0.015625"}},
    {"hourglass", "compatible, hourglass energy", {"method.scheme=tlsph", "hourglass.alpha=2"}},
    {"upwind", "compatible, upwinding R^T S R", {"method.scheme=tlsph", "dissipation.kind=upwind"}}};

std::string id_of(const PaperColumn& column, const ColumnScheme& scheme, int cells) {
  return fmt::format("mixed-columns-{}-{}-{}", column.id, scheme.id, cells);
}

Job job_of(const PaperColumn& column, const ColumnScheme& scheme, int cells) {
  const std::string file = fmt::format("verification/scenes/column-{}.toml", column.id);
  Job job{id_of(column, scheme, cells),
          {"run", file, "--out", "{out}", "--set", "output.vtk=false", "--set", "output.series=false",
           "--set", fmt::format("body.particles=[{0},{1},{0}]", cells + 1, 6 * cells + 1)},
          {file}};
  for (const auto& entry : scheme.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

/// How far the tip is from where it should be; infinite if the run ended early.
double error_of(const PaperColumn& column, const Json& run) {
  if (text(run, "status") != "completed") return std::numeric_limits<double>::infinity();
  const auto u = run.at("probes").at("tip").at("displacement").get<std::vector<double>>();
  const std::vector<double> x{u[0] - 0.5, u[1] + 6, u[2] - 0.5};  // from (-0.5, 6, -0.5) m
  if (column.id == "tension") return std::abs(x[1] - column.right);
  if (column.id == "bending") return std::abs(x[0] - column.right);
  // turned from -135 degrees on, about y
  const double turned = (std::atan2(x[0], x[2]) / std::acos(-1.0) + 0.75) * 180;
  return std::abs(std::remainder(turned - column.right, 360));
}

Section write(const Results& results, const std::vector<int>& cells) {
  Section s;
  s.question = "What does a given accuracy of the columns of paper 003 cost?";
  std::string answer;
  for (const PaperColumn& column : paper_columns) {
    Picture picture{fmt::format("Error of the {}", column.name),
                    {"CPU time", "s", Scale::log},
                    {"|tip − converged|", column.unit, Scale::log}};
    DataTable table{"mixed-columns-" + column.id,
                    fmt::format("Column in {}: {}", column.id, column.name),
                    {{"scheme"},
                     {"cells across", "", 0},
                     {"CPU time", "s", 3},
                     {"error", column.unit, 3},
                     {"energy change", "", 3}},
                    {},
                    {},
                    {}};
    std::vector<std::string> jobs;
    for (const auto& scheme : column_schemes) {
      Series series{scheme.name, {}, {}};
      for (const int n : cells) {
        const Json run = results.json(id_of(column, scheme, n));
        const double cpu = number(run.at("timing"), "cpu_s"), error = error_of(column, run);
        Entry shown;  // nothing: the run ended early
        if (std::isfinite(error)) {
          shown = error;
          series.x.push_back(cpu);
          series.y.push_back(error);
        }
        table.rows.push_back(
            {scheme.name, static_cast<double>(n), cpu, shown, number(run.at("energy"), "relative_change")});
        table.jobs.push_back(id_of(column, scheme, n));
        jobs.push_back(id_of(column, scheme, n));
      }
      picture.series.push_back(series);
    }
    std::string best;
    double least = std::numeric_limits<double>::infinity();
    for (const Series& series : picture.series)
      if (!series.y.empty() && series.y.back() < least) {
        least = series.y.back();
        best = fmt::format("{} {:.2g} {} in {:.2g} s ({})", column.id, least, column.unit, series.x.back(),
                           series.label);
      }
    answer += (answer.empty() ? "" : ", ") + best;
    s.figures.push_back(
        {"mixed-columns-" + column.id, picture,
         fmt::format("Converged: {:g} ± {:g} {}.", column.right, column.uncertain, column.unit), jobs});
    s.tables.push_back(table);
  }
  s.answer = fmt::format("The least errors at {} cells across: {}.", cells.back(), answer);
  s.notes = {
      "The tension is a bar in uniaxial strain, whose tip the scene column-one-dimension has at 5.03743 m. Bending and twist have no exact "
      "solution: their values are the means of what refinements of two schemes tend to, and errors below what stands in the captions say "
      "nothing. No entry for an error: the run ended early."};
  for (const PaperColumn& column : paper_columns) {
    const double coarse = error_of(
                     column, results.json(id_of(column, by_id(column_schemes, "mixed"), cells.front()))),
                 fine = error_of(column,
                                 results.json(id_of(column, by_id(column_schemes, "mixed"), cells.back())));
    s.checks.push_back({fmt::format("the mixed scheme comes nearer with finer particles: {}", column.id),
                        fmt::format("below {:.3g} {}", coarse, column.unit),
                        fmt::format("{:.3g} {}", fine, column.unit), pass_if(fine < coarse)});
  }
  return s;
}

}  // namespace

/// Error against CPU time on the columns of paper 003 for its scheme with the better choices, and for total Lagrangian ones beside it.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const std::vector<int> cells = long_run ? std::vector<int>{4, 6, 8, 12} : std::vector<int>{4, 6};
  SectionPlan plan{
      425, "mixed-columns", "Columns of paper 003: error against cost", {}, [cells](const Results& r) {
        return write(r, cells);
      }};
  for (const auto& column : paper_columns)
    for (const auto& scheme : column_schemes)
      for (const int n : cells) plan.jobs.push_back(job_of(column, scheme, n));
  return plan;
}

}  // namespace plumb::reports::sections::mixed_columns
