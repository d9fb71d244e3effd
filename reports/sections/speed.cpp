#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::speed {
namespace {

using Json = nlohmann::ordered_json;

/// Cases whose name ends so, one line each.
Figure picture_of(const Json& rows, const std::string& ending, const std::string& id,
                  const std::string& title) {
  std::map<std::string, Series> by_case;
  for (const auto& row : rows) {
    const auto name = row.at("case").get<std::string>();
    if (row.at("threads") != 1 || !name.ends_with(ending)) continue;
    Series& series = by_case[name];
    series.label = name.substr(0, name.size() - ending.size());
    series.x.push_back(row.at("n").get<double>());
    series.y.push_back(1e9 / row.at("updates_per_cpu_s").get<double>());
  }
  Picture picture{title, {"particles", "1", Scale::log}, {"CPU time per update", "ns", Scale::log}};
  for (auto& [name, series] : by_case) picture.series.push_back(std::move(series));
  picture.labels = Labels::legend;
  return {id,
          std::move(picture),
          "One evaluation of F, stress and force for one particle with its share of the integrator, the "
          "boundary and the time step control, on one core. Level lines: the cost grows as N.",
          {"bench"}};
}

Entry value(const Json& row, const char* key, double scale = 1) {
  return Entry(row.at(key).get<double>() * scale);
}

DataTable table_of(const Json& rows) {
  DataTable table{"speed", "Speed of whole runs", {}, {}, {"bench"}, {}};
  table.columns = {{"case"},
                   {"particles", "", 0},
                   {"threads", "", 0},
                   {"per CPU second", "10⁶/s", 3},
                   {"per second", "10⁶/s", 3},
                   {"set-up", "CPU s", 3},
                   {"set-up", "s", 3},
                   {"arrays", "bytes/particle", 0},
                   {"moved", "bytes/update", 0},
                   {"share of FMA limit", "", 2},
                   {"share of triad limit", "", 2}};
  for (const auto& row : rows)
    table.rows.push_back({row.at("case").get<std::string>(), value(row, "n"), value(row, "threads"),
                          value(row, "updates_per_cpu_s", 1e-6), value(row, "updates_per_wall_s", 1e-6),
                          value(row, "setup_cpu_s"), value(row, "setup_wall_s"),
                          value(row, "bytes_per_particle"), value(row, "bytes_per_update"),
                          value(row, "fraction_of_fma"), value(row, "fraction_of_triad")});
  return table;
}

DataTable exponents_of(const Json& result) {
  DataTable table{"speed-exponents",
                  "Cost against the number of particles, N^p on one core",
                  {{"case"}, {"p of a step", "", 3}, {"p of the set-up", "", 3}},
                  {},
                  {"bench"},
                  {}};
  const Json& of_setup = result.at("setup_exponents");
  for (const auto& [name, exponent] : result.at("exponents").items())
    table.rows.push_back({name, exponent.get<double>(), value(of_setup, name.c_str())});
  return table;
}

/// What more cores gain, beside what they gain for a loop without memory and one without arithmetic.
DataTable speed_ups_of(const Json& result) {
  DataTable table{"speed-threads",
                  "Wall time on one core over that on more",
                  {{"what"}, {"particles", "", 0}, {"threads", "", 0}, {"times as fast", "", 3}},
                  {},
                  {"bench"},
                  {}};
  for (const auto& m : result.at("machine").at("by_threads")) {
    if (m.at("threads") == 1) continue;
    table.rows.push_back(
        {"fused multiply-adds on registers", {}, value(m, "threads"), value(m, "fma_speed_up")});
    table.rows.push_back({"triad from memory", {}, value(m, "threads"), value(m, "triad_speed_up")});
  }
  for (const auto& s : result.at("speed_ups"))
    table.rows.push_back(
        {s.at("case").get<std::string>(), value(s, "n"), value(s, "threads"), value(s, "speed_up")});
  return table;
}

DataTable kernels_of(const Json& rows) {
  DataTable table{"speed-kernels",
                  "Loops one by one, 3D, 26 neighbours, one core",
                  {{"loop"}, {"cloud"}, {"particles", "", 0}, {"CPU time", "ns/particle", 3}},
                  {},
                  {"bench-kernels"},
                  {}};
  for (const auto& row : rows)
    table.rows.push_back({row.at("kernel").get<std::string>(), row.at("cloud").get<std::string>(),
                          value(row, "n"), value(row, "ns_per_particle")});
  return table;
}

Section write(const Results& results) {
  const Json result = results.json("bench");
  const Json& rows = result.at("rows");
  double fastest = 0;
  for (const auto& row : rows)
    if (row.at("dimension") == 3) fastest = std::max(fastest, row.at("updates_per_cpu_s").get<double>());
  Section s;
  s.question = "How many particles a second, and how near is that to what the machine can do?";
  s.answer = fmt::format(
      "In 3D up to {:.3g} million particle updates per CPU second on this machine, which does {:.3g} "
      "GFLOP/s in fused multiply-adds and {:.3g} GB/s in the triad.",
      fastest * 1e-6, result.at("machine").at("fma_gflops").get<double>(),
      result.at("machine").at("triad_gbs").get<double>());
  s.figures = {picture_of(rows, "-3d", "speed-3d", "Cost in 3D, lattices"),
               picture_of(rows, "-3d-jittered", "speed-3d-jittered", "Cost in 3D, jittered clouds"),
               picture_of(rows, "-2d", "speed-2d", "Cost in 2D, lattices"),
               picture_of(rows, "-2d-jittered", "speed-2d-jittered", "Cost in 2D, jittered clouds")};
  s.tables = {table_of(rows), exponents_of(result), speed_ups_of(result),
              kernels_of(results.json("bench-kernels").at("rows"))};
  s.notes = {
      "An update is one evaluation of F, stress and force for one particle; a step of RK3 has three. Shares "
      "are those of what as many cores do at the same time. That of the FMA limit counts the operations of "
      "the plain sums over all bonds (d + 4 d² for each): the lattice loops do the same sums with fewer. "
      "That of the triad limit counts the bytes of THEORY (10.8); part of them never leaves the caches. "
      "Small bodies run on one thread: below 4096 places a second one costs more than it brings. Timings "
      "are never checked: they depend on what else the machine does."};
  return s;
}

}  // namespace

/// Speed of whole runs.
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  std::vector<std::string> whole_runs{"bench",     "--all", "--cores",   "1,2",
                                      "--repeats", "2",     "--seconds", "0.02"};
  if (long_run) whole_runs = {"bench", "--full", "--repeats", "2", "--seconds", "0.2"};
  return {910,
          "speed",
          "Speed",
          {{"bench", std::move(whole_runs), {}, true},
           {"bench-kernels", {"bench", "--kernels", "--n", "27000", "--seconds", "0.05"}, {}, true}},
          write,
          Extent::full};
}

}  // namespace plumb::reports::sections::speed
