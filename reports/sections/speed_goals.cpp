#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::speed_goals {
namespace {

using Json = nlohmann::ordered_json;

/// One figure that the project set itself, and what this report's run found.
struct Goal {
  std::string what, unit;
  double particles, goal, found;
  bool at_least;
  std::string job;
  bool met() const { return at_least ? found >= goal : found <= goal; }
};

/// The row of a case on so many threads.
const Json& row_of(const Json& result, std::string_view name, int threads) {
  for (const auto& row : result.at("rows"))
    if (row.at("case") == name && row.at("threads") == threads) return row;
  throw MissingResult(fmt::format("the bench has no row for {} on {} threads", name, threads));
}

/// Million updates per CPU second of one core.
Goal speed_of(const Results& results, const std::string& job, const std::string& name,
              const std::string& what, double goal) {
  const Json result = results.json(job);
  const Json& row = row_of(result, name, 1);
  return {what,
          "10⁶ updates per CPU s",
          row.at("n").get<double>(),
          goal,
          1e-6 * row.at("updates_per_cpu_s").get<double>(),
          true,
          job};
}

std::vector<Goal> goals_of(const Results& results) {
  std::vector<Goal> goals{
      speed_of(results, "goals-block", "adjoint-verlet-3d", "adjoint force, Verlet, lattice", 25),
      speed_of(results, "goals-million", "adjoint-verlet-3d", "the same", 15),
      speed_of(results, "goals-block", "paper-3d",
               "the paper's scheme: symmetrised, JST, RK3, lattice; each stage", 12),
      speed_of(results, "goals-block", "adjoint-verlet-3d-jittered",
               "adjoint force, Verlet, jittered cloud with a row for each particle", 3.5),
      speed_of(results, "goals-plate", "paper-2d", "2D, the paper's scheme, lattice; each stage", 30)};
  const Json million = results.json("goals-million");
  const Json &one = row_of(million, "adjoint-verlet-3d", 1), &two = row_of(million, "adjoint-verlet-3d", 2);
  const double n = one.at("n").get<double>();
  goals.push_back({"adjoint force, Verlet, lattice: two threads against one", "times as fast", n, 1.8,
                   two.at("updates_per_wall_s").get<double>() / one.at("updates_per_wall_s").get<double>(),
                   true, "goals-million"});
  goals.push_back({"memory of the same", "bytes per particle", n, 250,
                   one.at("bytes_per_particle").get<double>(), false, "goals-million"});
  goals.push_back(
      {"set-up of the same", "CPU s", n, 2, one.at("setup_cpu_s").get<double>(), false, "goals-million"});
  return goals;
}

DataTable table_of(const std::vector<Goal>& goals) {
  DataTable table{"speed-goals",
                  "Goals and what this run found",
                  {{"what"}, {"unit"}, {"particles", "", 0}, {"goal"}, {"found", "", 3}, {"met"}},
                  {},
                  {},
                  {},
                  {}};
  for (const Goal& g : goals) {
    table.rows.push_back({g.what, g.unit, g.particles,
                          fmt::format("{} {:g}", g.at_least ? "at least" : "at most", g.goal), g.found,
                          std::string(g.met() ? "yes" : "no")});
    table.row_jobs.push_back(g.job);
  }
  return table;
}

/// What may stop a figure: the limits of the machine in the same call, and how much of them is used.
DataTable limits_of(const Json& million) {
  DataTable table{"speed-limits",
                  "Limits of the machine in the call with 10⁶ particles, and the share of them in use",
                  {{"threads", "", 0},
                   {"fused multiply-adds", "10⁹/s", 3},
                   {"share in use", "", 2},
                   {"triad", "GB/s", 3},
                   {"share in use", "", 2},
                   {"triad against one core", "", 3}},
                  {},
                  {"goals-million"},
                  {},
                  {}};
  for (const auto& m : million.at("machine").at("by_threads")) {
    const Json& row = row_of(million, "adjoint-verlet-3d", m.at("threads").get<int>());
    table.rows.push_back({m.at("threads").get<double>(), m.at("fma_gflops").get<double>(),
                          row.at("fraction_of_fma").get<double>(), m.at("triad_gbs").get<double>(),
                          row.at("fraction_of_triad").get<double>(), m.at("triad_speed_up").get<double>()});
  }
  return table;
}

Section write(const Results& results) {
  const auto goals = goals_of(results);
  const auto met = std::count_if(goals.begin(), goals.end(), [](const Goal& g) { return g.met(); });
  Section s;
  s.question = "Is it as fast as it was meant to be?";
  s.answer = fmt::format("{} of {} speeds that this project set itself as goals were reached in this run.",
                         met, goals.size());
  s.tables = {table_of(goals), limits_of(results.json("goals-million"))};
  s.notes = {
      "Whole steps in 3D with 26 neighbours (h = 0.9 spacings), neo-Hookean, double precision: boundaries "
      "and time step control are in it. These are timings, not checks: other programs on the machine "
      "make them worse, most of all that of two threads, which needs both cores at the same moment."};
  return s;
}

}  // namespace

/// The speeds that the project set itself, as measured by this report.
SectionPlan planned(Extent) {
  const auto bench = [](const std::string& id, const std::string& cases, const std::string& n,
                        const std::string& cores) {
    return Job{id,
               {"bench", "--case", cases, "--n", n, "--cores", cores, "--repeats", "12", "--seconds", "0.15"},
               {},
               true};
  };
  return {905,
          "speed-goals",
          "Speed: the goals of this project",
          {bench("goals-block", "adjoint-verlet-3d,paper-3d,adjoint-verlet-3d-jittered", "64000", "1"),
           bench("goals-plate", "paper-2d", "40000", "1"),
           bench("goals-million", "adjoint-verlet-3d", "1000000", "1,2")},
          write,
          Extent::full};
}

}  // namespace plumb::reports::sections::speed_goals
