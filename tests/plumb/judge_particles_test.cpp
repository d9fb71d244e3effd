// `plumb judge --particles`: what another program wrote of its points, with the mistakes that such programs
// make.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>

#include "lib/core/error.hpp"
#include "lib/input/point_file.hpp"
#include "lib/output/hdf5_image.hpp"
#include "mms/exact_fields.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using test::run_shell;
using ForeignField = std::function<Vec<2>(const Vec<2>& X, double h)>;

const Elastic elastic{17e6, 0.495, 1100};
constexpr double instant = 0.002;

const mms::ExactFields<2>& plate() {
  static const auto fields = mms::exact_fields<2>("swinging-plate", {}, elastic, LawChoice("neo-hookean"));
  return fields;
}
Vec<2> exact(const Vec<2>& X, double t = instant) {
  return plate().motion(X, t).displacement;
}
/// What a discretisation adds: a smooth error that is no multiple of the solution.
Vec<2> wiggle(const Vec<2>& X) {
  return {std::sin(2 * X[0]) * X[1], std::cos(X[0] + X[1])};
}

/// Files level_0.csv .. of the plate on [0, 2]^2 with n = 5, 10, 20, 40 cells an edge, cell layout.
struct Files {
  test::TemporaryFolder folder;
  explicit Files(const ForeignField& u, const std::string& more = "", int first = 5) {
    for (int level = 0; level < 4; ++level) {
      const int n = first << level;
      std::ofstream file(folder / ("level_" + std::to_string(level) + ".csv"));
      file << std::setprecision(17) << "x [m],y [m],ux [m],uy [m]" << (more.empty() ? "" : ",vx,vy") << '\n';
      const double h = 2.0 / n;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const Vec<2> X((i + 0.5) * h, (j + 0.5) * h), at = u(X, h);
          file << X[0] << ',' << X[1] << ',' << at[0] << ',' << at[1];
          if (!more.empty()) {
            const Vec<2> v = plate().motion(X, instant + std::stod(more)).velocity;
            file << ',' << v[0] << ',' << v[1];
          }
          file << '\n';
        }
    }
  }
};

test::Outcome judge(const Files& files, const std::string& options = "--expect 2") {
  return run_shell("cd '" + files.folder.path().string() +
                   "' && " PLUMB_EXECUTABLE
                   " judge --particles level_0.csv level_1.csv level_2.csv level_3.csv --solution "
                   "swinging-plate --time 0.002 " +
                   options);
}

std::string causes(const test::Outcome& outcome) {
  std::string all;
  const auto result = nlohmann::json::parse(outcome.out);
  for (const auto& cause : result["causes"]) all += cause.get<std::string>() + '\n';
  return all;
}

TEST(JudgeParticles, AConvergingCodePasses) {
  const Files files([](const Vec<2>& X, double h) { return Vec<2>(exact(X) + 1e-3 * h * h * wiggle(X)); },
                    "0");
  const auto outcome = judge(files, "--error l2,linf --expect 2 --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.error;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["status"], "pass");
  EXPECT_TRUE(result["causes"].empty());
  EXPECT_EQ(causes(judge(files, "--json -")), "");  // nothing declared, nothing wrong
  ASSERT_EQ(result["levels"].size(), 4u);
  for (int level = 0; level < 4; ++level) {
    const auto& row = result["levels"][level];
    const double h = 0.4 / (1 << level);
    EXPECT_NEAR(row["h"].get<double>(), h, 1e-9);
    EXPECT_NEAR(row["volume"].get<double>(), 4, 1e-9);  // of Voronoi cells
    double sum = 0;                                     // the midpoint rule for the error that was put in
    const int n = 5 << level;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) sum += h * h * wiggle(Vec<2>((i + 0.5) * h, (j + 0.5) * h)).squaredNorm();
    EXPECT_NEAR(row["l2"].get<double>(), 1e-3 * h * h * std::sqrt(sum), 1e-12);
    EXPECT_NEAR(row["velocity_l2"].get<double>(), 0, 1e-9);
    EXPECT_NEAR(std::pow(row["l2_inside"].get<double>(), 2) + std::pow(row["l2_boundary"].get<double>(), 2),
                std::pow(row["l2"].get<double>(), 2), 1e-15);
  }
}

