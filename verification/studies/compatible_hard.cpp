// Clouds that are hard for compatible bonds (THEORY chapter 11, limits): the least beta from which each
// works, what is said below it, and whether what works is sound: affine motion, soft modes, a run without
// dissipation.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <optional>

#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/spectrum/spectrum.hpp"

namespace plumb::compatible_hard_study {

namespace {

/// A body that is hard: what the scene says, or particles that it cannot describe.
template <int d>
struct Hard {
  std::string name;
  Scene scene;
  std::optional<Cloud<d>> cloud = {};
};

template <int d>
Scene scene_of(std::vector<double> size, double spacing, Layout layout) {
  Scene scene;
  scene.dimension = d;
  scene.max_steps = 200;
  scene.body.size = std::move(size);
  scene.body.spacing = spacing;
  scene.body.layout = layout;
  scene.material = {"neo-hookean", 17e6, 0.3, 1100};
  scene.method.gradient = "compatible";
  scene.method.compatible.table = "projected";  // lattices too
  std::vector<Expression> velocity = {Expression("1e-2*sin(9*X + 5*Y)", d),
                                      Expression("1e-2*sin(7*Y - 4*X)", d)};
  if (d == 3) velocity.emplace_back("1e-2*sin(8*Z + 3*X)", d);
  scene.initial = Initial{};
  scene.initial->velocity = velocity;
  return scene;
}

template <int d>
TlsphBody<d> build(const Hard<d>& hard, double beta) {
  Scene scene = hard.scene;
  scene.method.beta = beta;
  if (!hard.cloud) return make_tlsph<d>(scene);
  return make_tlsph<d>(scene, *hard.cloud, box_surface<d>(*hard.cloud));
}

/// What is measured on a cloud that works.
struct Sound {
  double beta;
  Index particles;
  double affine;                                ///< error of F for an affine motion
  double residual;                              ///< of the constraints
  double least_volume;                          ///< over spacing^d
  double change;                                ///< largest, of an area vector, over spacing^(d-1)
  int negative, spurious;                       ///< modes: growing; spurious below the lowest smooth one
  std::optional<double> lowest, lowest_smooth;  ///< (omega d/c_p)^2; nothing: no mode is (smooth)
  double cfl;                                   ///< Verlet's limit
  double energy;  ///< largest relative change in 200 steps of a quarter of that limit
};

template <int d>
double affine_error(TlsphBody<d>& simulation) {
  Mat<d> G;
  for (int a = 0; a < d; ++a)
    for (int b = 0; b < d; ++b) G(a, b) = 0.1 * std::sin(1.0 + 3 * a + 7 * b);
  State<d> state = make_state(simulation.solid);
  double wrong = 0;
  for (Index i = 0; i < simulation.solid.cloud.size(); ++i)
    set_vector<d>(state.u, simulation.solid.bonds.slots.of(i), G * simulation.solid.cloud.X[i]);
  for (Index i = 0; i < simulation.solid.cloud.size(); ++i)
    wrong = std::max(wrong,
                     (deformation_gradient_of(simulation.solid, state, i) - Mat<d>::Identity() - G).norm());
  return wrong;
}

template <int d>
double energy_change(TlsphBody<d>& simulation, double step) {
  simulation.control.fixed_step = step;
  const double start = energy_of(simulation.solid, simulation.state).total();
  double change = 0;
  const auto result = run<d>(simulation.solid, simulation.state, simulation.integrator, simulation.control,
                             [&](const Solid<d>& solid, const State<d>& state) {
                               change =
                                   std::max(change, std::abs(energy_of(solid, state).total() / start - 1));
                               return true;
                             });
  return result.completed() ? change : NAN;
}

template <int d>
Sound measure(const Hard<d>& hard, double beta) {
  TlsphBody<d> simulation = build(hard, beta);
  const double cell = std::pow(simulation.solid.cloud.spacing, d);
  Sound found{};
  found.beta = beta;
  found.particles = simulation.solid.cloud.size();
  found.residual = simulation.compatible->residual;
  found.change = simulation.compatible->largest_change;
  found.least_volume =
      *std::min_element(simulation.solid.cloud.V.begin(), simulation.solid.cloud.V.end()) / cell;
  found.affine = affine_error(simulation);
  LinearOperator<d> op(simulation.solid, simulation.supports);
  const Spectrum spectrum = spectrum_of(op);
  found.negative = spectrum.negative.found;
  found.spurious = spectrum.low.spurious_below_smooth.found;
  found.lowest = spectrum.lowest_nonrigid();
  found.lowest_smooth = spectrum.low.lowest_smooth;
  const double limit = oscillation_limit("verlet") / std::sqrt(spectrum.largest);  // in d/c_p
  found.cfl = limit;
  found.energy = energy_change(simulation, 0.25 * limit * op.time_unit());
  return found;
}

/// The least beta that works, with what was said below it; nothing if none does.
template <int d>
std::optional<Sound> least_beta(const Hard<d>& hard, std::string& said,
                                const std::vector<double>& betas = {0.9, 1.2, 1.5, 1.8}) {
  for (const double beta : betas) try {
      return measure(hard, beta);
    } catch (const InputError& error) {
      said += fmt::format("  {:g}: {} ({});", beta, error.problem(), error.why());
    }
  return std::nullopt;
}

template <int d>
void print(const Hard<d>& hard, const Sound& found) {
  std::cout << fmt::format(
      "  {:44} beta {:3g}  N {:4}  V {:.2g}  A {:4.2g}  F {:.0e}  growing {}  spurious {:3}  lowest {:.2g}  "
      "smooth {:.2g}  cfl {:.2g}  energy {:.1e}\n",
      fmt::format("{}D {}", d, hard.name), found.beta, found.particles, found.least_volume, found.change,
      found.affine, found.negative, found.spurious, found.lowest.value_or(NAN),
      found.lowest_smooth.value_or(NAN), found.cfl, found.energy);
}

/// Prints the least beta that works, and the next ones until area vectors are of the size of cells and the
/// step is not below what lattices have. Returns the first.
template <int d>
std::optional<Sound> report(const Hard<d>& hard, const std::vector<double>& betas = {0.9, 1.2, 1.5, 1.8}) {
  std::string said;
  const auto found = least_beta(hard, said, betas);
  if (!found) std::cout << fmt::format("  {:44} refused\n", fmt::format("{}D {}", d, hard.name));
  for (const double beta : betas) {
    if (!found || beta < found->beta) continue;
    const Sound now = measure(hard, beta);
    print(hard, now);
    if (now.change < 3 && now.cfl > 0.5) break;
  }
  if (!said.empty()) std::cout << "      " << said << "\n";
  return found;
}

template <int d>
std::optional<Sound> expect_sound(const Hard<d>& hard,
                                  const std::vector<double>& betas = {0.9, 1.2, 1.5, 1.8},
                                  double affine = 1e-10) {
  const auto found = report(hard, betas);
  INFO(hard.name);
  CHECK(found.has_value());
  if (!found) return found;
  CHECK(found->affine < affine);
  CHECK(found->residual < 1e-12);
  CHECK(found->least_volume > 0);
  CHECK(found->negative == 0);  // the force has an energy, and that is not negative
  CHECK(found->energy < 0.05);  // bounded: Verlet at half its limit
  return found;
}

template <int d>
void expect_refused(const Hard<d>& hard) {
  std::string said;
  INFO(hard.name);
  CHECK(!least_beta(hard, said));
  CHECK(said.find("particle") != std::string::npos);
  std::cout << fmt::format("  {:44} refused\n      {}\n", fmt::format("{}D {}", d, hard.name), said);
}

template <int d>
Hard<d> shaped(const std::string& name, double spacing, const std::string& shape, ShapeLengths lengths,
               std::vector<ShapeChoice> holes = {}) {
  Scene scene = scene_of<d>(shape == "box" ? std::vector<double>(d, 1.0) : std::vector<double>{}, spacing,
                            Layout::cell);
  scene.body.shape = shape;
  scene.body.lengths = std::move(lengths);
  scene.body.holes = std::move(holes);
  return {name, scene, {}};
}

/// The same with particles that are jittered, random, or on the surface too.
template <int d>
std::vector<Hard<d>> clouds_of(Hard<d> hard) {
  std::vector<Hard<d>> all;
  for (const Layout layout : {Layout::cell, Layout::node}) {
    const std::string at = layout == Layout::cell ? ", cell" : ", node";
    hard.scene.body.layout = layout;
    all.push_back({hard.name + at + " lattice", hard.scene, {}});
    all.push_back({hard.name + at + " jitter 0.2", hard.scene, {}});
    all.back().scene.body.jitter = 0.2;
    all.push_back({hard.name + at + " blue noise", hard.scene, {}});
    all.back().scene.body.cloud = "blue-noise";
  }
  return all;
}

/// A square of node lattice whose spacing grows tenfold from its ends to its middle.
Cloud<2> clustered(Index cells) {
  Cloud<2> cloud = lattice<2>({Vec<2>::Zero(), Vec<2>::Constant(1)}, {cells, cells}, Layout::node);
  const double least = 2.0 / 11, most = 20.0 / 11;  // of the mean spacing
  for (auto& X : cloud.X)
    for (int k = 0; k < 2; ++k) {
      const double s = std::min(X[k], 1 - X[k]);
      const double moved = least * s + (most - least) * s * s;
      X[k] = X[k] <= 0.5 ? moved : 1 - moved;
    }
  cloud.line = 0;
  cloud.V = voronoi_volumes<2>(cloud.X, cloud.box);
  return cloud;
}

Cloud<2> with_duplicate(double gap) {
  Cloud<2> cloud =
      jittered<2>(lattice<2>({Vec<2>::Zero(), Vec<2>::Ones()}, {10, 10}, Layout::node), 0.2, 1, Layout::node);
  cloud.X.emplace_back(cloud.X[cloud.size() / 2] + Vec<2>(0.6, 0.8) * gap * cloud.spacing);
  cloud.V = voronoi_volumes<2>(cloud.X, cloud.box);
  return cloud;
}

template <int d>
std::vector<Hard<d>> shapes(double spacing) {
  const std::vector<double> middle(d, 0.5), up(d, 1.0);
  std::vector<double> hole_centre(d, 0.5);
  std::vector<Hard<d>> all = {
      shaped<d>("hole", spacing, "box", {}, {{"ball", {{"centre", hole_centre}, {"radius", {0.25}}}}}),
      shaped<d>("cut by a plane", spacing, "box", {}, {{"half-space", {{"point", middle}, {"normal", up}}}})};
  if constexpr (d == 2)
    all.push_back(shaped<2>("triangle, corner 25 degrees", spacing, "polygon",
                            {{"corners", {-1, -0.5, 1, -0.5, -0.7, 0.6}}}));
  return all;
}

}  // namespace

TEST_CASE("compatible: hard clouds, thin bodies", "[compatible][hard]") {
  std::cout
      << "hard clouds: least beta of 0.9, 1.2, 1.5, 1.8; particles N, least volume V/d^dim, largest change "
         "of an "
         "area vector A, error of F; modes; Verlet's cfl limit, energy in 200 steps of a quarter of it\n";
  expect_refused<2>({"one node thick", scene_of<2>({2, 0.1}, 0.1, Layout::cell), {}});
  expect_refused<3>({"one node thick", scene_of<3>({1, 1, 0.1}, 0.1, Layout::cell), {}});
  expect_sound<2>({"two nodes thick", scene_of<2>({2, 0.1}, 0.1, Layout::node), {}});
  expect_sound<3>({"two nodes thick", scene_of<3>({0.8, 0.6, 0.1}, 0.1, Layout::node), {}});
}

TEST_CASE("compatible: hard clouds, points that come close", "[compatible][hard]") {
  expect_sound<2>(
      {"spacing 1:10, fine at the edge", scene_of<2>({1, 1}, 1.0 / 12, Layout::node), clustered(12)},
      {0.9, 1.2, 1.5, 1.8, 2.2}, 1e-9);
  for (const double gap : {1e-2, 1e-4})
    expect_sound<2>({fmt::format("two particles {:g} d apart", gap), scene_of<2>({1, 1}, 0.1, Layout::node),
                     with_duplicate(gap)},
                    {0.9, 1.2, 1.5, 1.8}, 1e-11 / gap);
  report<2>({"two particles 1e-6 d apart", scene_of<2>({1, 1}, 0.1, Layout::node), with_duplicate(1e-6)});
}

TEST_CASE("compatible: hard clouds, holes, cuts and corners", "[compatible][hard]") {
  for (const auto& shape : shapes<2>(0.1))
    for (const auto& hard : clouds_of<2>(shape)) expect_sound<2>(hard);
  for (const auto& shape : shapes<3>(0.2))
    for (const auto& hard : clouds_of<3>(shape)) expect_sound<3>(hard);
}

}  // namespace plumb::compatible_hard_study
