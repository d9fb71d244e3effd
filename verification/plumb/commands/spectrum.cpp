#include "lib/spectrum/spectrum.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/core/dimension.hpp"
#include "lib/core/sentences.hpp"
#include "lib/output/file.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/readers.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/scene/unused_keys.hpp"
#include "reports/modes.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/loaded_output.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/spectrum_output.hpp"
#include "verification/plumb/step_spectrum.hpp"
#include "verification/plumb/symbol_output.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct SpectrumCommand {
  std::string file;
  std::vector<std::string> overrides;
  std::vector<std::string> over;  ///< key=v1,v2,..
  SpectrumOptions options;
  std::string vtk;  ///< folder for the modes; empty: none are written
  int symbol = 0;   ///< points of the lattice symbol; 0: the body's own spectrum
  std::string at;   ///< checkpoint of a loaded state; empty: the reference
};

/// Every combination of the values of --over, as lists of overrides.
std::vector<std::vector<std::string>> combinations(const std::vector<std::string>& over) {
  std::vector<std::vector<std::string>> all{{}};
  for (const auto& entry : over) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos || equals + 1 == entry.size())
      throw InputError("--over \"" + entry + "\" names no values", "a key and its values are expected",
                       "as in --over method.beta=0.9,1.2");
    std::vector<std::vector<std::string>> next;
    for (const auto& value : CLI::detail::split(entry.substr(equals + 1), ','))
      for (auto set : all) {
        set.push_back(entry.substr(0, equals + 1) + value);
        next.push_back(std::move(set));
      }
    all = std::move(next);
  }
  return all;
}

template <int d>
Json analyse(const Scene& scene, const SpectrumOptions& options, const std::string& vtk) {
  const TlsphBody<d> simulation = make_tlsph<d>(scene);
  LinearOperator<d> op(simulation.solid, simulation.supports);
  const Spectrum spectrum = spectrum_of(op, options);
  Json result = spectrum_json(spectrum, scene, op.time_unit(), options.low_modes);
  result["worst"] = worst_mode(spectrum, op);
  if (!vtk.empty()) {
    make_folder(vtk, "--vtk");
    write_modes(spectrum, op, options.low_modes, vtk);
  }
  return result;
}

Json analyse(const Scene& scene, const SpectrumOptions& options, const std::string& vtk = "") {
  if (asked_by_steps(scene)) return step_spectrum(scene, "");
  return plumb::with_dimension(scene.dimension, [&]<int d>() { return analyse<d>(scene, options, vtk); });
}

/// The scene, and no setting of this call that has no part in its modes. With `at` "end" the scene is run.
Scene read_for_modes(const std::string& file, const std::vector<std::string>& overrides,
                     const std::string& at) {
  Scene scene = read_scene(file, overrides);
  if (at == "end" || asked_by_steps(scene)) return scene;
  const TomlValue document = parse_document(read_text(file), file, overrides, scene_alternatives());
  refuse_unused(Section(document, ""), keys_unused_by_spectrum());
  return scene;
}

int tell_steps(const Session& session, const Json& result) {
  session.text() << step_spectrum_text(result) << std::flush;
  session.write_json(result);
  return 0;
}

int run_loaded(const Session& session, const SpectrumCommand& command) {
  if (!command.over.empty() || command.symbol > 0 || !command.vtk.empty() || !session.plot.empty())
    throw InputError("--at beside --over, --symbol, --vtk or --plot", "it lists the vibrations of one state",
                     "leave the others out");
  const Scene scene = read_for_modes(command.file, command.overrides, command.at);
  if (asked_by_steps(scene) && scene.method.scheme != "element")
    return tell_steps(session, step_spectrum(scene, command.at));
  const Json result = loaded_vibrations(scene, command.at, command.options.low_modes);
  session.text() << loaded_text(result) << std::flush;
  session.write_csv(result["modes"]);
  session.write_json(result);
  return 0;
}

/// What the combination sets, as the start of its row.
Json row_of(const std::vector<std::string>& set) {
  Json row = Json::object();
  for (const auto& entry : set) row[entry.substr(0, entry.find('='))] = entry.substr(entry.find('=') + 1);
  return row;
}

/// One row per combination: the set values and the numbers, without the modes.
Json row_of(const std::vector<std::string>& set, const Json& result) {
  Json row = row_of(set);
  for (const auto& [key, value] : result.items())
    if (key != "scene" && key != "modes" && key != "worst") row[key] = value;
  return row;
}

/// The row of a body that cannot be built: the reason, and no numbers.
Json refused_row(const std::vector<std::string>& set, const InputError& error) {
  Json row = row_of(set, spectrum_json(Spectrum{}, Scene{}, 1, 0));
  for (auto& value : row)
    if (value.is_number() || value.is_boolean()) value = nullptr;
  row["status"] = "refused: " + sentences(error.problem(), error.why(), "");
  return row;
}

/// The lattice symbol of every scene, one row per set, direction and wave number.
int run_symbol(const Session& session, const std::vector<std::vector<std::string>>& sets,
               const std::vector<Scene>& scenes, int points) {
  Json rows = Json::array();
  for (std::size_t n = 0; n < scenes.size(); ++n)
    for (const auto& one : symbol_rows(scenes[n], points)) rows.push_back(row_of(sets[n], one));
  session.write_table(rows);
  session.write_json({{"scene", scenes.front().name}, {"rows", rows}});
  return 0;
}

