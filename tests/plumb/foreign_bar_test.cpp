// Other people's bars: a finite-element code in 1D as a foreign program, tables and pictures of bars that are judged,
// solutions of a bar as text, and the bar that `plumb new` writes.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mms/exact_fields.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using nlohmann::json;
using test::run_shell;
using test::TemporaryFolder;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

test::Outcome plumb_in(const TemporaryFolder& folder, const std::string& arguments) {
  return run_shell("cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " " + arguments);
}

/// The standing wave of a bar, sin(pi X) cos(pi c t), in its own material.
Vec<1> wave(double X, double t) {
  static const auto fields =
      mms::exact_fields<1>("standing-wave", {}, {17e6, 0.495, 1100}, LawChoice("neo-hookean"));
  return fields.motion(Vec<1>(X), t).displacement;
}

TEST(ForeignBars, ACampaignOfLinearElementsHasTheirOrder) {
  const TemporaryFolder folder;
  // u'' M = -s by linear elements on equal cells, which is exact at the nodes up to the load, that is interpolated
  write(folder / "bar.py", R"py(import csv
rows = list(csv.reader(open("loads.csv")))
names = rows[0]
column = lambda start: [float(r[next(k for k, n in enumerate(names) if n.startswith(start))]) for r in rows[1:]]
X, u, s = column("X"), column("ux"), column("sx")
order = sorted(range(len(X)), key=lambda i: X[i])
X, u, s = [X[i] for i in order], [u[i] for i in order], [s[i] for i in order]
n, h, M = len(X) - 1, X[1] - X[0], 1e6 * 0.7 / (1.3 * 0.4)
found = [u[0]] + [0.0] * (n - 1) + [u[n]]
f = [0.0] + [h * h / M * (s[i - 1] + 4 * s[i] + s[i + 1]) / 6 for i in range(1, n)] + [0.0]
f[1] += u[0]
f[n - 1] += u[n]
diagonal = [2.0] * n
for i in range(2, n):
    diagonal[i] -= 1 / diagonal[i - 1]
    f[i] += f[i - 1] / diagonal[i - 1]
for i in range(n - 1, 0, -1):
    found[i] = (f[i] + (found[i + 1] if i < n - 1 else 0)) / diagonal[i]
with open("result.csv", "w") as out:
    out.write("X [m],ux [m]\n")
    for x, w in zip(X, found):
        out.write("%.17g,%.17g\n" % (x, w))
)py");
  write(folder / "bar.toml", R"([campaign]
name = "a bar of linear elements"
solution = "stretched-column"
dimension = 1
time = "4 ms"
spacings = [0.25, 0.125, 0.0625, 0.03125]
layout = "node"
loads = "loads.csv"
command = "/usr/bin/python3 @here@/bar.py"
result = "result.csv"
[parameters]
stretch = 0.1
period = 0.02
[material]
model = "linear-elastic"
young = "1 MPa"
poisson = 0.3
density = 1000
[expect]
l2 = 2.0
reason = "the load is interpolated linearly"
)");
  const auto outcome = plumb_in(folder, "campaign bar.toml --out out --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.error;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["status"], "pass");
  EXPECT_NEAR(result["fits"][0]["order"].get<double>(), 2, 0.05);
  // half of the load is a mistake that does not fall
  const auto text = test::content_of(folder / "bar.py");
  write(folder / "bar.py", std::string(text).replace(text.find("h * h / M"), 9, "h * h / M / 2"));
  const auto wrong = plumb_in(folder, "campaign bar.toml --out other --json -");
  EXPECT_EQ(wrong.code, 1);
  EXPECT_EQ(json::parse(wrong.out)["status"], "fail");
}

/// A table of a bar has X, ux and F11; another one x and u alone. Both are judged in 1D without being told.
TEST(ForeignBars, TablesOfBarsAreJudged) {
  for (const bool short_names : {false, true}) {
    const TemporaryFolder folder;
    std::string files;
    for (const int n : {10, 20, 40, 80}) {
      std::string text = short_names ? "x,u\n" : "X [m],ux [m],vx [m/s]\n";
      for (int i = 0; i <= n; ++i) {
        const double X = i / static_cast<double>(n), h = 1.0 / n;
        text += fmt::format("{:.17g},{:.17g}", X, wave(X, 0.002)[0] + 1e-2 * h * h * std::cos(2 * X));
        text += short_names ? "\n" : ",0.5\n";
      }
      write(folder / fmt::format("bar_{}.csv", n), text);
      files += fmt::format("bar_{}.csv ", n);
    }
    const auto outcome = plumb_in(
        folder, "judge --particles " + files +
                    "--solution standing-wave --time 0.002 --set material.young=17e6 --set "
                    "material.poisson=0.495 --set material.density=1100 --error l2,linf --expect 2 --json -");
    ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.error;
    const json result = json::parse(outcome.out);
    EXPECT_EQ(result["status"], "pass");
    const json& level = result["levels"][2];
    EXPECT_NEAR(level["h"].get<double>(), 1.0 / 40, 1e-12);
    EXPECT_NEAR(level["volume"].get<double>(), 1, 1e-12);  // Voronoi cells of a bar: halves at its ends
    EXPECT_TRUE(level["estimated_volumes"].get<bool>());
    EXPECT_EQ(level["worst"].size(), 1u);
    EXPECT_NEAR(level["linf"].get<double>(), 1e-2 / 1600, 1e-12);  // at X = 0
    EXPECT_EQ(level.contains("velocity_l2"), !short_names);
    EXPECT_NEAR(result["fits"][1]["order"].get<double>(), 2, 1e-6);
  }
}

/// What Plumbline itself draws of a bar can be judged too: the points of a picture have y = z = 0.
TEST(ForeignBars, APictureOfABarIsJudgedAgainstItsWave) {
  const TemporaryFolder folder;
  std::string files;
  for (const int n : {10, 20, 40, 80}) {
    write(folder / "bar.toml", fmt::format(R"toml([scene]
dimension = 1
end_time = "2 ms"
[body]
size = [1]
particles = [{}]
[material]
model = "linear-elastic"
young = 17e6
poisson = 0.3
density = 1100
[initial]
displacement = ["1e-4*sin(pi*X)"]
[[boundary]]
where = "X < 0.001 || X > 0.999"
kind = "clamped"
[output]
vtk = true
)toml",
                                           n + 1));
    ASSERT_EQ(plumb_in(folder, fmt::format("run bar.toml --quiet --out out_{}", n)).code, 0);
    files += fmt::format("out_{}/last.vtp ", n);
    const auto copied = run_shell(
        fmt::format("cd '{}/out_{}' && cp \"$(ls *.vtp */*.vtp 2>/dev/null | sort | tail -1)\" last.vtp",
                    folder.path().string(), n));
    ASSERT_EQ(copied.code, 0) << copied.error;
  }
  const auto outcome = plumb_in(
      folder,
      "judge --particles " + files +
          "--solution standing-wave --time '2 ms' --set parameters.amplitude=1e-4 --set material.young=17e6 --set "
          "material.poisson=0.3 --set material.density=1100 --set material.model=linear-elastic --expect 2 --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.error;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["status"], "pass");
  EXPECT_EQ(result["levels"][0]["worst"].size(), 1u);
}

TEST(ForeignBars, ASolutionOfABarIsATableAndASource) {
  const TemporaryFolder folder;
  write(folder / "points.csv", "X\n0\n0.3\n1\n");
  const auto table = plumb_in(folder, "mms standing-wave --export csv --at points.csv --time 0.002");
  ASSERT_EQ(table.code, 0) << table.error;
  EXPECT_EQ(table.out.substr(0, table.out.find('\n')),
            "X [m],ux [m],vx [m/s],ax [m/s^2],F11,P11 [Pa],bx [N/m^3],gx [N/kg],sx [N/m^3]");
  EXPECT_EQ(std::count(table.out.begin(), table.out.end(), '\n'), 4);
  const auto source = plumb_in(folder, "mms standing-wave --export python --dimension 1 --out wave.py");
  ASSERT_EQ(source.code, 0) << source.error;
  write(folder / "table.csv", table.out);
  const auto both = run_shell("cd '" + folder.path().string() +
                              "' && /usr/bin/python3 -c 'import csv, wave\n"
                              "for r in list(csv.reader(open(\"table.csv\")))[1:]:\n"
                              "  u, v, a, F, P, b = wave.standing_wave([float(r[0])], 0.002)\n"
                              "  got = [u[0], v[0], a[0], F[0], P[0], b[0]]\n"
                              "  for x, y in zip(got, map(float, r[1:7])):\n"
                              "    assert abs(x - y) <= 1e-9 * (abs(y) + 1e-3), (x, y)'");
  EXPECT_EQ(both.code, 0) << both.error;
}

/// The first lines of the bar say what comes out: the end at S/sqrt(M rho) t, twice the stress at the held end.
TEST(ForeignBars, TheBarThatNewWritesMovesAsItSays) {
  const TemporaryFolder folder;
  ASSERT_EQ(plumb_in(folder, "new bar mine").code, 0);
  const auto outcome =
      plumb_in(folder, "run mine.toml --quiet --json - --out out --set scene.end_time='0.9 ms'");
  ASSERT_EQ(outcome.code, 0) << outcome.error;
  const json early = json::parse(outcome.out);
  EXPECT_NEAR(early["probes"]["end"]["displacement"][0].get<double>(), 0.9e-3, 0.01e-3);
  const auto later = json::parse(plumb_in(folder, "run mine.toml --quiet --json - --out out").out);
  // there the end turns around, at a front that is a few cells wide
  EXPECT_NEAR(later["probes"]["end"]["displacement"][0].get<double>(), 2e-3, 0.05e-3);
  for (const std::string scheme : {"mixed", "updated", "element", "implicit"})
    EXPECT_EQ(plumb_in(folder, "run mine.toml --quiet --out " + scheme + " --set method.scheme=" + scheme +
                                   " --set scene.end_time='0.2 ms'")
                  .code,
              0)
        << scheme;
}

}  // namespace
}  // namespace plumb
