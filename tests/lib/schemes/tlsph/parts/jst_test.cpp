#include "lib/schemes/tlsph/parts/jst.hpp"

#include <gtest/gtest.h>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

/// Force of the JST term alone for the velocity v(X), per particle.
template <int d, class Velocity>
std::vector<Vec<d>> jst_force(Solid<d>& solid, const JstOptions& options, Velocity&& velocity) {
  State<d> state = make_state(solid);
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(state.v, solid.bonds.slots.of(i), velocity(solid.cloud.X[i]));
  const Term<d> term = jst_term(solid, options);
  std::vector<Vec<d>> force(solid.bonds.slots.count(), Vec<d>::Zero());
  const Workspace<d> workspace;
  const Instant<d> now{state, 0, workspace, solid.terms};
  for (Index b = 0; b < solid.blocks(); ++b) term.first(solid, solid.block(b), now);
  for (Index b = 0; b < solid.blocks(); ++b) {
    const Block block = solid.block(b);
    BlockForce<d> f(block);
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) f(k, i) = 0;
    term.second(solid, block, now, f);
    for (int k = 0; k < d; ++k)
      for (Index i = block.begin(); i < block.end(); ++i) force[i][k] = f(k, i);
  }
  std::vector<Vec<d>> by_particle;
  for (Index i = 0; i < solid.cloud.size(); ++i) by_particle.push_back(force[solid.bonds.slots.of(i)]);
  return by_particle;
}

Scheme with_laplacian(double beta = 0.9) {
  Scheme scheme;
  scheme.laplacian = true;
  scheme.beta = beta;
  return scheme;
}

/// eta2 = 1/(C h rho) makes the term the outer Laplacian of v.
template <int d>
JstOptions pure_laplacian(const Solid<d>& solid) {
  return {1 / (solid.elastic.wave_speed() * solid.smoothing_length * solid.elastic.density), 0};
}

TEST(Jst, VanishesForConstantAndLinearVelocitiesOnEveryCloud) {
  for (const double jitter : {0.0, 0.2}) {
    Solid<2> solid = rubber_block<2>(16, Layout::node, jitter, with_laplacian());
    const JstOptions fourth{0, 0.125};
    const auto linear =
        jst_force(solid, fourth, [](const Vec<2>& X) { return Vec<2>(1 + 2 * X[0] - X[1], 3 * X[1]); });
    const auto cubic =
        jst_force(solid, fourth, [](const Vec<2>& X) { return Vec<2>(std::pow(X[0], 3), X[1] * X[1]); });
    double most = 0, scale = 0;
    for (std::size_t i = 0; i < linear.size(); ++i) {
      most = std::max(most, linear[i].norm());
      scale = std::max(scale, cubic[i].norm());
    }
    EXPECT_LT(most, 1e-11 * scale)
        << jitter;  // rounding of the inner Laplacian, 1e-16/d^2, differenced once more
    EXPECT_GT(scale, 0);
  }
}

TEST(Jst, LaplacianOfAQuadraticInsideALatticeHasTheKnownFactor) {
  struct Row {
    double beta, factor;
  };
  for (const Row row :
       {Row{0.6, .351}, Row{0.9, .982}, Row{1.2, .991}, Row{1.5, 1.007}}) {  // an independent program, 2D
    Solid<2> solid = rubber_block<2>(16, Layout::cell, 0, with_laplacian(row.beta));
    const auto lap = jst_force(solid, pure_laplacian(solid),
                               [](const Vec<2>& X) { return Vec<2>(X.squaredNorm(), X[0] * X[0]); });
    const Index middle = solid.cloud.line * 7 + 8;
    EXPECT_NEAR(lap[middle][0] / 4, row.factor, 6e-4) << row.beta;  // three digits are given
    EXPECT_NEAR(lap[middle][1] / 2, row.factor, 6e-4) << row.beta;
  }
  Solid<3> solid = rubber_block<3>(10, Layout::cell, 0, with_laplacian());
  const auto lap =
      jst_force(solid, pure_laplacian(solid), [](const Vec<3>& X) { return Vec<3>(X.squaredNorm(), 0, 0); });
  const Index middle = 5 * solid.cloud.stride[0] + 4 * solid.cloud.stride[1] + 4 * solid.cloud.stride[2];
  EXPECT_NEAR(lap[middle][0] / 6, .963, 6e-4);
}

TEST(Jst, KeepsLinearMomentumAndTakesEnergy) {
  for (const bool transpose : {false, true}) {
    Cloud<3> cloud = block<3>(8, Layout::cell, 0.2);
    auto o = options<3>(with_laplacian(), cloud.spacing);
    o.outer_transpose = transpose;
    Solid<3> solid = make_solid<3>(std::move(cloud), "neo-hookean", rubber, o);
    const auto v = [](const Vec<3>& X) {
      return Vec<3>(std::sin(9 * X[0]), std::cos(7 * X[1] * X[2]), X[0] * X[0]);
    };
    const auto f = jst_force(solid, {0, 0.125}, v);
    Vec<3> sum = Vec<3>::Zero();
    double scale = 0, power = 0;
    for (Index i = 0; i < solid.cloud.size(); ++i) {
      sum += solid.cloud.V[i] * f[i];
      scale += solid.cloud.V[i] * f[i].norm();
      power += solid.cloud.V[i] * f[i].dot(v(solid.cloud.X[i]));
    }
    EXPECT_LT(sum.norm(), 1e-12 * scale)
        << transpose;  // pairwise opposite; rounding of two levels of 26 bonds
    EXPECT_LT(power, 0) << transpose;
  }
}

TEST(Jst, StepLimitHasTheKnownSpectralRadius) {
  struct Row {
    double beta, radius;
  };
  for (const Row row : {Row{0.6, 7.35}, Row{0.9, 33.3}, Row{1.2, 15.7},
                        Row{1.5, 6.37}}) {  // an independent program, 2D, its own size of body
    const Solid<2> solid = rubber_block<2>(24, Layout::cell, 0, with_laplacian(row.beta));
    EXPECT_NEAR(biharmonic_radius(solid) / row.radius, 1, 0.05) << row.beta;
  }
  const Solid<2> solid = rubber_block<2>(16, Layout::cell, 0, with_laplacian());
  const double limit = jst_step_limit(solid, {0, 0.125}, 2.51);
  const double cfl = limit * solid.elastic.wave_speed() / solid.cloud.spacing;
  EXPECT_LT(cfl, 0.9);  // eta4 = 1/8, beta = 0.9 exceeds the limit at alpha = 0.9
  EXPECT_GT(cfl, 0.7);
}

}  // namespace
}  // namespace plumb::testing
