// The hourglass energy: its force is minus its derivative, it does not see affine motion, it turns with the
// body, momenta stay exact; a scene without it has no trace of it. THEORY chapter 12.
#include "lib/schemes/tlsph/parts/hourglass.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/loops/linearise.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/solids.hpp"
#include "tests/support/typed.hpp"

namespace plumb {
namespace {

template <class Case>
class HourglassLaws : public ::testing::Test {};
using Bodies = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(HourglassLaws, Bodies, test::Names);

template <int d>
Solid<d> body(double jitter, bool compatible, double alpha = 0.7) {
  Cloud<d> cloud = testing::block<d>(6, Layout::node, jitter);
  BondOptions<d> options = testing::options<d>({}, cloud.spacing);
  if (compatible) project_compatible(options);
  Solid<d> solid = make_solid<d>(std::move(cloud), "neo-hookean", testing::rubber, options);
  if (alpha > 0) add_term(solid, hourglass_term(solid, options.kernel, alpha));
  return solid;
}

/// Forces per particle [N].
template <int d>
std::vector<Vec<d>> forces(Solid<d>& solid, State<d>& state) {
  auto f = testing::forces(solid, state);
  for (Index i = 0; i < solid.cloud.size(); ++i) f[i] *= solid.cloud.V[i];
  return f;
}

TYPED_TEST(HourglassLaws, ForceIsMinusTheDerivativeOfTheEnergy) {
  constexpr int d = TypeParam::d;
  for (const double jitter : {0.0, 0.2})
    for (const bool compatible : {false, true}) {
      Solid<d> with = body<d>(jitter, compatible), without = body<d>(jitter, compatible, 0);
      State<d> state = make_state(with);
      testing::deform(with, state, 0.1);
      const auto f = forces(with, state), g = forces(without, state);
      test::Numbers numbers(4);
      State<d> ahead = state, behind = state;
      double power = 0, size = 0;
      const double step =
          1e-4 * with.cloud.spacing;  // the energy is quadratic: differences have no other error
      for (Index i = 0; i < with.cloud.size(); ++i) {
        const Vec<d> n = numbers.vector<d>();
        const Index slot = with.bonds.slots.of(i);
        power += (f[i] - g[i]).dot(n);
        size += (f[i] - g[i]).norm();
        for (int k = 0; k < d; ++k) {
          ahead.u[k][slot] += step * n[k];
          behind.u[k][slot] -= step * n[k];
        }
      }
      const auto& energy = with.terms[0].energy;
      const double slope = (energy(with, ahead) - energy(with, behind)) / (2 * step);
      EXPECT_NEAR(slope, -power, 1e-9 * size);  // round-off over the step
      EXPECT_GT(std::abs(power), 1e-3 * size);
    }
}

TYPED_TEST(HourglassLaws, AffineMotionCostsNothing) {
  constexpr int d = TypeParam::d;
  test::Numbers numbers(5);
  const Mat<d> G = 0.3 * numbers.matrix<d>();
  for (const double jitter : {0.0, 0.2}) {
    Solid<d> with = body<d>(jitter, true), without = body<d>(jitter, true, 0);
    State<d> state = make_state(with);
    for (Index i = 0; i < with.cloud.size(); ++i)
      set_vector<d>(state.u, with.bonds.slots.of(i), G * with.cloud.X[i] + Vec<d>::Ones());
    const auto f = forces(with, state), g = forces(without, state);
    const double size = testing::rubber.shear_modulus() * std::pow(with.cloud.spacing, d - 1);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_LT((f[i] - g[i]).norm(), 1e-12 * size) << i;
    EXPECT_LT(energy_of(with, state).elsewhere(), 1e-24 * size * with.cloud.spacing);  // a square of 1e-12
  }
}

TYPED_TEST(HourglassLaws, TurnsWithTheBodyAndKeepsMomenta) {
  constexpr int d = TypeParam::d;
  Solid<d> solid = body<d>(0.2, true);
  State<d> state = make_state(solid);
  testing::deform(solid, state, 0.1);
  const auto f = forces(solid, state);
  Mat<d> Q = Mat<d>::Identity();
  Q.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(0.9).toRotationMatrix();
  State<d> turned = state;
  Vec<d> sum = Vec<d>::Zero();
  Mat<d> torque = Mat<d>::Zero();
  double size = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    const Vec<d> x = position_of(solid, state, i);
    set_vector<d>(turned.u, solid.bonds.slots.of(i), Q * x - solid.cloud.X[i]);
    sum += f[i];
    torque += x * f[i].transpose() - f[i] * x.transpose();
    size += f[i].norm();
  }
  const double energy = energy_of(solid, state).elsewhere();
  EXPECT_NEAR(energy_of(solid, turned).elsewhere(), energy, 1e-11 * energy);
  EXPECT_LT(sum.norm(), 1e-13 * size);     // sums of some hundred terms
  EXPECT_LT(torque.norm(), 1e-13 * size);  // positions are of order 1 m
  const auto g = forces(solid, turned);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_LT((g[i] - Q * f[i]).norm(), 1e-10 * size) << i;
}

TYPED_TEST(HourglassLaws, StiffnessIsTheDerivativeOfTheForce) {
  constexpr int d = TypeParam::d;
  Solid<d> with = body<d>(0.2, true), without = body<d>(0.2, true, 0);
  const SparseMatrix K = linearise(with).stiffness - linearise(without).stiffness;
  State<d> state = make_state(with);
  Eigen::VectorXd u(K.rows());
  test::Numbers numbers(6);
  for (Index i = 0; i < with.cloud.size(); ++i) {
    const Vec<d> n = 1e-3 * with.cloud.spacing * numbers.vector<d>();
    u.segment<d>(d * i) = n;
    set_vector<d>(state.u, with.bonds.slots.of(i), n);
  }
  const auto f = forces(with, state), g = forces(without, state);
  const Eigen::VectorXd expected = -K * u;
  for (Index i = 0; i < with.cloud.size(); ++i)  // the force is linear in u; forces of 1e3 times it cancel
    EXPECT_LT((f[i] - g[i] - expected.segment<d>(d * i)).norm(), 1e-9 * expected.norm()) << i;
}

}  // namespace
}  // namespace plumb
