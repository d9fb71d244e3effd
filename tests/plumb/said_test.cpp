// What every command says is what it said: JSON, tables and text of small calls beside those that are kept in
// tests/plumb/said. A change that is meant is written there by
//   PLUMB_WRITE_SAID=1 tests_plumb --gtest_filter='*Said*'
// and read before it is kept. This is regression, not verification: it says that a number has changed, not
// which one is right.
#include <gtest/gtest.h>

#include <fstream>

#include "places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/said.hpp"

namespace plumb::said_test {
namespace {

using nlohmann::json;
using test::run_plumb;

const std::string tree = PLUMBLINE_SOURCE_DIR "/verification/";
const std::string place = PLUMBLINE_SOURCE_DIR "/tests/plumb/said/";

struct Call {
  std::string name, arguments;          ///< "@" is verification/, "{}" a folder with the files below
  std::vector<std::string> files = {};  ///< that the call leaves in {}/out
  bool csv = false;
};

void PrintTo(const Call& call, std::ostream* out) {
  *out << call.name;
}

const std::string plate = R"toml([scene]
name = "plate"
dimension = 2
end_time = "4 ms"
[body]
size = [0.6, 0.4]
origin = [0.1, -0.2]
spacing = 0.1
layout = "node"
[material]
model = "neo-hookean"
young = "17 MPa"
poisson = 0.4
density = 1100
)toml";
const std::string output = R"toml(
[output]
every = "2 ms"
vtk = false
series = true
[[output.probe]]
name = "corner"
at = [0.7, 0.2]
)toml";

