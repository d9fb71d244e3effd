// What bodies with mirror images behind rollers conserve: momentum along the walls, energy; and what they do
// not, momentum across the walls, is named in the budget.
#include <catch2/catch.hpp>
#include <iostream>

#include "lib/schemes/tlsph/measures/budget.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/solids.hpp"

namespace plumb::mirror_study {
using plumb::testing::Scheme;

namespace {

/// Sums of some hundred terms over twenty steps, relative to their size: a hundred times what is seen.
constexpr double round_off = 1e-12;

struct Ending {
  BudgetSums sums;
  double scale, energy;  ///< sum m |v|, total energy at the end
};

/// Twenty steps of a block on a wall at x-, deformed and moving along it and towards it.
template <int d>
Ending follow(double jitter, const char* momentum, const char* name) {
  const Cloud<d> cloud = plumb::testing::block<d>(d == 2 ? 10 : 6, Layout::cell, jitter);
  auto options = plumb::testing::options<d>(Scheme{"improved", momentum}, cloud.spacing);
  options.walls = {{0, false}};
  Solid<d> solid = make_solid<d>(cloud, "neo-hookean", plumb::testing::rubber, options);
  State<d> state = make_state(solid);
  plumb::testing::deform(solid, state, 0.01);  // not zero at the wall, where it is a kink
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; k < d; ++k) state.v[k][solid.bonds.slots.of(i)] = std::cos(2 * cloud.X[i][k] + k);
  const ChosenIntegrator<d> integrator = integrator_named<d>(name, solid);
  Budget<d> budget(solid, state, integrator.weights);
  StepControl control;
  control.fixed_step = 0.4 * cloud.spacing / solid.elastic.wave_speed();
  control.max_steps = 20;
  const auto result = run<d>(solid, state, integrator, control, [&](const Solid<d>& now, const State<d>& s) {
    if (s.step > 0) budget.close_step(now, s);
    return true;
  });
  REQUIRE(result.completed());
  return {budget.total(), momentum_of(solid, state).linear_scale, energy_of(solid, state).total()};
}

template <int d>
void require_walls_named() {
  for (const double jitter : {0.0, 0.2})
    for (const std::string momentum : {"adjoint", "symmetrised"})
      for (const char* integrator : {"rk3", "verlet"}) {
        const Ending o = follow<d>(jitter, momentum.c_str(), integrator);
        INFO(d << "D jitter " << jitter << " " << momentum << " " << integrator);
        CHECK(o.sums.linear_gap < round_off);
        CHECK(o.sums.angular_gap < round_off);
        CHECK(o.sums.energy_gap < round_off);
        CHECK(o.sums.part("internal force").linear.norm() < round_off * o.scale);
        const Vec<3> reaction = o.sums.part("mirror").linear;
        CHECK(std::abs(reaction[0]) > 1e-3 * o.scale);  // it was pushed back
        CHECK(reaction.tail<2>().norm() < round_off * o.scale);
        const double defect = std::abs(o.sums.part("internal force").energy) / o.energy;
        if (momentum == "adjoint")
          CHECK(defect < round_off);  // minus the derivative of the energy of the particles that are there
        else
          CHECK(defect > 1e-8);
        CHECK(o.sums.part("mirror").energy == 0);  // its work is in the strain energy
      }
}

}  // namespace

TEST_CASE(
    "conservation: with mirror images momentum along the walls, energy; the rest is the wall's reaction",
    "[conservation]") {
  require_walls_named<2>();
  require_walls_named<3>();
}

}  // namespace plumb::mirror_study
