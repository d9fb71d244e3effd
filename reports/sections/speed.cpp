#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

Figure picture_of(const Json& rows) {
  std::map<std::string, Series> by_case;
  for (const auto& row : rows) {
    if (row.at("threads") != 1) continue;
    Series& series = by_case[row.at("case").get<std::string>()];
    series.label = row.at("case").get<std::string>();
    series.x.push_back(row.at("n").get<double>());
    series.y.push_back(row.at("updates_per_cpu_s").get<double>() * 1e-6);
  }
  Picture picture{
      "Speed on one core", {"particles", "1", Scale::log}, {"updates per CPU second", "10⁶/s", Scale::log}};
  for (auto& [name, series] : by_case) picture.series.push_back(std::move(series));
  picture.labels = Labels::legend;
  return {"speed",
          std::move(picture),
          "Evaluations of stress and force for one particle, in whole runs with a clamped face and time step "
          "control.",
          {"bench"}};
}

DataTable table_of(const Json& rows) {
  DataTable table{"speed", "Speed of whole runs", {}, {}, {"bench"}, {}};
  table.columns = {{"case"},
                   {"particles", "", 0},
                   {"threads", "", 0},
                   {"per CPU second", "10⁶/s", 3},
                   {"per second", "10⁶/s", 3},
                   {"set-up", "CPU s", 2},
                   {"arrays", "bytes/particle", 0},
                   {"share of FMA limit", "", 2},
                   {"share of triad limit", "", 2}};
  const auto value = [](const Json& row, const char* key, double scale = 1) {
    return Entry(row.at(key).get<double>() * scale);
  };
  for (const auto& row : rows)
    table.rows.push_back({row.at("case").get<std::string>(), value(row, "n"), value(row, "threads"),
                          value(row, "updates_per_cpu_s", 1e-6), value(row, "updates_per_wall_s", 1e-6),
                          value(row, "setup_cpu_s"), value(row, "bytes_per_particle"),
                          value(row, "fraction_of_fma"), value(row, "fraction_of_triad")});
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
  s.figures = {picture_of(rows)};
  s.tables = {table_of(rows)};
  s.notes = {
      "An update is one evaluation of F, stress and force for one particle; a step of RK3 has three. The "
      "share of the FMA "
      "limit counts the operations of the plain sums over all bonds (d + 4 d² for each): the lattice loops "
      "do the same "
      "sums with fewer. The share of the triad limit counts every array of the simulation once per update; "
      "above 1 "
      "they lie in a cache. Timings are never checked: they depend on what else the machine does."};
  return s;
}

}  // namespace

/// Speed of whole runs.
SectionPlan speed(bool long_run) {
  std::vector<std::string> arguments{
      "bench",   "--n",       long_run ? "1000,8000,64000,1000000,4000000" : "1000,8000,64000",
      "--cores", "1,2",       "--repeats",
      "3",       "--seconds", "0.05"};
  return {910, "speed", "Speed", {{"bench", std::move(arguments), {}}}, write};
}

}  // namespace plumb::reports::sections
