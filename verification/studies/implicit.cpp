// Static manufactured solutions at finite strain by Newton's method (THEORY, chapter 15): order in L2 with
// its interval.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "lib/convergence/verdict.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/implicit/equilibrium.hpp"
#include "mms/manufactured.hpp"
#include "mms/norms.hpp"

namespace plumb::implicit_study {

namespace {

const Elastic rubber{17e6, 0.3, 1100};

/// The body of a solution's box, with exact displacements on its surface and -Div P inside at every time.
template <int d>
Actions<d> static_actions(const Cloud<d>& cloud, const mms::Manufactured<d>& solution) {
  Actions<d> actions;
  Held<d> surface;
  surface.name = "surface";
  surface.steady = false;
  surface.motion = [&solution](const Vec<d>& X, int component, double t) -> HeldMotion {
    return {solution.displacement(X, t)[component], 0, 0};
  };
  for (Index i = 0; i < cloud.size(); ++i)
    if (solution.domain.depth(cloud.X[i]) < 1e-9)
      for (int k = 0; k < d; ++k) surface.places.push_back({i, k, cloud.X[i]});
  actions.held.push_back(surface);
  actions.body_forces.push_back({"-Div P",
                                 [&solution](const Vec<d>& X, double t) -> Vec<d> {
                                   return -solution.stress_divergence(solution.motion(X, t));
                                 },
                                 false});
  return actions;
}

/// Relative L2 errors of displacement and stress on one lattice, at a quarter of the period.
struct Errors {
  double l2, stress;
};
template <int d>
Errors static_error(const mms::Manufactured<d>& solution, const Method& method, double spacing,
                    double jitter) {
  Scene scene;
  scene.dimension = d;
  scene.end_time = solution.period / 4;
  scene.body.size.assign(solution.domain.box.size.begin(), solution.domain.box.size.end());
  scene.body = with_spacing(scene.body, spacing);
  scene.body.jitter = jitter;
  scene.material = {"neo-hookean", rubber.young, rubber.poisson, rubber.density};
  scene.method = method;
  TlsphBody<d> s = make_tlsph<d>(scene);
  ImplicitOptions options;
  options.steps = 1;
  const Actions<d> actions = static_actions<d>(s.solid.cloud, solution);
  const auto result = find_equilibrium<d>(s.solid, actions, *scene.end_time, options, s.state);
  REQUIRE(result.completed());
  const mms::ExactField<d> field = [&](const Vec<d>& X) -> mms::PointValue<d> {
    const mms::Motion<d> m = solution.motion(X, *scene.end_time);
    return {m.displacement, m.F - Mat<d>::Identity(), Vec<d>::Zero(), solution.first_piola(m.F)};
  };
  const auto values = mms::nodal_values<d>(s.solid, s.state, solution.first_piola);
  const auto error = mms::nodal_norms<d>(s.solid.cloud, values, field),
             exact = mms::nodal_size<d>(s.solid.cloud, field);
  return {error.l2 / exact.l2, error.stress_l2 / exact.stress_l2};
}

template <int d>
OrderFit order_of(const mms::Manufactured<d>& solution, const Method& method,
                  const std::vector<double>& spacings, double jitter, const std::string& what) {
  std::vector<Level> levels, stress;
  std::string row;
  for (const double spacing : spacings) {
    const Errors e = static_error<d>(solution, method, spacing, jitter);
    levels.push_back({spacing, e.l2});
    stress.push_back({spacing, e.stress});
    row += fmt::format(" {:.3e} ({:.2e})", e.l2, e.stress);
  }
  const OrderFit fit = fit_order(levels), of_stress = fit_order(stress);
  std::cout << fmt::format("{}: L2 (stress){}; order {:.2f} [{:.2f}, {:.2f}], stress {:.2f}\n", what, row,
                           fit.order, fit.lower, fit.upper, of_stress.order);
  return fit;
}

Method with_gradient(const std::string& gradient, double alpha) {
  Method method;
  method.gradient = gradient;
  if (alpha > 0) method.hourglass = HourglassOptions{.alpha = alpha};
  return method;
}

}  // namespace

/// Swinging plate with an amplitude of 0.2 m on 2 m: strains of 0.3.
TEST_CASE("implicit: static plate at finite strain is of second order with compatible bonds") {
  const auto plate = mms::manufactured<2>("swinging-plate", {{"amplitude", 0.2}}, rubber);
  const std::vector<double> spacings{0.2, 0.1, 0.05, 0.025};
  const auto lattice = order_of<2>(plate, with_gradient("compatible", 0), spacings, 0, "compatible, lattice");
  CHECK(judge(lattice, 2.0) == Verdict::pass);
  const auto stiffened =
      order_of<2>(plate, with_gradient("compatible", 1), spacings, 0, "compatible, alpha 1, lattice");
  CHECK(judge(stiffened, 2.0) == Verdict::pass);
  const auto irregular =
      order_of<2>(plate, with_gradient("compatible", 1), spacings, 0.2, "compatible, alpha 1, jitter 0.2");
  CHECK(irregular.lower > 1.5);
}

}  // namespace plumb::implicit_study
