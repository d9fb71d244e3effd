// Scenes in one dimension: a bar in uniaxial strain, by every scheme, against what is known of it exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>

#include "lib/scene/limits.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb {
namespace {

/// M = lambda + 2 mu = 1.2 E = 3 GPa and rho = 3000 kg/m^3: waves of 1000 m/s. With nu = 0.25 the modulus of uniaxial
/// stress is another one.
constexpr double modulus = 3e9, density = 3000, speed = 1000;

std::string head(int cells, const char* end) {
  return fmt::format(R"([scene]
dimension = 1
end_time = "{}"
[body]
size = ["1 m"]
particles = [{}]
[material]
model = "linear-elastic"
young = "2.5 GPa"
poisson = 0.25
density = 3000
)",
                     end, cells + 1);
}

Scene bar(const std::string& scheme, const std::string& more, int cells = 20, const char* end = "1 ms") {
  return parse_scene(head(cells, end) + "[method]\nscheme = \"" + scheme + "\"\n" + more, "bar.toml");
}

/// The bar after its run.
Simulation<1> after(const Scene& scene) {
  auto simulation = make_simulation<1>(scene).simulation;
  RunRecord record;
  const RunResult result = run<1>(simulation, {}, record);
  EXPECT_TRUE(result.completed()) << scene.method.scheme;
  return simulation;
}

const std::string hangs =
    "[load]\ngravity = [\"-981 m/s^2\"]\n[[boundary]]\nface = \"x+\"\nkind = \"clamped\"\n";
const std::string free_motion = "[initial]\nvelocity = [\"3 + 30*sin(pi*X)\"]\n";
const std::string pulled =
    "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n"
    "[[boundary]]\nface = \"x+\"\nkind = \"traction\"\ntraction = [\"30 MPa\"]\nramp = \"0.3 ms\"\n";

/// A bar that hangs on x+ has the stress rho g X; u = rho g (X^2 - L^2)/(2 M).
TEST(Bars, OneThatHangsHasItsWeightInEveryCrossSection) {
  const double weight = density * 981;  // strains of 1e-3, far above rounding; the law is linear in them
  for (const std::string scheme : {"implicit", "relaxed", "element"}) {
    const std::string more = scheme == "relaxed"   ? "[relaxation]\nresidual = 1e-10\n"
                             : scheme == "element" ? "[element]\nsolve = \"newton\"\n"
                                                   : "";
    auto rest = after(bar(scheme == "relaxed" ? "tlsph" : scheme, more + hangs, 20, "1 s"));
    const Snapshot<1> shown = rest.snapshot();
    for (std::size_t i = 0; i < shown.X.size(); ++i) {
      const double X = shown.X[i][0], exact = weight * (X * X - 1) / (2 * modulus);
      if (scheme == "element") {  // linear elements are exact at the nodes, and each has its middle's stress
        EXPECT_NEAR(shown.u[i][0], exact, 1e-8 * weight / modulus);
        continue;
      }
      // differences over two cells, at an even number of cells: linear stresses are met at every particle, and
      // displacements at every second one from the held end. P = sigma_11 in 1D.
      EXPECT_NEAR(shown.cauchy[i](0, 0) / weight, X, 1e-8) << scheme << ' ' << X;
      // lambda/(lambda + 2 mu) = nu/(1 - nu): the stretches across are held
      EXPECT_NEAR(shown.cauchy[i](1, 1) * shown.F[i](0, 0), 0.25 / 0.75 * shown.cauchy[i](0, 0),
                  1e-8 * weight);
      if ((shown.X.size() - 1 - i) % 2 == 0) {
        EXPECT_NEAR(shown.u[i][0], exact, 1e-8 * weight / modulus);
      }
    }
    const auto reactions = rest.reactions();
    ASSERT_EQ(reactions.size(), 1u);
    EXPECT_NEAR(reactions[0].force[0], weight, 1e-8 * weight) << "N/m^2: of the cross-section";
  }
}

