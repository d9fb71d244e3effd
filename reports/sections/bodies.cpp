#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/body.hpp"
#include "reports/checks.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections {
namespace {

using Json = nlohmann::ordered_json;

/// A run whose last state is drawn: the particles projected along `depth`, `across` upwards.
struct Body {
  std::string id, name, scene;
  std::vector<std::string> set;
  char along, across, depth;  ///< axes; depth ' ' in 2D
  double size;                ///< spacing [m]
  bool moves = false;         ///< states on the way are drawn too
};

std::vector<Body> short_bodies() {
  return {{"spin", "Spinning plate, 50 × 50, 0.2 s", "spinning-plate", {}, 'x', 'y', ' ', 0.02},
          {"column",
           "Bending column, 5 × 5 × 30, adjoint, 0.45 s",
           "bending-column",
           {"method.momentum=adjoint", "scene.end_time=0.45"},
           'z',
           'y',
           'x',
           0.2,
           true},
          {"pulling",
           "Pulling column, nodes of 6 × 6 × 36 cells, W0, 1.2 s",
           "pulling-column-nu-45",
           {"body.layout=node", "body.particles=[7,7,37]", "method.pair=W0", "method.cfl=0.5",
            "scene.end_time=1.2"},
           'z',
           'y',
           'x',
           0.5},
          {"twisting",
           "Twisting column, 105 rad/s, 7 × 7 × 42, 0.1 s",
           "twisting-column-105",
           {"method.cfl=0.4", "scene.end_time=0.1"},
           'z',
           'y',
           'x',
           0.143,
           true}};
}

/// The sizes and end times of the paper.
std::vector<Body> long_bodies() {
  std::vector<Body> all;
  for (const int n : {50, 100, 200})
    for (const double end : {0.2, 2.0})
      all.push_back({fmt::format("spin-{}-{:g}", n, 10 * end),
                     fmt::format("Spinning plate, {0} × {0}, {1} s", n, end),
                     "spinning-plate",
                     {fmt::format("body.particles=[{0},{0}]", n), fmt::format("scene.end_time={}", end)},
                     'x',
                     'y',
                     ' ',
                     1.0 / n});
  // with the symmetrised force the step collapses from 0.7 s on (claims ledger, 5.2-cube-smooth)
  for (const auto& [momentum, end] : {std::pair("symmetrised", 0.7), {"adjoint", 2.0}})
    all.push_back({fmt::format("cube-50-{}", momentum),
                   fmt::format("Spinning cube, 50³, {}, {} s", momentum, end),
                   "spinning-cube",
                   {"body.particles=[50,50,50]", fmt::format("scene.end_time={}", end),
                    fmt::format("method.momentum={}", momentum)},
                   'x',
                   'y',
                   'z',
                   0.02});
  for (const int n : {10, 20})
    for (const char* momentum : {"symmetrised", "adjoint"})
      all.push_back({fmt::format("column-{}-{}", n, momentum),
                     fmt::format("Bending column, {0} × {0} × {1}, {2}, 0.5 s", n, 6 * n, momentum),
                     "bending-column",
                     {fmt::format("body.particles=[{0},{0},{1}]", n, 6 * n),
                      fmt::format("method.momentum={}", momentum)},
                     'z',
                     'y',
                     'x',
                     1.0 / n});
  // the scene at half its step (cell layout, symmetrised), and the one reading in which the published
  // stretches appear
  const std::vector<std::pair<std::string, std::vector<std::string>>> pulls{
      {"cell", {"method.cfl=0.5"}},
      {"node",
       {"body.layout=node", "body.particles=[13,13,73]", "method.pair=W0", "method.momentum=adjoint",
        "method.cfl=0.5", "jst.eta4=0"}}};
  for (const char* nu : {"45", "495"})
    for (const char* gradient : {"standard", "improved"})
      for (const auto& [reading, set] : pulls) {
        Body body{fmt::format("pulling-{}-{}-{}", nu, gradient, reading),
                  fmt::format("Pulling column, 12 × 12 × 72, ν = 0.{}, {} F, {}", nu, gradient,
                              reading == "cell" ? "cells, symmetrised" : "nodes, W0, adjoint, no JST"),
                  fmt::format("pulling-column-nu-{}", nu),
                  set,
                  'z',
                  'y',
                  'x',
                  0.083};
        body.set.push_back(fmt::format("method.gradient={}", gradient));
        all.push_back(std::move(body));
      }
  for (const char* alpha : {"0.1", "0.4", "0.9"})
    all.push_back({fmt::format("twisting-105-{}", alpha[2]),
                   fmt::format("Twisting column, 105 rad/s, 7 × 7 × 42, α = {}, 0.25 s", alpha),
                   "twisting-column-105",
                   {fmt::format("method.cfl={}", alpha)},
                   'z',
                   'y',
                   'x',
                   0.143});
  all.push_back({"twisting-300",
                 "Twisting column, 300 rad/s, 11 × 11 × 66, 92.1 ms",
                 "twisting-column-300",
                 {},
                 'z',
                 'y',
                 'x',
                 0.09});
  all.push_back({"twisting-400",
                 "Twisting column, 400 rad/s, 12 × 12 × 72, 0.1 s",
                 "twisting-column-400",
                 {"jst.laplacian_factor=1"},
                 'z',
                 'y',
                 'x',
                 0.083});
  all.push_back({"oscillating-20",
                 "Oscillating plate of paper 001, 20 cells across, 2.5 s",
                 "oscillating-plate",
                 {"body.spacing=0.001", "scene.end_time=2.5"},
                 'x',
                 'y',
                 ' ',
                 0.001});
  return all;
}

std::vector<Body> all_bodies(bool long_run) {
  auto all = short_bodies();
  if (long_run)
    for (auto& body : long_bodies()) all.push_back(std::move(body));
  return all;
}

Job job_of(const Body& body) {
  const std::string file = "verification/scenes/" + body.scene + ".toml";
  Job job{body.id,
          {"run", file, "--out", "{out}", "--csv", "{out}/last.csv", "--set",
           fmt::format("output.vtk={}", body.moves)},
          {file}};
  for (const auto& entry : body.set) job.arguments.insert(job.arguments.end(), {"--set", entry});
  return job;
}

const std::vector<double>& column(const std::map<std::string, std::vector<double>>& table,
                                  const std::string& name) {
  const auto found = table.find(name);
  if (found == table.end()) throw MissingResult("a table has no column \"" + name + "\"");
  return found->second;
}

/// Colours from 0 to a round value that all but one in fifty of the numbers stay below.
Quantity stress_of(const std::vector<BodyState>& states) {
  std::vector<double> all;
  for (const auto& state : states) all.insert(all.end(), state.value.begin(), state.value.end());
  std::erase_if(all, [](double value) { return !std::isfinite(value); });
  if (all.empty()) throw MissingResult("a run has no finite stress");
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 49 / 50);
  std::nth_element(all.begin(), at, all.end());
  const double top = std::max(1e-6 * *at, 1e-12), decade = std::pow(10.0, std::floor(std::log10(top)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * decade >= top) return {"von Mises stress", "MPa", 1e-6, 0, digit * decade};
  return {"von Mises stress", "MPa", 1e-6, 0, 10 * decade};
}

constexpr const char* field = "von Mises stress [Pa]";

/// The last state, coloured by the von Mises stress; for a body that moves, states on the way to it.
Figure snapshot(const Results& results, const Body& body, double time) {
  const View view{body.along, body.across, body.depth == ' ' ? 'z' : body.depth};
  const std::vector<BodyState> states =
      body.moves ? read_states(results.job(body.id).folder, field)
                 : std::vector<BodyState>{last_state(results.csv(body.id, "last.csv"), time, field)};
  const Quantity quantity = stress_of(states);
  const auto drawn = [&](const BodyState& state) {
    return body_picture(body.name, state, view, quantity, body.size, states);
  };
  Figure figure{
      body.id + "-stress",
      drawn(states.back()),
      fmt::format("Surface through the outer particles{}. One in fifty values may lie above the end of the "
                  "colours.",
                  body.moves ? "; times from left to right, or with the slider" : ""),
      {body.id}};
  constexpr std::size_t most = 12;
  const std::size_t frames = body.moves ? std::min(most, states.size()) : 0;
  for (std::size_t k = 0; k < frames; ++k) {
    const auto& state = states[frames == 1 ? 0 : k * (states.size() - 1) / (frames - 1)];
    figure.frames.push_back({fmt::format("t = {:.3g} s", state.time), drawn(state)});
  }
  return figure;
}

/// Angular momentum of spins, energies of the others.
Figure history(const Results& results, const Body& body) {
  const auto series = results.csv(body.id, "series.csv");
  const auto& time = column(series, "time [s]");
  Picture picture{body.name, {"time t", "s"}, {"energy", "kJ"}};
  if (body.scene == "spinning-plate") {
    picture.y = {"angular momentum left", "%"};
    std::vector<double> percent;
    const auto& L = column(series, "angular momentum z [kg m/s]");
    for (const double value : L) percent.push_back(100 * value / L.front());
    picture.series.push_back({"L/L₀", time, percent, Style::lines});
    return {
        body.id + "-angular", picture, "The paper: about 94 % left at 2 s on its coarsest grid.", {body.id}};
  }
  for (const char* part : {"kinetic", "strain", "total"}) {
    std::vector<double> energy;
    for (const double value : column(series, std::string(part) + " energy [J]"))
      energy.push_back(1e-3 * value);
    picture.series.push_back({part, time, energy, Style::lines});
  }
  return {body.id + "-history", picture, "Energies of the run above.", {body.id}};
}

DataTable table_of() {
  return {"bodies-runs",
          "Runs",
          {{"case"},
           {"particles", "", 0},
           {"status"},
           {"time", "s", 4},
           {"steps", "", 0},
           {"change of energy", "%", 3},
           {"hourglass share", "", 2},
           {"CPU time", "s", 3}},
          {},
          {},
          {}};
}

Section write(const Results& results, const std::vector<Body>& all) {
  Section s;
  s.question = "What do the deformed bodies look like, and how long did the runs take?";
  s.tables = {table_of()};
  std::size_t completed = 0, reduced = 0;
  double cpu = 0;
  for (const auto& body : all) {
    const Json run = results.json(body.id);
    const bool driven = body.scene.starts_with("pulling");
    s.figures.push_back(snapshot(results, body, number(run, "time")));
    s.figures.push_back(history(results, body));
    s.tables[0].rows.push_back({body.name, number(run, "particles"), text(run, "status"), number(run, "time"),
                                number(run, "steps"),
                                driven ? Entry() : Entry(100 * number(run.at("energy"), "relative_change")),
                                number(run, "hourglass_share"), number(run.at("timing"), "cpu_s")});
    s.tables[0].jobs.push_back(body.id);
    s.tables[0].figures.push_back(body.id + "-stress");
    const bool done = text(run, "status") == "completed";
    completed += done ? 1 : 0;
    reduced += done && s.figures.size() <= 2 * short_bodies().size() ? 1 : 0;  // they come first
    cpu += number(run.at("timing"), "cpu_s");
  }
  const std::size_t wanted = short_bodies().size();
  s.checks.push_back({"the reduced runs complete", fmt::format("all {}", wanted),
                      fmt::format("{} of {}", reduced, wanted), pass_if(reduced == wanted)});
  s.answer = fmt::format("{} of {} runs complete; together they took {:.3g} s of CPU time.", completed,
                         all.size(), cpu);
  s.notes = {
      "Runs in the paper's size are made with ./reports/make --long; their times stand in the table. "
      "Runs that end early are drawn in their last good state.",
      "Paper 001 (its Table 3) states 5270 s on one core for 2.5 s of the oscillating plate with 5118 "
      "particles and its total Lagrangian "
      "scheme, on a machine of its time."};
  return s;
}

}  // namespace

/// The deformed bodies of sections 5.2 to 5.5 of paper 000.
SectionPlan bodies(bool long_run) {
  const auto all = all_bodies(long_run);
  SectionPlan plan{510, "bodies", "Deformed bodies", {}, [all](const Results& r) { return write(r, all); }};
  for (const auto& body : all) plan.jobs.push_back(job_of(body));
  return plan;
}

}  // namespace plumb::reports::sections
