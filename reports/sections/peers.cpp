#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/assets.hpp"
#include "reports/page/page.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::peers {
namespace {

using Json = nlohmann::ordered_json;

/// One measured speed, of another code or of this one.
struct Measured {
  std::string code, scheme;
  std::string shown;  ///< short name for the picture
  int dimension = 3;
  double neighbours = 0, particles = 0, speed = 0;  ///< 10^6 updates per CPU second
};

std::vector<Measured> others(const Json& peers) {
  std::vector<Measured> all;
  for (const auto& row : peers.at("rows"))
    all.push_back({text(row, "code") + ", " + text(row, "case"), text(row, "scheme"), text(row, "short"),
                   row.at("dimension").get<int>(), number(row, "neighbours"), number(row, "n"),
                   number(row, "speed")});
  return all;
}

/// The cases of `plumb bench` that are compared: scheme, short name, neighbours.
struct Scheme {
  std::string scheme, shown;
  double neighbours;
};
const std::map<std::string, Scheme> cases{
    {"adjoint-verlet-3d", {"TLSPH neo-Hookean, adjoint, Verlet, lattice", "Plumbline, adjoint", 26}},
    {"paper-3d",
     {"TLSPH neo-Hookean, symmetrised, JST, RK3 (three updates a step), lattice",
      "Plumbline, the paper's scheme", 26}},
    {"adjoint-verlet-2d", {"TLSPH neo-Hookean, adjoint, Verlet, lattice", "Plumbline, adjoint", 8}}};

std::vector<Measured> ours(const Json& bench) {
  std::vector<Measured> all;
  for (const auto& row : bench.at("rows"))
    if (const auto found = cases.find(text(row, "case")); found != cases.end())
      all.push_back({"Plumbline, this report", found->second.scheme, found->second.shown,
                     row.at("dimension").get<int>(), found->second.neighbours, number(row, "n"),
                     1e-6 * number(row, "updates_per_cpu_s")});
  if (all.empty()) throw MissingResult("the bench has no rows for the comparison");
  return all;
}

/// Speeds in 3D over the number of particles, a line for each code and scheme.
Figure picture_of(const std::vector<Measured>& all) {
  Picture picture{
      "Speed on one core, 3D", {"particles", "", Scale::log}, {"updates", "10⁶ per CPU s", Scale::log}};
  picture.labels = Labels::legend;
  picture.height = 560;
  for (const auto& m : all) {
    if (m.dimension != 3) continue;
    const std::string name = fmt::format("{}, {:g} neighbours", m.shown, m.neighbours);
    auto found = std::find_if(picture.series.begin(), picture.series.end(),
                              [&](const Series& series) { return series.label == name; });
    if (found == picture.series.end()) {
      picture.series.push_back({name, {}, {}});
      found = picture.series.end() - 1;
    }
    found->x.push_back(m.particles);
    found->y.push_back(m.speed);
  }
  return {"peers",
          picture,
          "Ours: a run of this report; the others: measured as the table says.",
          {"bench-peers"}};
}

DataTable table_of(const std::vector<Measured>& all, const std::string& title) {
  DataTable table{"peers-speeds",
                  title,
                  {{"code, case"},
                   {"scheme"},
                   {"dimension", "", 0},
                   {"neighbours", "", 0},
                   {"particles", "", 0},
                   {"updates", "10⁶ per CPU s", 2}},
                  {},
                  {"bench-peers"}};
  for (const auto& m : all)
    table.rows.push_back(
        {m.code, m.scheme, static_cast<double>(m.dimension), m.neighbours, m.particles, m.speed});
  return table;
}

/// The fastest of the list in 3D with at most that many neighbours and at least that many particles.
const Measured* fastest(const std::vector<Measured>& all, double most_neighbours, double least_particles) {
  const Measured* best = nullptr;
  for (const auto& m : all)
    if (m.dimension == 3 && m.neighbours <= most_neighbours && m.particles >= least_particles &&
        (!best || m.speed > best->speed))
      best = &m;
  return best;
}

Section write(const Results& results) {
  const Json peers = Json::parse(assets::peers_json);
  const auto mine = ours(results.json("bench-peers")), theirs = others(peers);
  Section s;
  s.question = "How fast are other codes for solids with particles?";
  const Measured *best = fastest(mine, 26, 4e4), *other = fastest(theirs, 60, 4e4);
  if (!best || !other) throw MissingResult("no speeds to compare");
  s.answer = fmt::format(
      "At {:.0f} particles in 3D and {:g} neighbours this code does {} million "
      "updates per CPU second; the fastest other one in the list does {} at {:.0f} "
      "particles and {:g} neighbours ({}). Counted in pairs this is {} times as much.",
      best->particles, best->neighbours, number_text(best->speed, 2), number_text(other->speed, 2),
      other->particles, other->neighbours, other->code,
      number_text(best->speed * best->neighbours / (other->speed * other->neighbours), 2));
  auto all = mine;
  all.insert(all.end(), theirs.begin(), theirs.end());
  s.figures = {picture_of(all)};
  s.tables = {table_of(all, "Speeds")};
  s.notes = {"The other codes were measured " + text(peers, "measured") +
                 ". Conditions of all rows: " + text(peers, "conditions") + ".",
             "Scheme and neighbours stand beside each speed because an update is not the same work in every "
             "row. Timings of this report depend on what else the "
             "machine did meanwhile."};
  return s;
}

}  // namespace

/// Speeds of other codes beside ours.
SectionPlan planned(Extent) {
  return {920,
          "peers",
          "Speed of other codes",
          {{"bench-peers",
            {"bench", "--case", "adjoint-verlet-3d,paper-3d,adjoint-verlet-2d", "--n", "6000,48000",
             "--cores", "1", "--repeats", "3", "--seconds", "0.1"},
            {},
            true}},
          write};
}

}  // namespace plumb::reports::sections::peers