void draw_worst(const Session& session, const Json& result) {
  if (session.plot.empty() || result["worst"].is_null()) return;
  reports::save(
      reports::mode_picture(result["worst"], fmt::format("{}: (omega d/c_p)^2 = {:.4g}, {:.0f} % unexplained",
                                                         result["scene"].get<std::string>(),
                                                         result["worst"]["value"].get<double>(),
                                                         100 * result["worst"]["unexplained"].get<double>())),
      session.plot);
}

/// One row per combination. Bodies that cannot be built are rows too, if some other can.
Json rows_of(const std::vector<std::vector<std::string>>& sets, const std::vector<Scene>& scenes,
             const SpectrumOptions& options, Progress& progress) {
  Json rows = Json::array();
  std::size_t refused = 0;
  for (std::size_t n = 0; n < scenes.size(); ++n) {
    try {
      rows.push_back(row_of(sets[n], analyse(scenes[n], options)));
    } catch (const InputError& error) {
      if (++refused == scenes.size()) throw;
      rows.push_back(refused_row(sets[n], error));
    }
    progress.update(static_cast<double>(n + 1) / static_cast<double>(scenes.size()),
                    fmt::format("{} of {} spectra", n + 1, scenes.size()));
  }
  return rows;
}

/// What a scheme that is asked by its steps does not have.
void refuse_modes(const Session& session, const SpectrumCommand& command) {
  for (const auto& [asked, option] : {std::pair(command.symbol > 0, "--symbol"),
                                      {!command.vtk.empty(), "--vtk"},
                                      {!session.plot.empty(), "--plot"},
                                      {!session.csv.empty(), "--csv"}})
    if (asked)
      throw InputError(fmt::format("{} with this scheme", option),
                       "it is asked by its own steps, which have no modes to show",
                       "leave it out, or use scheme = \"tlsph\"");
}

int run_spectrum(const Session& session, const SpectrumCommand& command) {
  if (!command.at.empty()) return run_loaded(session, command);
  const auto sets = combinations(command.over);
  const bool one_body = command.over.empty() && command.symbol == 0;
  const auto needs_one_body = [&](const std::string& file, const char* option, const char* what) {
    if (!file.empty() && !one_body)
      throw InputError(std::string(option) + what, "with --over and --symbol there are several or none",
                       std::string("leave them out, or leave out ") + option);
  };
  needs_one_body(session.plot, "--plot", " draws the worst mode of one body");
  needs_one_body(command.vtk, "--vtk", " writes the modes of one body");
  if (!command.vtk.empty()) require_folder(command.vtk, "--vtk");
  std::vector<Scene> scenes;
  for (const auto& set : sets) {
    auto overrides = command.overrides;
    overrides.insert(overrides.end(), set.begin(), set.end());
    scenes.push_back(read_for_modes(command.file, overrides, command.at));
  }
  if (asked_by_steps(scenes.front())) refuse_modes(session, command);
  if (command.symbol > 0) return run_symbol(session, sets, scenes, command.symbol);
  Progress progress("spectrum", session.progress());
  if (command.over.empty()) {
    const Json single = analyse(scenes.front(), command.options, command.vtk);
    progress.finish();
    if (asked_by_steps(scenes.front())) return tell_steps(session, single);
    session.text() << spectrum_text(single) << std::flush;
    draw_worst(session, single);
    session.write_csv(single["modes"]);
    session.write_json(single);
  } else {
    const Json rows = rows_of(sets, scenes, command.options, progress);
    progress.finish();
    session.write_table(rows);
    session.write_json({{"scene", scenes.front().name}, {"rows", rows}});
  }
  return 0;
}

}  // namespace

/// `plumb spectrum SCENE.toml`: eigenvalues of the linearised operator.
void add_spectrum(CLI::App& program, Session& session) {
  const auto options = std::make_shared<SpectrumCommand>();
  CLI::App& command = add_command(
      program, session,
      {"spectrum",
       "eigenvalues of the equations of motion about the reference state, or of a scheme's own step",
       "plumb spectrum verification/scenes/free_cube.toml --over method.momentum=symmetrised,adjoint"},
      {.table = true, .plot = true}, [&session, options] { return run_spectrum(session, *options); });
  command.add_option("SCENE", options->file, "the scene file (.toml)")->required()->type_name("FILE");
  command.add_option("--set", options->overrides, "change one value of the scene; may be repeated")
      ->type_name("section.key=value");
  command.add_option("--over", options->over, "several values of one key: one row each")
      ->type_name("section.key=V1,V2,..");
  command.add_option("--modes", options->options.low_modes, "number of low modes to list")
      ->check(CLI::Range(1, 500))
      ->capture_default_str();
  command.add_option("--vtk", options->vtk, "write the modes as particle files for ParaView to DIR")
      ->type_name("DIR");
  command
      .add_option(
          "--at", options->at,
          "frequencies about a loaded state instead: that at the end of the scene, or of a checkpoint.h5")
      ->type_name("end|FILE");
  command
      .add_option("--symbol", options->symbol,
                  "the scheme on the infinite lattice instead, at so many wave numbers in each direction")
      ->check(CLI::Range(1, 10000))
      ->type_name("POINTS");
  command
      .add_option("--dense", options->options.dense_limit,
                  "unknowns up to which all eigenvalues are computed")
      ->check(CLI::Range(3, 20000))
      ->capture_default_str();
}

}  // namespace plumb::app
