#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/checks.hpp"
#include "reports/modes.hpp"
#include "reports/results.hpp"
#include "reports/section.hpp"

namespace plumb::reports::sections::spectrum {
namespace {

using Json = nlohmann::ordered_json;
const char* const cube = "verification/scenes/free_cube.toml";

Entry entry(const Json& row, const std::string& key) {
  const Json value = row.value(key, Json());
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  return value.get<double>();
}

/// What a key of a scene or of the result is called in a table.
std::string in_words(std::string key) {
  const auto dot = key.find('.');
  if (dot != std::string::npos) key.erase(0, dot + 1);
  if (key == "lowest_nonrigid") return "lowest not rigid";
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

/// The body could not be built; the row has no numbers but says why.
bool is_refused(const Json& row) {
  return row.contains("status") && text(row, "status").starts_with("refused");
}

DataTable table_of(const Json& rows, const std::string& id, const std::string& title, const std::string& job,
                   const std::vector<std::string>& swept) {
  DataTable table{id, title, {}, {}, {job}, {}};
  std::vector<Column> measured = {{"rigid", "", 0},
                                  {"near_zero_not_rigid", "", 0},
                                  {"spurious_below_smooth", "", 0},
                                  {"lowest_nonrigid"},
                                  {"lowest_smooth"},
                                  {"largest"},
                                  {"stable_cfl"},
                                  {"complex_pairs", "", 0},
                                  {"negative", "", 0},
                                  {"growth_rate"}};
  if (std::ranges::any_of(rows, is_refused)) measured.push_back({"status"});
  for (const auto& key : swept) table.columns.push_back({key});
  table.columns.insert(table.columns.end(), measured.begin(), measured.end());
  for (const auto& row : rows) {
    std::vector<Entry> line;
    for (const auto& column : table.columns) line.push_back(entry(row, column.name));
    table.rows.push_back(std::move(line));
  }
  for (auto& column : table.columns) column.name = in_words(column.name);
  return table;
}

/// "at beta = 0.9, 1.2": those for which every body of the scheme can be built and none has a mode of nearly
/// no energy that is not rigid; or "at no beta".
std::string betas_without_soft_modes(const Json& rows, const std::string& gradient) {
  std::map<double, bool> soft;
  for (const auto& row : rows)
    if (text(row, "method.gradient") == gradient)
      soft[std::stod(text(row, "method.beta"))] |=
          is_refused(row) || !(number(row, "near_zero_not_rigid") == 0);  // not known: not free of them
  std::string list;
  for (const auto& [beta, some] : soft)
    if (!some) list += fmt::format("{}{:g}", list.empty() ? "" : ", ", beta);
  return list.empty() ? "at no beta" : "at beta = " + list;
}

/// The mode of least energy of one body.
Figure worst_mode(const Results& results, const std::string& job, const std::string& scheme) {
  const Json result = results.json(job);
  const Json& mode = result.at("worst");
  const double smooth = number(result, "lowest_smooth");
  const std::string caption = fmt::format(
      "The mode that costs least energy: (omega d/c_p)^2 = {:.3g}; {:.0f} % of "
      "the motion between neighbours is not explained by their gradients; {}.",
      number(mode, "value"), 100 * number(mode, "unexplained"),
      std::isnan(smooth) ? "no smooth mode was found" : fmt::format("lowest smooth mode {:.3g}", smooth));
  return {job, mode_picture(mode, scheme), caption, {job}};
}

/// What the scheme sees of a wave on the infinite lattice, along its edges and diagonals.
Figure symbol_figure(const Results& results, const std::string& job, const std::string& title,
                     const std::vector<std::string>& directions) {
  const Json rows = results.json(job).at("rows");
  Picture picture{title, {"theta along each axis"}, {"gradient seen / exact"}};
  picture.labels = Labels::legend;
  for (const char* gradient : {"standard", "improved"})
    for (const auto& direction : directions)
      picture.series.push_back(series_of(rows, {{"method.gradient", gradient}, {"direction", direction}},
                                         "theta", "gradient", std::string(gradient) + ", " + direction,
                                         Style::lines));
  return {
      job, std::move(picture), "A plane wave on the infinite lattice: THEORY (9.4). beta = 0.9, W1.", {job}};
}

Section write(const Results& results) {
  Section s;
  s.question = "What do the eigenvalues of the linearised equations of motion say?";
  struct Known {
    const char *job, *name;
    double growth;
  };
  for (const Known& known : {Known{"cube-no-jst", "without JST", 0.088},
                             {"cube-jst-64", "with eta4 = 1/64", 0.030},
                             {"cube-jst-8", "with eta4 = 1/8", 0.0043}})
    s.checks.push_back(as(CheckKind::regression,
                          number_check(fmt::format("growth of the symmetrised form, {} [c_p/d]", known.name),
                                       number(results.json(known.job), "growth_rate"), known.growth, 0.02,
                                       "the known values have two digits")));
  const double growth = number(results.json("cube-no-jst"), "growth_rate");
  const Json adjoint = results.json("cube-adjoint");
  s.checks.push_back(bound_check("adjoint form: asymmetry of the operator", number(adjoint, "asymmetry"),
                                 1e-14, "round-off"));
  s.checks.push_back(bound_check("adjoint form: growth", number(adjoint, "growth_rate"), 1e-12, "round-off"));
  const Json plates = results.json("plate-soft").at("rows"), cubes = results.json("cube-soft").at("rows");
  std::string free;
  for (const auto& [gradient, name] : {std::pair{"compatible", "compatible bonds"},
                                       {"improved", "the improved gradient"},
                                       {"standard", "the standard one"}})
    free +=
        fmt::format("{}{} {} in 2D and {} in 3D", free.empty() ? "" : "; ", name,
                    betas_without_soft_modes(plates, gradient), betas_without_soft_modes(cubes, gradient));
  s.answer = fmt::format(
      "The paper's symmetrised force lets a free cube grow by exp({:.3g} t c_p/d) "
      "whatever the time step; the adjoint force has no growth. On lattices and "
      "jittered clouds alike, no mode but the rigid ones costs nearly no energy with {}.",
      growth, free);
  s.figures = {worst_mode(results, "worst-plate-standard", "standard F, beta = 1.2, lattice"),
               worst_mode(results, "worst-plate-improved", "improved F, beta = 1.2, jitter 0.2"),
               worst_mode(results, "worst-plate-compatible", "compatible F, beta = 1.2, jitter 0.2"),
               worst_mode(results, "worst-cube-compatible", "compatible F, cube, beta = 1.2, jitter 0.2"),
               symbol_figure(results, "symbol-2d", "square lattice", {"10", "11"}),
               symbol_figure(results, "symbol-3d", "cubic lattice", {"100", "110", "111"})};
  s.tables = {
      table_of(results.json("plate-modes").at("rows"), "plate-modes",
               "Free plate of 10 x 10 particles, nu = 0.3: modes of nearly no energy", "plate-modes",
               {"method.momentum", "method.pair", "method.beta", "method.gradient"}),
      table_of(results.json("plate-soft").at("rows"), "plate-soft",
               "Free plate of 11 x 11 particles on its surface, adjoint force, nu = 0.3", "plate-soft",
               {"body.jitter", "method.pair", "method.beta", "method.gradient"}),
      table_of(results.json("cube-soft").at("rows"), "cube-soft",
               "Free cube of 5^3 particles on its surface, adjoint force, nu = 0.3", "cube-soft",
               {"body.jitter", "method.beta", "method.gradient"}),
      table_of(results.json("compatible-growth").at("rows"), "compatible-growth",
               "Compatible bonds, free plate on its surface: modes as it is refined", "compatible-growth",
               {"body.jitter", "method.beta", "body.spacing"}),
      table_of(results.json("compatible-start").at("rows"), "compatible-start",
               "Compatible bonds at beta = 1.5, free plate of 11 x 11: start table and kernel",
               "compatible-start", {"body.jitter", "compatible.start", "method.kernel"}),
      table_of(results.json("compatible-energy").at("rows"), "compatible-energy",
               "Compatible bonds with hourglass energy, free plate of 11 x 11", "compatible-energy",
               {"body.jitter", "method.beta", "hourglass.alpha"}),
      table_of(results.json("cube-forms").at("rows"), "cube-forms", "Free cube of 4^3 particles, nu = 0.495",
               "cube-forms", {"method.momentum", "method.pair", "method.gradient"})};
  s.notes = {
      "Eigenvalues are (omega d/c_p)^2, rates are in c_p/d. A mode is spurious if more than half of the "
      "motion between neighbours is not explained by their deformation gradients; near-zero: spurious, and "
      "below a tenth of the lowest smooth mode."};
  return s;
}

}  // namespace

/// Spectrum of the linearised operator.
SectionPlan planned(Extent) {
  const auto job = [](const std::string& id, const std::string& scene, std::vector<std::string> more) {
    std::vector<std::string> arguments{"spectrum", scene};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Job{id, arguments, {scene}};
  };
  const std::string plate = "verification/scenes/free_plate.toml",
                    betas = "method.beta=0.6,0.75,0.9,1.05,1.2,1.35,1.5",
                    gradients = "method.gradient=standard,improved,compatible";
  return {
      720,
      "spectrum",
      "Spectrum of the linearised operator",
      {job("cube-no-jst", cube, {}), job("cube-jst-64", cube, {"--set", "jst.eta4=0.015625"}),
       job("cube-jst-8", cube, {"--set", "jst.eta4=0.125"}),
       job("cube-adjoint", cube, {"--set", "method.momentum=adjoint"}),
       job("cube-forms", cube,
           {"--over", "method.momentum=symmetrised,adjoint", "--over", "method.pair=W0,W1", "--over",
            "method.gradient=standard,improved"}),
       job("plate-modes", plate,
           {"--over", "method.momentum=symmetrised,adjoint", "--over", "method.pair=W0,W1", "--over",
            "method.beta=0.6,0.9,1.2,1.5", "--over", "method.gradient=standard,improved"}),
       job("plate-soft", plate,
           {"--set", "body.layout=node", "--over", "body.jitter=0,0.2", "--over", "method.pair=W0,W1",
            "--over", betas, "--over", gradients}),
       job("cube-soft", cube,
           {"--set", "body.layout=node", "--set", "method.momentum=adjoint", "--set", "material.poisson=0.3",
            "--over", "body.jitter=0,0.2", "--over", betas, "--over", gradients}),
       job("compatible-growth", plate,
           {"--set", "body.layout=node", "--set", "method.gradient=compatible", "--over", "body.jitter=0,0.2",
            "--over", "method.beta=0.9,1.2,1.5", "--over", "body.spacing=0.1,0.05"}),
       job("compatible-start", plate,
           {"--set", "body.layout=node", "--set", "method.gradient=compatible", "--set", "method.beta=1.5",
            "--over", "body.jitter=0,0.2", "--over", "compatible.start=standard,improved", "--over",
            "method.kernel=cubic,quadratic,wendland-c2,quintic"}),
       job("compatible-energy", plate,
           {"--set", "body.layout=node", "--set", "method.gradient=compatible", "--over", "body.jitter=0,0.2",
            "--over", "method.beta=0.9,1.2,1.5", "--over", "hourglass.alpha=0,0.1,0.5,2"}),
       job("worst-plate-standard", plate, {"--set", "method.beta=1.2", "--set", "method.gradient=standard"}),
       job("worst-plate-improved", plate,
           {"--set", "method.beta=1.2", "--set", "body.layout=node", "--set", "body.jitter=0.2"}),
       job("worst-plate-compatible", plate,
           {"--set", "method.beta=1.2", "--set", "body.layout=node", "--set", "body.jitter=0.2", "--set",
            "method.gradient=compatible"}),
       job("worst-cube-compatible", cube,
           {"--set", "method.beta=1.2", "--set", "body.layout=node", "--set", "body.jitter=0.2", "--set",
            "method.gradient=compatible", "--set", "method.momentum=adjoint", "--set",
            "material.poisson=0.3"}),
       job("symbol-2d", plate, {"--symbol", "40", "--over", "method.gradient=standard,improved"}),
       job("symbol-3d", cube, {"--symbol", "40", "--over", "method.gradient=standard,improved"})},
      write};
}

}  // namespace plumb::reports::sections::spectrum