TEST(Bars, AFreeOneKeepsItsMomentumAndHasNoAngularOne) {
  for (const std::string scheme : {"tlsph", "mixed", "updated", "eulerian", "element"}) {
    auto simulation = make_simulation<1>(bar(scheme, free_motion)).simulation;
    const Momentum before = simulation.momentum();
    RunRecord record;
    ASSERT_TRUE(run<1>(simulation, {}, record).completed()) << scheme;
    const Momentum now = simulation.momentum();
    // of the trapezoidal rule on 20 cells: sin(pi X) has the mean cot(pi/40)/20 = 0.63531
    EXPECT_NEAR(before.linear[0], density * (3 + 30 * 0.05 / std::tan(std::numbers::pi / 40)), 1e-8)
        << scheme;
    EXPECT_NEAR(now.linear[0], before.linear[0], 1e-11 * before.linear_scale) << scheme;
    for (const double L : now.angular) EXPECT_EQ(L, 0) << scheme;
  }
}

/// Verlet keeps an energy that differs from the true one by dt^2: its change falls by four with half of the step.
TEST(Bars, AFreeOneKeepsItsEnergyToTheSquareOfTheStep) {
  for (const std::string scheme : {"tlsph", "element"}) {
    std::vector<double> change;
    for (const char* cfl : {"0.2", "0.1", "0.05"}) {
      auto simulation =
          make_simulation<1>(bar(scheme, std::string("cfl = ") + cfl + "\n" + free_motion, 20, "0.37 ms"))
              .simulation;
      const double before = simulation.energy().total();
      RunRecord record;
      ASSERT_TRUE(run<1>(simulation, {}, record).completed()) << scheme;
      change.push_back(simulation.energy().total() / before - 1);
    }
    EXPECT_LT(std::abs(change[0]), 1e-3) << scheme;
    EXPECT_NEAR(change[0] / change[1], 4, 0.4) << scheme;  // the next order adds 1 % at these steps
    EXPECT_NEAR(change[1] / change[2], 4, 0.2) << scheme;
  }
}

class BarsBy : public testing::TestWithParam<std::string> {};

TEST_P(BarsBy, GoOnWithTheSameBits) {
  const Scene scene = bar(GetParam(), pulled);
  auto whole = make_simulation<1>(scene).simulation, first = make_simulation<1>(scene).simulation,
       second = make_simulation<1>(scene).simulation;
  RunRecord record, halves;
  ASSERT_TRUE(run<1>(whole, {}, record).completed());
  const long half = whole.steps.now().step / 2;
  run<1>(
      first, [&] { return first.steps.now().step < half; }, halves);
  second.restore(first.save());
  run<1>(second, {}, halves);
  const SavedState a = whole.save(), b = second.save();
  EXPECT_EQ(a.now.step, b.now.step);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  // an equilibrium is found anew from another start: to its tolerance, not to the last bit
  const double slack = GetParam() == "implicit" ? 1e-8 : 0;
  for (std::size_t k = 0; k < a.fields.size(); ++k)
    for (std::size_t i = 0; i < a.fields[k].values.size(); ++i)
      ASSERT_NEAR(a.fields[k].values[i], b.fields[k].values[i], slack * std::abs(a.fields[k].values[i]))
          << a.fields[k].name << ' ' << i;
}

TEST_P(BarsBy, HaveTheSameBitsOnOneAndTwoThreads) {
  const int threads = omp_get_max_threads();
  std::vector<SavedState> ends;
  for (const int n : {1, 2}) {
    omp_set_num_threads(n);
    Scene scene = bar(GetParam(), pulled, 6000, GetParam() == "implicit" ? "1 ms" : "0.9 us");
    ends.push_back(after(scene).save());
  }
  omp_set_num_threads(threads);
  ASSERT_EQ(ends[0].fields.size(), ends[1].fields.size());
  for (std::size_t k = 0; k < ends[0].fields.size(); ++k)
    EXPECT_EQ(ends[0].fields[k].values, ends[1].fields[k].values) << ends[0].fields[k].name;
}

