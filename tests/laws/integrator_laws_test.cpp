// Every integrator of the catalogue has the order in time that it claims, on a deforming body under a load
// that varies in time.
#include "lib/schemes/tlsph/time/integrator.hpp"

#include <gtest/gtest.h>

#include "tests/support/solids.hpp"

namespace plumb::integrator_laws_test {
namespace {

template <class>
struct AsTypes;
template <class... Ts>
struct AsTypes<TypeList<Ts...>> {
  using type = ::testing::Types<Ts...>;
};

struct Name {
  template <class T>
  static std::string GetName(int) {
    return std::string(T::name);
  }
};

constexpr double end = 2e-3;  // [s]: two thirds of the time in which a wave crosses the block

/// A load [N/m^3] with a period of 1.3 ms: a scheme that takes it at the wrong stage times falls to first
/// order.
Term<2> load(const Solid<2>& solid) {
  Term<2> term;
  term.name = "load";
  std::vector<Index> slots;
  for (Index i = 0; i < solid.cloud.size(); ++i) slots.push_back(solid.bonds.slots.of(i));
  term.second = [slots](const Solid<2>&, const Block& block, const Instant<2>& now, BlockForce<2>& force) {
    for (const Index slot : slots)
      if (slot >= block.begin() && slot < block.end())
        force(1, slot) += 3e6 * std::cos(2 * 3.14159 * now.time / 1.3e-3);
  };
  return term;
}

/// Displacements at the end after n steps.
template <class T>
std::vector<Vec<2>> displacements(int n) {
  Solid<2> solid = testing::rubber_block<2>(6, Layout::node, 0.1);
  add_term(solid, load(solid));
  State<2> state = make_state(solid);
  testing::deform(solid, state, 0.05);  // released from a strained state: the stress drives the motion too
  typename T::template Integrator<2> integrator(solid);
  Workspace<2> workspace;
  for (int k = 0; k < n; ++k)
    if (!integrator.step(solid, workspace, state, end / n))
      throw std::runtime_error("the test's motion is not sound");
  std::vector<Vec<2>> u;
  for (Index i = 0; i < solid.cloud.size(); ++i) u.push_back(vector_at<2>(state.u, solid.bonds.slots.of(i)));
  return u;
}

double distance(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

template <class T>
class IntegratorLaws : public ::testing::Test {};
TYPED_TEST_SUITE(IntegratorLaws, AsTypes<IntegratorCatalogue>::type, Name);

TYPED_TEST(IntegratorLaws, MeasuredOrderIsTheClaimedOne) {
  constexpr int claimed = TypeParam::template Integrator<2>::order;
  // differences of neighbouring step counts instead of a fine reference: their ratio is 2^p without bias
  const auto u1 = displacements<TypeParam>(80), u2 = displacements<TypeParam>(160),
             u4 = displacements<TypeParam>(320);
  const double order = std::log2(distance(u1, u2) / distance(u2, u4));
  EXPECT_NEAR(order, claimed, 0.2) << distance(u1, u2) << ", "
                                   << distance(u2, u4);  // the next term, and no more
}

TYPED_TEST(IntegratorLaws, CountsItsEvaluations) {
  using Integrator = typename TypeParam::template Integrator<2>;
  Solid<2> solid = testing::rubber_block<2>(4, Layout::node, 0);
  State<2> state = make_state(solid);
  Integrator integrator(solid);
  Workspace<2> workspace;
  integrator.step(solid, workspace, state, 1e-6);  // the first step may need one more
  const auto before = workspace.work.particle_evaluations;
  for (int k = 0; k < 5; ++k) integrator.step(solid, workspace, state, 1e-6);
  EXPECT_EQ(workspace.work.particle_evaluations - before,
            5 * Integrator::evaluations_per_step * solid.cloud.size());
  EXPECT_EQ(state.step, 6);
  EXPECT_NEAR(state.time, 6e-6, 1e-18);
}

/// A force that makes every component follow y' = lambda y in its velocity (damping, lambda = -rate) or in
/// displacement and velocity (an oscillator, lambda = i rate).
Term<2> linear_force(double rate, bool oscillates) {
  Term<2> term;
  term.name = "linear force";
  term.second = [rate, oscillates](const Solid<2>& solid, const Block& block, const Instant<2>& now,
                                   BlockForce<2>& force) {
    const State<2>& state = now.state;
    const double rho = solid.elastic.density;
    for (int k = 0; k < 2; ++k)
      for (Index i = block.begin(); i < block.end(); ++i)
        force(k, i) -= oscillates ? rho * rate * rate * state.u[k][i] : rho * rate * state.v[k][i];
  };
  return term;
}

/// Whether the motion grows without bound at lambda dt of this size. The step is so short that the body's own
/// stiffness adds 1e-6 of that.
template <class T>
bool grows(double lambda_dt, bool oscillates) {
  constexpr double dt = 1e-9;
  Solid<2> solid = testing::rubber_block<2>(4, Layout::node, 0);
  add_term(solid, linear_force(lambda_dt / dt, oscillates));
  State<2> state = make_state(solid);
  const Index probe = solid.bonds.slots.of(5);
  state.v[0][probe] = 1e-6;
  typename T::template Integrator<2> integrator(solid);
  Workspace<2> workspace;
  for (int step = 0; step < 400; ++step)
    if (!integrator.step(solid, workspace, state, dt)) return true;
  const double speed = std::abs(state.v[0][probe]), position = std::abs(state.u[0][probe]) * lambda_dt / dt;
  // a bounded oscillation near its limit has at most 1/sqrt(1 - 0.98^2) = 5 times its first amplitude
  return speed > 1e-4 || (oscillates && position > 1e-4);
}

// 2 % on either side: 400 steps then make at least 500 times of a growing motion
TYPED_TEST(IntegratorLaws, StabilityLimitsAreThoseOfTheTestEquation) {
  const StabilityLimits limits = stability_limits(TypeParam::name);
  EXPECT_FALSE(grows<TypeParam>(0.98 * limits.real_axis, false));
  EXPECT_TRUE(grows<TypeParam>(1.02 * limits.real_axis, false));
  EXPECT_FALSE(grows<TypeParam>(0.98 * limits.imaginary_axis, true));
  EXPECT_TRUE(grows<TypeParam>(1.02 * limits.imaginary_axis, true));
}

}  // namespace
}  // namespace plumb::integrator_laws_test
