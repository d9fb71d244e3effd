#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::compatible_columns {
namespace {

using Json = nlohmann::ordered_json;

/// One column of the paper on nodes, by compatible bonds or by the paper's scheme.
struct Case {
  std::string id, name, cloud, scheme, scene;
  std::vector<std::string> set;
  bool driven = false;  ///< work is done on it: its energy says nothing
  bool wanted = false;  ///< checked: completed, share below 0.15, energy to 1 %
};

struct Scheme {
  std::string id, name;
  std::vector<std::string> set;
};

/// Compatible bonds with the hourglass coefficient that serves smooth cases and with a stiffer one, and the
/// paper's scheme.
std::vector<Scheme> schemes(bool stiff) {
  const std::vector<std::string> own{"method.gradient=compatible", "method.momentum=adjoint",
                                     "method.integrator=verlet", "jst.eta4=0"};
  std::vector<Scheme> all;
  for (const char* alpha : {"2", "8"}) {
    if (alpha == std::string("8") && !stiff) continue;
    all.push_back(
        {std::string("compatible-") + alpha, std::string("compatible, Verlet, hourglass α = ") + alpha, own});
    all.back().set.push_back(std::string("hourglass.alpha=") + alpha);
  }
  all.push_back({"paper", "paper: symmetrised, JST, RK3", {}});
  return all;
}

/// A twist on nodes, lattice and jittered.
void add_twists(std::vector<Case>& all, const std::string& rate, int across, int along) {
  for (const char* jitter : {"0", "0.2"})
    for (const auto& scheme : schemes(rate != "105")) {
      const bool lattice = jitter == std::string("0");
      Case column{fmt::format("columns-twist-{}-{}-{}-{}", rate, across, lattice ? "0" : "2", scheme.id),
                  fmt::format("twist {} rad/s, {} × {} × {}", rate, across, across, along),
                  lattice ? "lattice" : "jitter 0.2",
                  scheme.name,
                  "twisting-column-" + rate,
                  {"body.layout=node", fmt::format("body.particles=[{0},{0},{1}]", across, along),
                   std::string("body.jitter=") + jitter, "method.cfl=0.5"}};
      if (rate == "105") column.set.emplace_back("scene.end_time=0.25");
      column.set.insert(column.set.end(), scheme.set.begin(), scheme.set.end());
      column.wanted = rate == "105" && scheme.id != "paper";
      all.push_back(std::move(column));
    }
}

/// The pulled column at the step of its own scene.
void add_pulls(std::vector<Case>& all, int across, int along) {
  for (const char* nu : {"0.45", "0.495"})
    for (const char* jitter : {"0", "0.2"})
      all.push_back({fmt::format("columns-pull-{}-{}-{}", std::string(nu).substr(2), across,
                                 jitter == std::string("0") ? "0" : "2"),
                     fmt::format("pulled to 533 %, ν = {0}, {1} × {1} × {2}", nu, across, along),
                     jitter == std::string("0") ? "lattice" : "jitter 0.2",
                     "compatible, RK3, hourglass α = 2",
                     "pulling-column-compatible",
                     {fmt::format("body.particles=[{0},{0},{1}]", across, along),
                      std::string("body.jitter=") + jitter, std::string("material.poisson=") + nu},
                     true,
                     true});
}

std::vector<Case> columns(bool long_run) {
  std::vector<Case> all;
  for (const char* rate : {"105", "300", "400"}) add_twists(all, rate, 5, 25);
  if (!long_run) return all;
  add_pulls(all, 5, 25);
  add_pulls(all, 13, 73);
  add_twists(all, "105", 8, 43);
  add_twists(all, "300", 12, 67);
  add_twists(all, "400", 13, 73);
  return all;
}

Job job_of(const Case& column) {
  const std::string file = "verification/scenes/" + column.scene + ".toml";
  Job job{column.id, {"run", file, "--out", "{out}"}, {file}};
  for (const auto& entry : column.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

std::string end_of(const Json& run) {
  std::string status = text(run, "status");
  if (run.at("failure").is_null()) return status;
  return fmt::format("{} ({} = {:.3g})", text(run.at("failure"), "cause"),
                     text(run.at("failure"), "quantity"), number(run.at("failure"), "value"));
}

void check(Section& s, const Case& column, const Json& run) {
  const std::string what = column.name + ", " + column.cloud;
  const bool completed = text(run, "status") == "completed";
  s.checks.push_back({what + ": runs to its end", "completed", end_of(run), pass_if(completed), column.id,
                      CheckKind::book_keeping});
  s.checks.push_back(bound_check(what + ": hourglass share", number(run, "hourglass_share"), 0.15,
                                 "goal: alternating motion is a small part of the strain"));
  if (!column.driven)
    s.checks.push_back(bound_check(what + ": energy change",
                                   std::abs(number(run.at("energy"), "relative_change")), 0.01,
                                   "goal of 1 %: nothing but the time step changes it"));
}

Section write(const Results& results, const std::vector<Case>& all) {
  Section s;
  s.question =
      "What do compatible bonds make of the paper's columns, on lattices and on irregular particles?";
  DataTable table{"compatible-columns",
                  "Columns of the paper on nodes: compatible bonds and the paper's scheme",
                  {{"case"},
                   {"particles"},
                   {"scheme"},
                   {"end"},
                   {"time", "s", 4},
                   {"steps", "", 0},
                   {"energy change", "%", 3},
                   {"hourglass share", "", 3},
                   {"length over that at the start", "", 4},
                   {"CPU time", "s", 3}},
                  {}};
  std::size_t own = 0, completed = 0;
  for (const auto& column : all) {
    const Json run = results.json(column.id);
    const Json& extent = run.at("extent");
    const double length = extent.at("max").at(2).get<double>() - extent.at("min").at(2).get<double>();
    table.rows.push_back({column.name, column.cloud, column.scheme, end_of(run), number(run, "time"),
                          number(run, "steps"),
                          column.driven ? Entry() : Entry(100 * number(run.at("energy"), "relative_change")),
                          number(run, "hourglass_share"), length / 6, number(run.at("timing"), "cpu_s")});
    table.jobs.push_back(column.id);
    if (column.wanted) check(s, column, run);
    if (column.scheme.starts_with("compatible")) {
      ++own;
      completed += text(run, "status") == "completed" ? 1 : 0;
    }
  }
  s.tables = {table};
  s.answer = fmt::format("{} of {} columns by compatible bonds reach their end.", completed, own);
  s.notes = {
      "Both schemes run on the same nodes; the paper's own runs, on cells, are under "
      "Deformed bodies. A run that ends early is listed with the state it ended in."};
  return s;
}

}  // namespace

/// The paper's columns with compatible bonds.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const auto all = columns(long_run);
  SectionPlan plan{
      520, "compatible-columns", "The paper's columns by compatible bonds", {}, [all](const Results& r) {
        return write(r, all);
      }};
  for (const auto& column : all) plan.jobs.push_back(job_of(column));
  return plan;
}

}  // namespace plumb::reports::sections::compatible_columns