/// Pulled by 30 MPa for good it would oscillate between 0 and twice the static stretch of 1 %. Here it has 1 ms, in which
/// the wave of the ramp has come to the held end and is on its way back.
TEST_P(BarsBy, PutTheTractionIntoTheStress) {
  const Simulation<1> end = after(bar(GetParam(), pulled, 100, GetParam() == "implicit" ? "1 ms" : "0.9 ms"));
  const Snapshot<1> shown = end.snapshot();
  // behind the front of the ramp: X > 1 - 0.6 m; an equilibrium has it everywhere. The updated scheme has another law and
  // dissipation at the front.
  const std::size_t end_cells = GetParam() == "updated" || GetParam() == "eulerian"
                                    ? 4
                                    : 2;  // its support is three cells, and the sum at an end misses half
  for (std::size_t i = 60; i + end_cells < shown.X.size(); ++i) {
    EXPECT_NEAR(shown.cauchy[i](0, 0), 30e6, GetParam() == "updated" ? 0.9e6 : 0.2e6) << shown.X[i][0];
    for (int k = 1; k < 3; ++k)  // nu/(1 - nu) across, to the strain of 1 % in which laws differ
      EXPECT_NEAR(shown.cauchy[i](k, k), shown.cauchy[i](0, 0) / 3, 0.6e6) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(All, BarsBy, testing::ValuesIn(scheme_names()),
                         [](const auto& about) { return about.param; });

/// Frequencies of a bar that is held at one end: (2 n - 1) c/(4 L).
TEST(Bars, RingWithTheFrequenciesOfABarHeldAtOneEnd) {
  std::vector<std::vector<double>> off;
  for (const int cells : {20, 40, 80}) {
    const TlsphBody<1> body = make_tlsph<1>(
        bar("tlsph", "[hourglass]\nalpha = 2\n[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n", cells));
    LinearOperator<1> op(body.solid, body.supports);
    const Spectrum spectrum = spectrum_of(op);
    ASSERT_GE(spectrum.low.modes.size(), 3u);
    EXPECT_TRUE(spectrum.rigid.empty());
    EXPECT_EQ(spectrum.negative.found, 0);
    off.emplace_back();
    for (int n = 1; n <= 3; ++n) {
      const Mode& mode = spectrum.low.modes[static_cast<std::size_t>(n - 1)];
      EXPECT_EQ(mode.kind, ModeKind::smooth) << n;
      off.back().push_back(mode.frequency() / op.time_unit() / ((2 * n - 1) * speed / 4) - 1);
    }
  }
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_LT(std::abs(off[2][n]), 4e-3) << "mode " << n + 1;
    EXPECT_NEAR(std::log2(off[1][n] / off[2][n]), 2, 0.15) << "order of mode " << n + 1;
  }
}

TEST(Bars, AFreeOneCanMoveAsAWholeAndDoesNotTurn) {
  const TlsphBody<1> body = make_tlsph<1>(bar("tlsph", "[hourglass]\nalpha = 2\n"));
  LinearOperator<1> op(body.solid, body.supports);
  EXPECT_EQ(spectrum_of(op).rigid.size(), 1u);
}

TEST(Bars, WithoutHourglassEnergyAlternatingMotionIsFree) {
  const std::string held = "[[boundary]]\nface = \"x-\"\nkind = \"clamped\"\n";
  const Scene scene = bar("tlsph", held);
  const TlsphBody<1> body = make_tlsph<1>(scene);
  LinearOperator<1> op(body.solid, body.supports);
  const Spectrum spectrum = spectrum_of(op);
  ASSERT_GE(spectrum.low.modes.size(), 2u);
  EXPECT_EQ(spectrum.low.modes[0].kind, ModeKind::smooth);
  EXPECT_EQ(spectrum.low.modes[1].kind, ModeKind::spurious) << "softer than the second smooth mode";
  ASSERT_EQ(limits_of(scene).size(), 1u);
  EXPECT_NE(limits_of(scene)[0].find("alternat"), std::string::npos);
  EXPECT_TRUE(limits_of(bar("tlsph", held + "[hourglass]\nalpha = 2\n")).empty());
}

}  // namespace
}  // namespace plumb
