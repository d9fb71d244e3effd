// Values: every number of the diagnostics against sums that are written out particle by particle, on bodies
// without any symmetry.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "lib/material/models/neo_hookean.hpp"
#include "lib/schemes/tlsph/measures/budget.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/run/solid_run.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

template <int d>
Vec<3> in_3d(const Vec<d>& v) {
  Vec<3> out = Vec<3>::Zero();
  out.template head<d>() = v;
  return out;
}

/// A body away from the origin with displacements and velocities of no symmetry.
template <int d>
struct Body {
  Solid<d> solid;
  State<d> state;
  std::vector<Vec<d>> x, v;
  std::vector<double> m;

  explicit Body(double jitter, Layout layout = Layout::node) {
    Cloud<d> cloud = block<d>(6, layout, jitter);
    for (auto& X : cloud.X) X += Vec<d>::Constant(0.7);
    cloud.box.origin += Vec<d>::Constant(0.7);
    const auto how = options<d>(Scheme{}, cloud.spacing);
    solid = make_solid<d>(std::move(cloud), "neo-hookean", rubber, how);
    state = make_state(solid);
    test::Numbers numbers(9);
    for (Index i = 0; i < solid.cloud.size(); ++i) {
      const Vec<d> u = 0.01 * numbers.vector<d>();
      v.push_back(3 * numbers.vector<d>());
      x.push_back(solid.cloud.X[i] + u);
      m.push_back(1100 * solid.cloud.V[i]);
      set_vector<d>(state.u, solid.bonds.slots.of(i), u);
      set_vector<d>(state.v, solid.bonds.slots.of(i), v[i]);
    }
  }
  /// F by the table's own bonds, found again.
  Mat<d> F(Index i) const {
    const auto how = options<d>(Scheme{}, solid.cloud.spacing);
    const auto all = find_neighbours<d>(solid.cloud, how.kernel.support * how.smoothing_length);
    Mat<d> F = Mat<d>::Zero();
    for (const auto& b : bonds_of<d>(solid.cloud, all.of(i), i, how))
      F += (x[b.other] - x[i]) * b.stencil.transpose();
    return F;
  }
};

template <int d>
void expect_measures(const Body<d>& body) {
  const NeoHookean material(rubber);
  double kinetic = 0, strain = 0, volume = 0, linear_scale = 0, angular_scale = 0;
  Vec<3> p = Vec<3>::Zero(), L = Vec<3>::Zero();
  Vec<d> lower = body.x[0], upper = body.x[0];
  for (Index i = 0; i < body.solid.cloud.size(); ++i) {
    kinetic += body.m[i] * body.v[i].squaredNorm() / 2;
    strain += body.solid.cloud.V[i] * material.energy(body.F(i));
    volume += body.solid.cloud.V[i];
    p += body.m[i] * in_3d<d>(body.v[i]);
    L += body.m[i] * in_3d<d>(body.x[i]).cross(in_3d<d>(body.v[i]));
    linear_scale += body.m[i] * body.v[i].norm();
    angular_scale += body.m[i] * body.x[i].norm() * body.v[i].norm();
    lower = lower.cwiseMin(body.x[i]);
    upper = upper.cwiseMax(body.x[i]);
    EXPECT_LT((deformation_gradient_of(body.solid, body.state, i) - body.F(i)).norm(), 1e-13);
  }
  const Energy energy = energy_of(body.solid, body.state);
  EXPECT_NEAR(energy.kinetic, kinetic, 1e-13 * kinetic);
  EXPECT_NEAR(energy.strain, strain, 1e-11 * strain);  // a difference of numbers a hundred times larger
  EXPECT_EQ(energy.elsewhere(), 0);
  EXPECT_NEAR(energy.total(), kinetic + strain, 1e-11 * (kinetic + strain));
  const Momentum momentum = momentum_of(body.solid, body.state);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(momentum.linear[k], p[k], 1e-13 * linear_scale) << k;
    EXPECT_NEAR(momentum.angular[k], L[k], 1e-13 * angular_scale) << k;
  }
  EXPECT_NEAR(momentum.linear_scale, linear_scale, 1e-13 * linear_scale);
  EXPECT_NEAR(momentum.angular_scale, angular_scale, 1e-13 * angular_scale);
  EXPECT_GT(std::abs(angular_scale / linear_scale - 1), 0.1);  // not the same number
  const Extent<d> extent = extent_of(body.solid, body.state);
  EXPECT_EQ(extent.lower, lower);
  EXPECT_EQ(extent.upper, upper);
  const double round_off = 24 * 0x1p-53 * 1.5 * 17e6 / 2.9 * volume;  // THEORY (8.9)
  EXPECT_NEAR(energy_round_off(body.solid), round_off, 1e-12 * round_off);
}

/// THEORY (8.4) over pairs closer than 1.1 spacings.
template <int d>
void expect_hourglass_share(const Body<d>& body) {
  double unexplained = 0, whole = 0;
  for (Index i = 0; i < body.solid.cloud.size(); ++i)
    for (Index j = 0; j < body.solid.cloud.size(); ++j) {
      const Vec<d> X = body.solid.cloud.X[j] - body.solid.cloud.X[i], x = body.x[j] - body.x[i];
      if (i == j || X.norm() > 1.1 * body.solid.cloud.spacing) continue;
      unexplained += (x - 0.5 *
                              (deformation_gradient_of(body.solid, body.state, i) +
                               deformation_gradient_of(body.solid, body.state, j)) *
                              X)
                         .squaredNorm();
      whole += x.squaredNorm();
    }
  const double share = std::sqrt(unexplained / whole);
  EXPECT_NEAR(hourglass_share(body.solid, body.state), share, 1e-12);
  EXPECT_GT(share, 1e-3);
}

