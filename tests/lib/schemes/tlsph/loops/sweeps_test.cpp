// The packed loops against a plain implementation that nobody can misread, and the force against the energy.
#include <gtest/gtest.h>
#include <omp.h>

#include "lib/material/models/neo_hookean.hpp"
#include "lib/schemes/tlsph/loops/evaluate.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/time/integrator.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing::sweeps_test {
namespace {

/// The oracle: bonds particle by particle, sums as written in THEORY (3.1) and (5.2), (5.3); no table, no
/// packs.
template <int d>
struct Plain {
  const Cloud<d>& cloud;
  BondOptions<d> o;
  Neighbours all = find_neighbours<d>(cloud, o.kernel.support* o.smoothing_length);

  std::vector<BondConstants<d>> bonds(Index i) const { return bonds_of<d>(cloud, all.of(i), i, o); }

  std::vector<Mat<d>> stresses(const std::vector<Vec<d>>& x) const {
    const NeoHookean material(rubber);
    std::vector<Mat<d>> P;
    for (Index i = 0; i < cloud.size(); ++i) {
      Mat<d> F = Mat<d>::Zero();
      for (const auto& b : bonds(i)) F += (x[b.other] - x[i]) * b.stencil.transpose();
      P.push_back(material.first_piola(F));
    }
    return P;
  }

  std::vector<Vec<d>> forces(const std::vector<Vec<d>>& x, bool adjoint) const {
    const auto P = stresses(x);
    std::vector<Vec<d>> f(cloud.size(), Vec<d>::Zero());
    for (Index i = 0; i < cloud.size(); ++i)
      for (const auto& b : bonds(i)) {
        const Index j = b.other;
        if (adjoint) {  // spread over both ends of the bond: V_i f_i += V_i P_i c_ij, V_j f_j -= V_i P_i c_ij
          f[i] += P[i] * b.stencil;
          f[j] -= cloud.V[i] / cloud.V[j] * P[i] * b.stencil;
        } else {  // g_ij = V_j grad W_j(X_i)
          f[i] += 0.5 * (P[i] + P[j]) * b.gradient;
          f[j] -= 0.5 * cloud.V[i] / cloud.V[j] * (P[i] + P[j]) * b.gradient;
        }
      }
    return f;
  }
};

struct Case {
  int cells;
  Layout layout;
  double jitter;
  std::string momentum;
  double beta = 0.9;
};

class Sweeps : public ::testing::TestWithParam<Case> {
 protected:
  template <int d>
  void check() {
    const Case& c = GetParam();
    Scheme scheme;
    scheme.momentum = c.momentum;
    scheme.beta = c.beta;
    Solid<d> solid = rubber_block<d>(d == 2 ? c.cells : c.cells / 2, c.layout, c.jitter, scheme);
    State<d> state = make_state(solid);
    deform(solid, state, 0.1);
    std::vector<Vec<d>> x;
    for (Index i = 0; i < solid.cloud.size(); ++i) x.push_back(position_of(solid, state, i));
    const Plain<d> plain{solid.cloud, options<d>(scheme, solid.cloud.spacing)};
    const auto expected = plain.forces(x, c.momentum == "adjoint");
    const auto found = forces(solid, state);
    ASSERT_EQ(found.size(), expected.size());
    double size = 0, error = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      size = std::max(size, expected[i].norm());
      error = std::max(error, (found[i] - expected[i]).norm());
    }
    EXPECT_LT(error, 1e-13 * size);  // rounding of 30 products; found: up to 2e-14
    EXPECT_GT(size, 0);
  }
};

TEST_P(Sweeps, EqualThePlainLoopsIn2D) {
  check<2>();
}
TEST_P(Sweeps, EqualThePlainLoopsIn3D) {
  check<3>();
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, Sweeps,
    // the last one has so many blocks that stresses take turns in the same memory
    ::testing::Values(Case{21, Layout::cell, 0, "adjoint"}, Case{21, Layout::node, 0, "adjoint"},
                      Case{16, Layout::cell, 0, "symmetrised"}, Case{16, Layout::node, 0, "symmetrised"},
                      // reach beyond half a pack: sums are wanted before the first pack of the body
                      Case{21, Layout::cell, 0, "adjoint", 2.7}, Case{14, Layout::cell, 0.2, "adjoint"},
                      Case{14, Layout::node, 0.2, "symmetrised"}, Case{42, Layout::cell, 0, "adjoint"}));