// The same numbers in HDF5, one data set for a quantity and one for a vector.
TEST(JudgeParticles, Hdf5IsJudgedAsTablesAre) {
  const Files files([](const Vec<2>& X, double h) { return Vec<2>(exact(X) + 1e-3 * h * h * wiggle(X)); });
  std::string list;
  for (int level = 0; level < 4; ++level) {
    const std::string name = "level_" + std::to_string(level);
    const PointFile points = read_points((files.folder / (name + ".csv")).string());
    std::vector<double> x, y;
    for (std::size_t k = 0; k < points.count; ++k) {
      x.push_back(points.positions[3 * k]);
      y.push_back(points.positions[3 * k + 1]);
    }
    const Hdf5Image image;
    image.write("x [m]", x);
    image.write("y [m]", y);
    image.write("displacement", points.find({"u"})->values, 2);
    std::ofstream(files.folder / (name + ".h5"), std::ios::binary) << image.bytes();
    list += " " + name + ".h5";
  }
  const auto outcome =
      run_shell("cd '" + files.folder.path().string() + "' && " PLUMB_EXECUTABLE " judge --particles" + list +
                " --solution swinging-plate --time 0.002 --expect 2 --json -");
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  const auto of_tables = nlohmann::json::parse(judge(files, "--expect 2 --json -").out);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["fits"], of_tables["fits"]);
}

TEST(JudgeParticles, AWrongTimeLevelIsNamed) {
  const Files files(
      [](const Vec<2>& X, double h) { return Vec<2>(exact(X, instant + 4e-4) + 1e-3 * h * h * wiggle(X)); },
      "4e-4");
  const auto outcome = judge(files, "--expect 2 --json -");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(causes(outcome).find("It is the exact displacement of 0.000"), 0u) << causes(outcome);
  EXPECT_NE(causes(outcome).find("s later: a wrong time level"), std::string::npos) << causes(outcome);
}

TEST(JudgeParticles, ASlipOfUnitsIsNamed) {
  const Files files(
      [](const Vec<2>& X, double h) { return Vec<2>(1000 * (exact(X) + 1e-3 * h * h * wiggle(X))); });
  EXPECT_EQ(causes(judge(files, "--expect 2 --json -")).find("wrong time level"), std::string::npos);
  EXPECT_NE(causes(judge(files, "--expect 2 --json -")).find("a power of ten: a slip of units"),
            std::string::npos);
}

/// What is said of the exact displacement times a factor: a slip of units within 0.01 of a power of ten.
TEST(JudgeParticles, AFactorHasTheCauseThatItsSizeSuggests) {
  struct Factor {
    double factor;
    const char* cause;
  };
  const char *units = "a power of ten: a slip of units", *sign = ": a wrong sign",
             *other = "an amplitude, a modulus or a load is off by a factor";
  for (const Factor& row : {Factor{std::pow(10, 2.0095), units},
                            {std::pow(10, 2.0105), other},
                            {std::pow(10, 1.9905), units},
                            {std::pow(10, 1.9895), other},
                            {1e-3, units},
                            {2, other},
                            {-2, sign},
                            {-1, sign}}) {
    const Files files([&](const Vec<2>& X, double h) {
      return Vec<2>(row.factor * (exact(X) + 1e-7 * h * h * wiggle(X)));
    });
    const auto said = causes(judge(files, "--expect 2 --json -"));
    for (const char* cause : {units, sign, other})
      EXPECT_EQ(said.find(cause) != std::string::npos, cause == row.cause) << row.factor << ": " << said;
  }
}

/// Stresses of 4 and of 9 numbers, row by row, with a constant added: its norm over the plate. What has
/// another number of components is no tensor.
TEST(JudgeParticles, StressesOfEveryFormHaveTheNormThatWasPutIn) {
  for (const int side : {2, 3, 1}) {
    const test::TemporaryFolder folder;
    std::string call = "cd '" + folder.path().string() + "' && " PLUMB_EXECUTABLE " judge --particles";
    for (int n = 5; n <= 40; n *= 2) {
      const std::string name = "level_" + std::to_string(n) + ".csv";
      call += " " + name;
      std::ofstream file(folder / name);
      file << std::setprecision(17) << "x,y,ux,uy";
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
          file << (side == 1 ? ",P1,P2,P3" : ",P" + std::to_string(i + 1) + std::to_string(j + 1));
      file << '\n';
      const double h = 2.0 / n;
      for (int k = 0; k < n * n; ++k) {
        const Vec<2> X((k / n + 0.5) * h, (k % n + 0.5) * h), u = exact(X) + 1e-3 * h * h * wiggle(X);
        const Mat<2> P = plate().first_piola(X, instant);
        file << X[0] << ',' << X[1] << ',' << u[0] << ',' << u[1];
        if (side == 1) file << ",1,2,3";
        for (int i = 0; side > 1 && i < side; ++i)
          for (int j = 0; j < side; ++j)
            file << ',' << (i < 2 && j < 2 ? P(i, j) + 100 * (1 + 2 * i + j) : 7e9);
        file << '\n';
      }
    }
    const auto outcome = run_shell(call + " --solution swinging-plate --time 0.002 --expect 2 --json -");
    const auto level = nlohmann::json::parse(outcome.out)["levels"][0];
    EXPECT_EQ(level.contains("stress_l2"), side > 1) << side;
    if (side == 1) continue;
    const double added = 100 * std::sqrt(1.0 + 4 + 9 + 16);
    EXPECT_NEAR(level["stress_l2"].get<double>(), added * std::sqrt(4.0), 1e-6 * added) << side;
  }
}

