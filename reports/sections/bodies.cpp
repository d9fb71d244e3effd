#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/body.hpp"
#include "reports/body_numbers.hpp"
#include "reports/checks.hpp"
#include "reports/drawn_bodies.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::bodies {
namespace {

using Json = nlohmann::ordered_json;

/// The reduced ones come first.
std::vector<DrawnBody> all_bodies(bool long_run) {
  auto all = reduced_bodies();
  if (long_run)
    for (auto& body : paper_size_bodies()) all.push_back(std::move(body));
  return all;
}

Job job_of(const DrawnBody& body) {
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
ColourScale stress_of(const std::vector<BodyState>& states) {
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
Figure snapshot(const Results& results, const DrawnBody& body, double time) {
  const std::vector<BodyState> states =
      body.moves ? read_states(results.job(body.id).folder, field)
                 : std::vector<BodyState>{last_state(results.csv(body.id, "last.csv"), time, field)};
  const ColourScale quantity = stress_of(states);
  const auto drawn = [&](const BodyState& state) {
    return body_picture(body.name, state, body.view, quantity, body.spacing, states);
  };
  Figure figure{body.id + "-stress",
                drawn(states.back()),
                fmt::format("Surface through the outer particles{}. The colours end where all but one in "
                            "fifty of the values lie "
                            "below; those above have the last colour.",
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
Figure history(const Results& results, const DrawnBody& body) {
  const auto series = results.csv(body.id, "series.csv");
  const auto& time = column(series, "time [s]");
  Picture picture{body.name, {"time t", "s"}, {"energy", "kJ"}};
  if (body.scene == "spinning-plate") {
    picture.y = {"angular momentum left", "%"};
    std::vector<double> percent;
    const auto& L = column(series, "angular momentum z [kg m/s]");
    percent.reserve(L.size());
    for (const double value : L) percent.push_back(100 * value / L.front());
    picture.series.push_back({"L/L₀", time, percent, Style::lines});
    return {body.id + "-angular",
            picture,
            fmt::format("To {:g} s. The paper, at 2 s on its coarsest grid: about 94 %.", time.back()),
            {body.id}};
  }
  const bool plane = series.contains("total energy [J/m]");
  if (plane) picture.y.unit = "kJ/m";
  for (const char* part : {"kinetic", "strain", "total"}) {
    std::vector<double> energy;
    for (const double value : column(series, std::string(part) + (plane ? " energy [J/m]" : " energy [J]")))
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

Section write(const Results& results, const std::vector<DrawnBody>& all) {
  Section s;
  s.question =
      "What do the deformed bodies look like, are they where they should be, and what did they cost?";
  s.tables = {table_of()};
  const auto reduced_ones = reduced_bodies();
  const auto is_reduced = [&](const DrawnBody& body) {
    return std::ranges::any_of(reduced_ones, [&](const DrawnBody& one) { return one.id == body.id; });
  };
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
    reduced += done && is_reduced(body) ? 1 : 0;
    s.checks.push_back(number_of(body, results));
    cpu += number(run.at("timing"), "cpu_s");
  }
  const auto agree = std::ranges::count_if(s.checks, [](const Check& c) { return c.verdict == "pass"; });
  s.answer = fmt::format(
      "{} of {} bodies have the number that theory or an independent solution gives them; {} runs complete, "
      "together in {:.3g} s of CPU time.",
      agree, all.size(), completed, cpu);
  const std::size_t wanted = reduced_ones.size();
  s.checks.push_back(
      as(CheckKind::book_keeping, {"the reduced runs complete", fmt::format("all {}", wanted),
                                   fmt::format("{} of {}", reduced, wanted), pass_if(reduced == wanted)}));
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
SectionPlan planned(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  const auto all = all_bodies(long_run);
  SectionPlan plan{510, "bodies", "Deformed bodies", {}, [all](const Results& r) { return write(r, all); }};
  for (const auto& body : all) plan.jobs.push_back(job_of(body));
  return plan;
}

}  // namespace plumb::reports::sections::bodies
