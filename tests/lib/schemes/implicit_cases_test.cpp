// Published and closed-form equilibria by Newton's method, from scenes.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/geometry/clipped_cells.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"
#include "places.hpp"

namespace plumb {
namespace {

const std::string scenes = PLUMBLINE_SOURCE_DIR "/verification/scenes/";

TlsphBody<2> equilibrium_of(const std::string& file, const std::vector<std::string>& set,
                            StaticResult<2>* result = nullptr, const ImplicitOptions& options = {}) {
  auto s = make_tlsph<2>(read_scene(scenes + file, set));
  auto found = find_equilibrium<2>(s.solid, s.actions, s.control.end_time.value(), options, s.state);
  EXPECT_TRUE(found.completed()) << found.failure->in_words();
  if (result) *result = std::move(found);
  return s;
}

Vec<2> displacement_near(const TlsphBody<2>& s, const Vec<2>& X) {
  Index nearest = 0;
  for (Index i = 0; i < s.solid.cloud.size(); ++i)
    if ((s.solid.cloud.X[i] - X).norm() < (s.solid.cloud.X[nearest] - X).norm()) nearest = i;
  EXPECT_LT((s.solid.cloud.X[nearest] - X).norm(), 1e-9);
  return vector_at<2>(s.state.u, s.solid.bonds.slots.of(nearest));
}

/// The bar of the scene on a lattice that is bent so that its first column lies on the circle.
TlsphBody<2> flag_on_bent_lattice(Index cells_across) {
  Scene scene = read_scene(scenes + "elastic-flag.toml");
  const double spacing = 0.02 / static_cast<double>(cells_across);
  Cloud<2> cloud =
      lattice<2>({Vec<2>::Zero(), Vec<2>(0.35, 0.02)}, {35 * cells_across / 2, cells_across}, Layout::node);
  for (Vec<2>& X : cloud.X) {
    const double y = X[1] - 0.01, gap = 0.05 - std::sqrt(0.0025 - y * y);
    X[0] -= gap * (1 - X[0] / 0.35);
  }
  cloud.line = 0;
  cloud.spacing = spacing;
  const Shape<2> shape = shape_of<2>(scene.body);
  cloud.V = clipped_cells<2>(cloud.X, shape).volume;
  const Surface<2> surface = clipped_surface<2>(cloud, shape);
  return make_tlsph<2>(scene, std::move(cloud), surface);
}

/// CSM1 of Turek and Hron (2006): tip displaced by (-7.187e-3, -66.10e-3) m.
TEST(ImplicitCases, ElasticFlagOfTurekAndHron) {
  const Vec<2> published(-7.187e-3, -66.10e-3);
  std::vector<Vec<2>> tips;
  for (const Index cells : {4, 10, 20}) {
    auto s = flag_on_bent_lattice(cells);
    const auto result = find_equilibrium<2>(s.solid, s.actions, s.control.end_time.value(), {}, s.state);
    ASSERT_TRUE(result.completed());
    tips.push_back(displacement_near(s, {0.35, 0.01}));
    std::cout << cells << " cells across: tip " << tips.back().transpose() << " m\n";
    double area = 0;
    for (const double V : s.solid.cloud.V) area += V;
    EXPECT_NEAR(area, 0.35 * 0.02 + 6.7e-6, 1e-7);  // a rectangle and what lies beside the circle
    EXPECT_NEAR(result.reactions[0].force[1], area * 1000 * 2, 1e-7 * 14);  // it carries the weight
  }
  // 0.54 %; of u_x, which is quadratic in u_y, 1.05 %
  EXPECT_LT((tips[2] - published).norm(), 0.01 * published.norm());
  for (int k = 0; k < 2; ++k) {
    // of second order: the differences of 4, 10 and 20 cells are as 21 to 3
    EXPECT_LT(std::abs(tips[2][k] - tips[1][k]), 0.25 * std::abs(tips[1][k] - tips[0][k])) << k;
    EXPECT_NEAR(tips[2][k] + (tips[2][k] - tips[1][k]) / 3, published[k], 0.003 * std::abs(published[k]))
        << k;
  }
}

/// Rubber of paper 004, 6.5, by 10 x 10 elements of second order, pulled to 3.5 and 6 times its height: force [N/m], energy
/// [J/m] and displacement of the waist [m] as another finite-element program has them, to their printed digits.
TEST(ImplicitCases, PulledRubberAsInAnotherProgram) {
  struct Pull {
    double time, force, energy, waist;
  };
  for (const Pull& pull : {Pull{0.5, 517.5, 1.576, 0.707e-3}, Pull{1, 858.6, 5.020, 0.821e-3}}) {
    Scene scene = parse_scene(R"(
[scene]
name = "rubber"
dimension = 2
end_time = 1
[body]
size = ["2 mm", "2 mm"]
spacing = "0.1 mm"
layout = "node"
[material]
model = "neo-hookean-logarithmic"
young = "0.2 MPa"
poisson = 0.45
density = 1000
[method]
scheme = "element"
[element]
order = "quadratic"
solve = "newton"
[implicit]
steps = 40
[[boundary]]
face = "y-"
kind = "clamped"
[[boundary]]
face = "y+"
kind = "displacement"
displacement = ["0", "0.01*t"]
)",
                              "rubber.toml");
    scene.end_time = pull.time;
    auto simulation = make_simulation<2>(scene).simulation;
    RunRecord record;
    ASSERT_TRUE(run<2>(simulation, {}, record).completed());
    const Snapshot<2> shown = simulation.snapshot();
    double waist = 0;
    for (std::size_t i = 0; i < shown.X.size(); ++i)
      if (shown.X[i].norm() < 1.0000001e-3 && shown.X[i][0] < 1e-9)
        waist = shown.u[i][0];  // the last: (0, 1 mm)
    EXPECT_NEAR(simulation.energy().strain, pull.energy, 0.5e-3) << pull.time;
    EXPECT_NEAR(simulation.reactions().back().force[1], pull.force, 0.05) << pull.time;
    EXPECT_NEAR(waist, pull.waist, 0.5e-6) << pull.time;
  }
}

/// u_y = -rho g (L^2 - Y^2)/(2 E), Y from the lower end: exact for linear elasticity with nu = 0.
TEST(ImplicitCases, BarUnderItsOwnWeight) {
  const double g = 9.81, E = 17e6, rho = 1100;
  std::vector<double> errors;
  for (const char* spacing : {"0.05", "0.025"}) {
    StaticResult<2> result;
    const auto s = equilibrium_of("hanging-bar.toml",
                                  {std::string("body.spacing=") + spacing, "material.model=linear-elastic",
                                   "method.gradient=compatible"},
                                  &result);
    double worst = 0;
    for (Index i = 0; i < s.solid.cloud.size(); ++i) {
      const double Y = s.solid.cloud.X[i][1];
      const double exact = -rho * g * (1 - Y * Y) / (2 * E);
      worst = std::max(worst, std::abs(s.state.u[1][s.solid.bonds.slots.of(i)] - exact));
    }
    errors.push_back(worst / (rho * g / (2 * E)));
    EXPECT_NEAR(result.reactions[0].force[1], rho * g * 0.2, 1e-9 * rho * g * 0.2);
    EXPECT_LE(result.steps.back().newton.iterations(), 1);  // the law is linear: one step is exact
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], 0.3 * errors[0]);  // second order: a quarter
}

/// The damped run of the same scene ends where the direct search does.
TEST(ImplicitCases, RelaxationEndsInTheSameEquilibrium) {
  const auto found = equilibrium_of("hanging-bar.toml", {});
  auto run_to = make_tlsph<2>(read_scene(scenes + "hanging-bar.toml", {}));
  ASSERT_TRUE(run<2>(run_to.solid, run_to.state, run_to.integrator, run_to.control).completed());
  const auto u = unknowns_of(found.solid, found.state.u);
  // the slowest motion has decayed by exp(-23) = 1e-10, times its time in units of the decay (critical
  // damping)
  EXPECT_LT((unknowns_of(run_to.solid, run_to.state.u) - u).norm(), 1e-7 * u.norm());
}

}  // namespace
}  // namespace plumb