TEST(JudgeParticles, ExchangedComponentsAreNamed) {
  const Files files([](const Vec<2>& X, double) { return Vec<2>(exact(X).reverse()); });
  EXPECT_NE(causes(judge(files, "--expect 2 --json -")).find("components are exchanged"), std::string::npos);
}

// First order in the row along the edges, second order elsewhere: the orders of both parts say so.
TEST(JudgeParticles, AnErrorAtTheBoundaryIsNamed) {
  const Files files(
      [](const Vec<2>& X, double h) {
        const double edge = std::min({X[0], X[1], 2 - X[0], 2 - X[1]});
        return Vec<2>(exact(X) + (1e-4 * h * h + (edge < h ? 0.1 * h : 0)) * wiggle(X));
      },
      "", 10);
  const auto text = causes(judge(files, "--error l2 --expect 2 --json -"));
  EXPECT_NE(text.find("look at boundary values and supports"), std::string::npos) << text;
  EXPECT_NE(text.find("l2_inside 2.0"), std::string::npos) << text;
}

// The load of another law: the error stalls inside, and that is said.
TEST(JudgeParticles, AWrongLoadIsOfTheInside) {
  const Files files([](const Vec<2>& X, double h) {
    const double bump = X[0] * (2 - X[0]) * X[1] * (2 - X[1]);
    return Vec<2>(exact(X) + (1e-4 * bump + 1e-3 * h * h) * wiggle(X));
  });
  const auto outcome = judge(files, "--expect 2 --json -");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(causes(outcome).find("look at the load, the law and its constants inside"), std::string::npos)
      << causes(outcome);
}

TEST(JudgeParticles, RunsOfOneLevelAreTakenTogether) {
  const Files files([](const Vec<2>& X, double h) { return Vec<2>(exact(X) + 1e-3 * h * h * wiggle(X)); });
  const auto outcome =
      run_shell("cd '" + files.folder.path().string() +
                "' && " PLUMB_EXECUTABLE
                " judge --particles level_0.csv level_1.csv level_1.csv level_2.csv level_3.csv --solution "
                "swinging-plate --time '2 ms' --expect 2 --json -");
  const auto rows = nlohmann::json::parse(outcome.out)["fits"][0]["rows"];
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[1]["runs"], 2);
}

TEST(JudgeParticles, OwnFramesAreJudgedToo) {
  const test::TemporaryFolder folder;
  const std::string in = folder.path().string();
  std::ofstream(folder / "wave.toml") << R"([scene]
name = "plate"
dimension = 2
end_time = "0.2 ms"
[body]
shape = "box"
size = [1, 1]
spacing = 0.1
[material]
model = "neo-hookean"
young = "17 MPa"
poisson = 0.3
density = 1100
[initial]
velocity = ["0", "0"]
[output]
every = "0.1 ms"
vtk = true
)";
  ASSERT_EQ(run_shell(PLUMB_EXECUTABLE " run " + in + "/wave.toml --out " + in + "/out --quiet").code, 0);
  // a body at rest is the travelling wave without amplitude
  const auto outcome = run_shell(PLUMB_EXECUTABLE " judge --particles " + in +
                                 "/out/particles_000002.vtp --solution travelling-wave --set "
                                 "parameters.amplitude=0 --time '0.2 ms' --json -");
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_NEAR(result["levels"][0]["h"].get<double>(), 0.1, 1e-6);
  EXPECT_EQ(result["levels"][0]["n"], 121);
  EXPECT_LT(result["levels"][0]["l2"].get<double>(), 1e-12);
  EXPECT_EQ(result["status"], "too-few-levels");
}

}  // namespace
}  // namespace plumb