TEST(MeasureValues, AreSumsOverParticles) {
  for (const Layout layout : {Layout::node, Layout::cell})
    for (const double jitter : {0.0, 0.2}) {
      const Body<2> plane(jitter, layout);
      const Body<3> space(jitter, layout);
      expect_measures(plane);
      expect_measures(space);
      expect_hourglass_share(plane);
      expect_hourglass_share(space);
    }
}

/// A push of every particle [N/m^d] that changes from place to place, without potential.
template <int d>
Vec<d> push(const Vec<d>& X) {
  Vec<d> f;
  for (int k = 0; k < d; ++k) f[k] = 1e5 * std::cos(5 * X[(k + 1) % d] + k);
  return f;
}

template <int d>
Term<d> push_term(const Solid<d>& solid) {
  Term<d> term;
  term.name = "push";
  std::vector<Vec<d>> f(solid.bonds.slots.count(), Vec<d>::Zero());
  for (Index i = 0; i < solid.cloud.size(); ++i) f[solid.bonds.slots.of(i)] = push<d>(solid.cloud.X[i]);
  term.second = [f](const Solid<d>&, const Block& block, const Instant<d>&, BlockForce<d>& force) {
    for (Index i = block.begin(); i < block.end(); ++i)
      for (int k = 0; k < d; ++k) force(k, i) += f[i][k];
  };
  return term;
}

/// What a constant push does in a step is known beforehand; what the internal force does follows from the
/// change of the state.
template <int d>
void expect_budget(const std::string& name) {
  Body<d> body(0.2);
  add_term(body.solid, push_term(body.solid));
  const ChosenIntegrator<d> integrator = integrator_named<d>(name, body.solid);
  Budget<d> budget(body.solid, body.state, integrator.weights);
  const double dt = 1e-5;
  BudgetPart pushed, total_pushed;
  Vec<3> carried = Vec<3>::Zero();
  for (int n = 0; n < 3; ++n) {
    const State<d> before = body.state;
    const Energy was = energy_of(body.solid, before);
    ASSERT_TRUE(integrator.step(body.solid, body.state, dt));
    budget.close_step(body.solid, body.state);
    pushed = {};
    carried.setZero();
    Vec<3> change = Vec<3>::Zero();
    double scale = 0;
    for (Index i = 0; i < body.solid.cloud.size(); ++i) {
      const Index s = body.solid.bonds.slots.of(i);
      const Vec<3> v0 = in_3d<d>(vector_at<d>(before.v, s)), v1 = in_3d<d>(vector_at<d>(body.state.v, s));
      const Vec<3> x0 = in_3d<d>(position_of(body.solid, before, i)),
                   x1 = in_3d<d>(position_of(body.solid, body.state, i));
      const Vec<3> impulse = dt * body.solid.cloud.V[i] * in_3d<d>(push<d>(body.solid.cloud.X[i]));
      pushed.linear += impulse;
      pushed.angular += (0.5 * (x0 + x1)).cross(impulse);
      pushed.energy += (0.5 * (v0 + v1)).dot(impulse);
      carried += body.m[i] * (x1 - x0).cross(0.5 * (v0 + v1));
      change += body.m[i] * (v1 - v0);
      scale += body.m[i] * v1.norm();
    }
    const BudgetPart& part = budget.step().part("push");
    EXPECT_LT((part.linear - pushed.linear).norm(), 1e-12 * scale) << name;
    EXPECT_LT((part.angular - pushed.angular).norm(), 1e-12 * scale) << name;
    EXPECT_NEAR(part.energy, pushed.energy, 1e-12 * scale) << name;
    EXPECT_LT((budget.step().part("integrator").angular - carried).norm(), 1e-12 * scale);
    EXPECT_LT(budget.step().part("integrator").linear.norm(), 1e-12 * scale);
    EXPECT_LT((budget.step().part("internal force").linear - (change - pushed.linear)).norm(), 1e-12 * scale);
    EXPECT_LT(budget.step().linear_gap, 1e-13);
    EXPECT_LT(budget.step().angular_gap, 1e-13);
    // the adjoint force makes no energy: what neither the push nor the state explains is the integrator's
    const Energy is = energy_of(body.solid, body.state);
    const double made = is.total() - was.total() - pushed.energy;
    EXPECT_NEAR(budget.step().part("internal force").energy, 0, 1e-10 * is.kinetic) << name;
    EXPECT_NEAR(budget.step().part("integrator").energy, made, 1e-10 * is.kinetic) << name;
    total_pushed.linear += pushed.linear;
    total_pushed.angular += pushed.angular;
    total_pushed.energy += pushed.energy;
    const BudgetPart& total = budget.total().part("push");
    EXPECT_LT((total.linear - total_pushed.linear).norm(), 1e-12 * scale);
    EXPECT_LT((total.angular - total_pushed.angular).norm(), 1e-12 * scale);
    EXPECT_NEAR(total.energy, total_pushed.energy, 1e-12 * scale);
  }
  EXPECT_THROW(budget.step().part("pull"), InputError);
}

TEST(BudgetValues, OfAConstantPushAreKnownBeforehand) {
  for (const std::string name : {"verlet", "rk3"}) {
    expect_budget<2>(name);
    expect_budget<3>(name);
  }
}

}  // namespace
}  // namespace plumb::testing