TEST(Adjoint, ForceIsMinusTheDerivativeOfTheEnergy) {
  for (const double jitter : {0.0, 0.2}) {
    Solid<3> solid = rubber_block<3>(6, Layout::node, jitter);
    State<3> state = make_state(solid);
    deform(solid, state, 0.1);
    const auto f = forces(solid, state);
    const double step = 1e-6;  // central differences: truncation 1e-12, rounding 1e-16 * energy / step
    for (const Index i : {Index{0}, Index{40}, solid.cloud.size() - 1})
      for (int k = 0; k < 3; ++k) {
        double& u = state.u[k][solid.bonds.slots.of(i)];
        const double old = u;
        u = old + step;
        const double above = energy_of(solid, state).strain;
        u = old - step;
        const double below = energy_of(solid, state).strain;
        u = old;
        const double expected = -(above - below) / (2 * step) / solid.cloud.V[i];
        EXPECT_NEAR(f[i][k], expected, 1e-5 * (1e6 + std::abs(expected)))
            << "particle " << i << " component " << k;
      }
  }
}

TEST(Forces, SumToZeroForEveryForm) {
  for (const std::string momentum : {"adjoint", "symmetrised"})
    for (const double jitter : {0.0, 0.2}) {
      Scheme scheme;
      scheme.momentum = momentum;
      Solid<3> solid = rubber_block<3>(7, Layout::cell, jitter, scheme);
      State<3> state = make_state(solid);
      deform(solid, state, 0.2);
      const auto f = forces(solid, state);
      Vec<3> sum = Vec<3>::Zero();
      double scale = 0;
      for (std::size_t i = 0; i < f.size(); ++i) {
        sum += solid.cloud.V[i] * f[i];
        scale += solid.cloud.V[i] * f[i].norm();
      }
      // rounding only: 300 particles with 26 neighbours each
      EXPECT_LT(sum.norm(), 1e-13 * scale) << momentum << " jitter " << jitter;
    }
}

TEST(Sweeps, SameBitsForAnyNumberOfThreads) {
  const auto final_state = [](int threads, double jitter) {
    omp_set_num_threads(threads);
    Solid<3> solid = rubber_block<3>(20, Layout::cell, jitter);  // 27 blocks: enough for threads
    State<3> state = make_state(solid);
    deform(solid, state, 0.05);
    const ChosenIntegrator<3> integrator = integrator_named<3>("rk3", solid);
    for (int step = 0; step < 10; ++step) EXPECT_TRUE(integrator.step(solid, state, 1e-5));
    std::vector<double> values;
    for (Index i = 0; i < solid.cloud.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        values.push_back(state.u[k][solid.bonds.slots.of(i)]);
        values.push_back(state.v[k][solid.bonds.slots.of(i)]);
      }
    values.push_back(energy_of(solid, state).total());
    values.push_back(momentum_of(solid, state).angular[2]);
    omp_set_num_threads(omp_get_num_procs());
    return values;
  };
  for (const double jitter : {0.0, 0.2}) {
    const auto one = final_state(1, jitter);
    EXPECT_EQ(one, final_state(2, jitter));
    EXPECT_EQ(one, final_state(3, jitter));
  }
}

TEST(Evaluate, NamesTheParticleThatIsTurnedInsideOut) {
  Solid<2> solid = rubber_block<2>(10, Layout::cell, 0);
  State<2> state = make_state(solid);
  const Index victim = 44;
  state.u[0][solid.bonds.slots.of(victim + 1)] = -2 * solid.cloud.spacing;  // its neighbour pushed through it
  state.u[0][solid.bonds.slots.of(victim - 1)] = 2 * solid.cloud.spacing;
  Workspace<2> workspace;
  const Outcome outcome = evaluate(solid, workspace, state, 0, [](const Block&, BlockForce<2>&) {});
  ASSERT_FALSE(outcome);
  EXPECT_LE(outcome.trouble->value, 0);
  EXPECT_GE(outcome.trouble->particle, 0);
}

TEST(Evaluate, FindsNotANumber) {
  Solid<2> solid = rubber_block<2>(10, Layout::cell, 0);
  State<2> state = make_state(solid);
  state.u[0][solid.bonds.slots.of(50)] = std::nan("");
  Workspace<2> workspace;
  const Outcome outcome = evaluate(solid, workspace, state, 0, [](const Block&, BlockForce<2>&) {});
  ASSERT_FALSE(outcome);
  EXPECT_TRUE(std::isnan(outcome.trouble->value));
}

TEST(BondTable, SharesRowsOnLatticesAndOnlyThere) {
  // Kinds of particle per axis: cell layout two ends, two next to them and the inside; node layout, where the
  // half volumes are seen from one particle further in, seven. A line has fewer kinds of pack than of
  // particle.
  EXPECT_LE(rubber_block<3>(16, Layout::cell, 0).bonds.rows(), 5 * 5 * 5);
  EXPECT_LE(rubber_block<3>(24, Layout::node, 0).bonds.rows(), 7 * 7 * 7);
  const Solid<3> irregular = rubber_block<3>(8, Layout::cell, 0.2);
  EXPECT_EQ(irregular.bonds.rows(), irregular.cloud.size());
}

}  // namespace
}  // namespace plumb::testing::sweeps_test
