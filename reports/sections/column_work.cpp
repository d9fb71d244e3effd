#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/named.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::column_work {
namespace {

using Json = nlohmann::ordered_json;

const std::string file = "verification/scenes/bending-column.toml";

struct Scheme {
  std::string id, name;
  std::vector<std::string> set;
};
const std::vector<Scheme> schemes{
    {"adjoint",
     "adjoint, Verlet, no JST",
     {"method.momentum=adjoint", "method.integrator=verlet", "jst.eta4=0"}},
    {"paper", "symmetrised, RK3, JST", {"method.momentum=symmetrised", "method.integrator=rk3"}}};

std::string id_of(const Scheme& scheme, int cells) {
  return fmt::format("column-work-{}-{}", scheme.id, cells);
}

/// Nodes on the faces, an even number of cells across, so that a node is at the middle of the top.
Job job_of(const Scheme& scheme, int cells) {
  Job job{id_of(scheme, cells),
          {"run", file, "--out", "{out}", "--set", "output.vtk=false", "--set", "body.layout=node", "--set",
           fmt::format("body.particles=[{0},{0},{1}]", cells + 1, 6 * cells + 1), "--set",
           "scene.end_time=0.1", "--set", "method.cfl=0.5"},
          {file}};
  for (const auto& entry : scheme.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

std::vector<double> tip_of(const Json& run) {
  if (text(run, "status") != "completed") throw MissingResult("a run of the column did not complete");
  return run.at("probes").at("tip").at("displacement").get<std::vector<double>>();
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Errors of the tip against CPU time for one scheme, coarse to fine, against the given reference.
Series errors(const Results& results, const Scheme& scheme, const std::vector<int>& cells,
              const std::vector<double>& reference) {
  Series series{scheme.name, {}, {}};
  for (const int n : cells) {
    const Json run = results.json(id_of(scheme, n));
    series.x.push_back(number(run.at("timing"), "cpu_s"));
    series.y.push_back(distance(tip_of(run), reference));
  }
  return series;
}

Section write(const Results& results, const std::vector<int>& cells, int finest) {
  Section s;
  s.question = "What does a given accuracy of the bending column cost?";
  const auto first = tip_of(results.json(id_of(by_id(schemes, "adjoint"), finest)));
  const auto second = tip_of(results.json(id_of(by_id(schemes, "paper"), finest)));
  Picture picture{"Error of the tip at 0.1 s over CPU time",
                  {"CPU time", "s", Scale::log},
                  {"|u − reference|", "m", Scale::log}};
  DataTable table{"column-work",
                  "Tip of the column at 0.1 s",
                  {{"scheme"},
                   {"cells across", "", 0},
                   {"CPU time", "s", 3},
                   {"error, adjoint reference", "m", 3},
                   {"error, reference of the paper's scheme", "m", 3}},
                  {},
                  {},
                  {}};
  std::vector<std::string> jobs;
  for (const auto& scheme : schemes) {
    const Series one = errors(results, scheme, cells, first), other = errors(results, scheme, cells, second);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      table.rows.push_back({scheme.name, static_cast<double>(cells[k]), one.x[k], one.y[k], other.y[k]});
      table.jobs.push_back(id_of(scheme, cells[k]));
      jobs.push_back(id_of(scheme, cells[k]));
    }
    picture.series.push_back(one);
  }
  const double apart = distance(first, second);
  const Series a = by_label(picture.series, by_id(schemes, "adjoint").name),
               b = by_label(picture.series, by_id(schemes, "paper").name);
  s.answer = fmt::format(
      "At {} cells across the adjoint force with Verlet is {:.2g} "
      "m off in {:.2g} s, the paper's scheme {:.2g} m in {:.2g} s.",
      cells.back(), a.y.back(), a.x.back(), b.y.back(), b.x.back());
  s.figures = {{"column-work", picture, "Node layout, W1, improved F, β = 0.9, α = 0.5.", jobs}};
  s.tables = {table};
  s.notes = {
      fmt::format("There is no exact solution. The reference is the adjoint run with {} cells across, which "
                  "favours its own "
                  "scheme: with a reference of the same scheme an order p shows as up to log2(2^p + 1). The "
                  "table gives the "
                  "errors against the paper's scheme at that size too; the two references are {:.2g} m "
                  "apart, and smaller "
                  "errors than that say nothing.",
                  finest, apart)};
  s.checks.push_back({"the references of the two schemes agree better than the coarsest runs",
                      fmt::format("below {:.2g} m", std::min(a.y.front(), b.y.front())),
                      fmt::format("{:.2g} m", apart), pass_if(apart < std::min(a.y.front(), b.y.front()))});
  return s;
}

}  // namespace

/// Error against CPU time for the bending column of section 5.3 of paper 000.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const std::vector<int> cells = long_run ? std::vector<int>{4, 6, 8, 12, 16} : std::vector<int>{4, 6, 8};
  const int finest = long_run ? 24 : 12;
  SectionPlan plan{
      420, "column-work", "Bending column: error against cost", {}, [cells, finest](const Results& r) {
        return write(r, cells, finest);
      }};
  for (const auto& scheme : schemes) {
    for (const int n : cells) plan.jobs.push_back(job_of(scheme, n));
    plan.jobs.push_back(job_of(scheme, finest));
  }
  return plan;
}

}  // namespace plumb::reports::sections::column_work