/// Scenes that name as many parts as fit together, so that each is held by some number.
const std::vector<std::pair<std::string, std::string>> scenes{{"loaded", plate + R"toml([method]
gradient = "improved"
momentum = "adjoint"
integrator = "verlet"
[jst]
eta2 = 0.1
eta4 = 0.015625
[hourglass]
alpha = 0.7
[damping]
rate = 20
[load]
gravity = ["3 m/s^2", "-9.81 m/s^2"]
ramp = "1 ms"
[[boundary]]
face = "x-"
kind = "clamped"
[[boundary]]
face = "x+"
kind = "traction"
traction = ["20 kPa", "1e6*t"]
[[boundary]]
face = "y+"
kind = "pressure"
pressure = "5 kPa"
)toml" + "[output]\nbudget = true\n" + output.substr(output.find("every"))},
                                                              {"moved", plate + R"toml([method]
gradient = "standard"
momentum = "symmetrised"
integrator = "rk3"
pair = "W0"
wave_speed = "stretch"
[[boundary]]
face = "x-"
kind = "roller"
[[boundary]]
face = "x+"
kind = "displacement"
displacement = ["0.02*sin(300*t)", "0"]
[initial]
velocity = ["0", "5*X"]
)toml" + output},
                                                              {"compatible", plate + R"toml([method]
gradient = "compatible"
momentum = "adjoint"
integrator = "verlet"
[initial]
velocity = ["-20*Y", "20*X"]
)toml" + output},
                                                              {"mixed", plate + R"toml([method]
scheme = "mixed"
[load]
gravity = ["3 m/s^2", "-9.81 m/s^2"]
[[boundary]]
face = "x-"
kind = "clamped"
[[boundary]]
face = "x+"
kind = "traction"
traction = ["20 kPa", "1e6*t"]
)toml" + output},
                                                              {"balance", plate + R"toml([method]
scheme = "implicit"
[load]
gravity = ["3 m/s^2", "-9.81 m/s^2"]
[[boundary]]
face = "x-"
kind = "clamped"
[[boundary]]
face = "y+"
kind = "pressure"
pressure = "50 kPa"
)toml" + output}};

const std::vector<Call> calls{
    {"run_loaded", "run {}/loaded.toml --out {}/out", {"series.csv", "budget.csv"}, true},
    {"run_loaded_irregular",
     "run {}/loaded.toml --out {}/out --set body.jitter=0.2 --set material.model=mooney-rivlin",
     {"series.csv"}},
    {"run_moved", "run {}/moved.toml --out {}/out", {"series.csv"}, true},
    {"run_moved_mirror",
     "run {}/moved.toml --out {}/out --set body.layout=mirror --set method.kernel=quintic",
     {"series.csv"}},
    {"run_projection",
     "run @scenes/spinning-plate-projection.toml --out {}/out --set body.particles=[5,5] --set "
     "scene.max_steps=20 --set output.vtk=false",
     {"series.csv"}},
    {"run_compatible", "run {}/compatible.toml --out {}/out --set body.jitter=0.2", {"series.csv"}},
    {"run_mixed", "run {}/mixed.toml --out {}/out", {"series.csv"}, true},
    {"run_mixed_irregular", "run {}/mixed.toml --out {}/out --set body.jitter=0.1", {"series.csv"}},
    {"run_balance", "run {}/balance.toml --out {}/out", {"series.csv"}, true},
    {"run_column",
     "run @scenes/bending-column.toml --out {}/out --set body.particles=[3,3,18] --set scene.max_steps=12 "
     "--set output.vtk=false --set output.every=0.2ms",
     {"series.csv"},
     true},
    {"run_twist",
     "run @scenes/twisting-column-105-compatible.toml --out {}/out --set body.particles=[3,3,13] --set "
     "scene.max_steps=5 --set output.vtk=false",
     {"series.csv"}},
    {"run_ring",
     "run @scenes/spinning-ring.toml --out {}/out --set body.spacing=0.2 --set scene.max_steps=5 --set "
     "output.vtk=false",
     {"series.csv"}},
    {"explain_loaded", "explain {}/loaded.toml"},
    {"explain_moved", "explain {}/moved.toml"},
    {"explain_compatible", "explain {}/compatible.toml --set body.jitter=0.2"},
    {"explain_mixed", "explain {}/mixed.toml"},
    {"explain_balance", "explain {}/balance.toml"},
    {"mms",
     "mms @studies/swinging_plate.toml --set study.spacings=[0.5,0.4,0.25,0.2] --set study.periods=0.2",
     {},
     true},
    {"mms_finite_strain",
     "mms @studies/swinging_plate_finite_strain.toml --set study.spacings=[0.5,0.4,0.25] --set "
     "study.periods=0.1"},
    {"mms_vortex",
     "mms @studies/generalized_vortex.toml --set study.spacings=[0.25,0.125] --set study.periods=0.02"},
    {"mms_cube",
     "mms @studies/trigonometric_cube.toml --set study.spacings=[0.5,0.25] --set study.periods=0.05"},
    {"mms_column",
     "mms @studies/stretched_column.toml --set study.spacings=[0.5,0.25] --set study.periods=0.05"},
    {"mms_schemes",
     "mms @studies/schemes_plate.toml --set study.spacings=[0.5,0.25] --set study.periods=0.05"},
    {"mms_list", "mms --list"},
    {"mms_check_plate", "mms --check swinging-plate --points 10"},
    {"mms_check_cube", "mms --check trigonometric-cube --points 10"},
    {"mms_temporal",
     "mms @studies/time_step_plate.toml --temporal --set study.periods=0.02 --set "
     "study.spacings=[0.5] --set study.parameters.amplitude=0.01",
     {},
     true},
    {"static", "static @studies/static_plate.toml --set study.spacings=[0.5,0.4,0.25,0.2]", {}, true},
    {"static_compatible",
     "static @studies/static_plate.toml --set study.spacings=[0.5,0.4,0.25] --set "
     "method.gradient=compatible --set body.jitter=0.1"},
    {"operators", "operators @studies/operators.toml --set study.spacings=[0.125,0.1,0.0625,0.05]", {}, true},
    {"oned_kernels", "oned kernels --at 0.1", {}, true},
    {"oned_kernels_edge", "oned kernels --at 0"},
    {"oned_gradient", "oned gradient --n 12 --field sin:5 --jitter 0.2", {}, true},
    {"oned_gradient_radii", "oned gradient --n 8 --field 'X*sin(3*X)' --radius-over-dx 1.8,4", {}, true},
    {"oned_correction", "oned correction --points 5"},
    {"oned_function", "oned function --n 6 --field X^2 --kernel cubic,quintic"},
    {"oned_study", "oned study --n 20,40,80,160 --field poly:1,0,0,1"},
    {"oned_response", "oned response"},
    {"oned_account", "oned account"},
    {"spectrum", "spectrum @scenes/free_plate.toml", {}, true},
    {"spectrum_damped", "spectrum {}/loaded.toml"},
    {"spectrum_over", "spectrum @scenes/free_plate.toml --over method.beta=0.9,1.2"},
    {"spectrum_symbol", "spectrum @scenes/free_plate.toml --symbol 4", {}, true},
    {"spectrum_symbol_3d", "spectrum @scenes/free_cube.toml --symbol 2"},
    {"extrapolate_four", "extrapolate --spacings 0.8,0.4,0.2,0.1 --values 1.61,1.16,1.04,1.01"},
    {"extrapolate_noisy",
     "extrapolate --spacings 0.8,0.4,0.2,0.1,0.05 --values 1.61,1.16,1.06,1.01,1.012 --order 2"},
    {"extrapolate_reference",
     "extrapolate --spacings 0.4,0.2,0.1,0.05 --values "
     "1.16,1.04,1.01,1.0025 --reference 1e-9,1.0 --order 2"},
    {"judge", "judge {}/errors.csv --expect 2"},
    {"judge_limit", "judge {}/errors.csv --limit unknown"},
    {"judge_values", "judge {}/runs.csv --h d --error l2,max --expect 2,1"},
    {"material_sheet", "material @material/sheet.toml --steps 4", {}, true},
    {"material_copper", "material @material/copper-cycle.toml --steps 4", {}, true},
    {"material_rubber", "material @material/rubber-shear.toml --steps 4"},
    {"verdicts", "verdicts"},
    {"help_run", "run --help"},
    {"help_spectrum", "spectrum --help"}};

class Said : public testing::TestWithParam<Call> {
 protected:
  void SetUp() override {
    for (const auto& [name, text] : scenes) std::ofstream(folder / (name + ".toml")) << text;
    std::ofstream(folder / "errors.csv") << "0.1,1e-2\n0.05,2.6e-3\n0.025,6.3e-4\n0.0125,1.56e-4\n";
    std::ofstream(folder / "runs.csv")
        << "d,l2,max\n0.1,1e-2,3e-2\n0.1,1.2e-2,3.1e-2\n0.05,2.6e-3,1.5e-2\n0.05,2.4e-3,1.6e-2\n"
           "0.025,6.3e-4,7e-3\n0.025,6.6e-4,8e-3\n0.0125,1.5e-4,3.8e-3\n0.0125,1.7e-4,3.7e-3\n";
  }
  std::string arguments() const {
    std::string call = GetParam().arguments;
    for (auto at = call.find("{}"); at != std::string::npos; at = call.find("{}"))
      call.replace(at, 2, folder.path().string());
    if (const auto at = call.find('@'); at != std::string::npos) call.replace(at, 1, tree);
    return call;
  }
  /// Times, memory and the build are those of the day; the rest must stay.
  bool is_of_the_day(const std::string& line) const {
    static const std::regex day(
        R"((_s|_rss|wall|cpu|timing\.\w+|plumbline|version|command|commit|provenance\S*|threads|memory\S*|bytes\w*|seconds|step_time_ratio) = |)"
        R"(provenance|timing|memory|measured|bytes|\bk?B$|\bMB$|CPU|computing|It will take|time a step|asked for by|plumb 0\.)");
    return std::regex_search(line, day) || line.find(folder.path().string()) != std::string::npos ||
           line.find(tree) != std::string::npos;
  }
  void add(std::vector<std::string>& all, const std::string& heading,
           const std::vector<std::string>& lines) const {
    all.push_back("== " + heading);
    for (const auto& line : test::without_times(lines))
      if (!is_of_the_day(line)) all.push_back(test::rounded(line));
  }

  test::TemporaryFolder folder;
};

TEST_P(Said, IsWhatItWas) {
  const Call& call = GetParam();
  const std::string js = (folder / "said.json").string(), csv = (folder / "said.csv").string();
  const bool help = call.arguments.find("--help") != std::string::npos;
  const auto outcome =
      run_plumb(arguments() + (help ? "" : " --threads 1 --json " + js) + (call.csv ? " --csv " + csv : ""));
  std::vector<std::string> now, document;
  now.push_back("exit code " + std::to_string(outcome.code));
  if (!help) {
    test::append_lines(json::parse(test::content_of(js)), "", document);
    add(now, "json", document);
  }
  add(now, "text", test::lines_of(outcome.out));
  add(now, "warnings", test::lines_of(outcome.error));
  if (call.csv) add(now, "csv", test::lines_of(test::content_of(csv)));
  for (const auto& file : call.files) add(now, file, test::lines_of(test::content_of(folder / "out" / file)));
  const std::string kept = place + call.name + ".txt";
  if (std::getenv("PLUMB_WRITE_SAID")) {
    std::ofstream out(kept);
    for (const auto& line : now) out << line << '\n';
  }
  // 1e-5: other compilers and other orders of sums change the sixth digit of small differences, a slip
  // changes the first ones. 1e-6: what is zero but for round-off, of energies and forces up to 1e5.
  EXPECT_EQ(test::differences(now, test::lines_of(test::content_of(kept)), 1e-5, 1e-6), "")
      << arguments() << "\n(if this is meant: PLUMB_WRITE_SAID=1 writes it anew)";
}

INSTANTIATE_TEST_SUITE_P(Calls, Said, testing::ValuesIn(calls),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace plumb::said_test
