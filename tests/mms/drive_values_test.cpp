// What drives a body, particle by particle: its force with the drive less that without is the body force, the
// traction times the particle's share of each face over its volume, and density times acceleration where the
// motion is prescribed.
#include <gtest/gtest.h>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "mms/annulus.hpp"
#include "mms/drive.hpp"
#include "tests/support/solids.hpp"

namespace plumb::mms {
namespace {

using plumb::testing::forces;

template <int d>
Cloud<d> cloud_of(const Manufactured<d>& solution, double spacing, Layout layout) {
  return lattice<d>(solution.domain.box, cells_of<d>(solution.domain.box, spacing), layout);
}

template <int d>
Solid<d> solid_of(const Cloud<d>& cloud) {
  return make_solid<d>(cloud, "neo-hookean", plumb::testing::rubber,
                       plumb::testing::options<d>({}, cloud.spacing));
}

/// The outermost layer of a face, which is its node layer or half a cell inside.
template <int d>
bool on_face(const Cloud<d>& cloud, Index i, int face) {
  const int axis = face / 2;
  const double wall = cloud.box.origin[axis] + (face % 2) * cloud.box.size[axis];
  return std::abs(cloud.X[i][axis] - wall) < 0.6 * cloud.spacing;
}

template <int d>
void expect_drive(const char* name, double spacing, Layout layout, bool body_force) {
  SCOPED_TRACE(std::string(name) + (layout == Layout::node ? " node" : " cell"));
  const auto solution = manufactured<d>(name, {}, plumb::testing::rubber);
  const Cloud<d> cloud = cloud_of(solution, spacing, layout);
  Solid<d> plain = solid_of(cloud), driven = solid_of(cloud);
  State<d> state = make_state(driven);
  state.time = 0.21 * solution.period;
  drive(driven, state, ChosenIntegrator<d>{}, solution, {layout, body_force});
  State<d> other = make_state(plain);
  other.u = state.u, other.v = state.v, other.time = state.time;
  const auto with = forces(driven, state), without = forces(plain, other);
  const double t = state.time;
  double size = 0;
  for (const auto& f : with) size = std::max(size, f.norm());
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vec<d>& X = cloud.X[i];
    Vec<d> expected = without[i];
    if (body_force) expected += solution.body_force(X, t);
    std::array<bool, d> held{};
    Vec<d> motion = solution.motion(X, t).acceleration, u = solution.displacement(X, t),
           v = solution.velocity(X, t);
    for (int face = 0; face < 2 * d; ++face) {
      if (!on_face(cloud, i, face)) continue;
      const int axis = face / 2;
      Vec<d> at = X, N = Vec<d>::Zero();
      at[axis] = cloud.box.origin[axis] + (face % 2) * cloud.box.size[axis];
      N[axis] = face % 2 ? 1 : -1;
      // V over the particle's own extent normal to the face: half a spacing for nodes on it
      const double extent = layout == Layout::node ? spacing / 2 : spacing;
      if (body_force) expected += solution.traction(at, t, N) / extent;
      const auto condition = solution.domain.faces[static_cast<std::size_t>(face)];
      for (int k = 0; k < d; ++k)
        if ((k == axis ? condition.normal : condition.tangential) == Known::displacement) {
          held[static_cast<std::size_t>(k)] = true;
          motion[k] = solution.motion(at, t).acceleration[k];
          u[k] = solution.displacement(at, t)[k], v[k] = solution.velocity(at, t)[k];
        }
    }
    for (int k = 0; k < d; ++k)
      if (held[static_cast<std::size_t>(k)]) expected[k] = 1100 * motion[k];
    EXPECT_LT((with[i] - expected).norm(), 1e-11 * size) << "particle " << i << " at " << X.transpose();
    EXPECT_LT((vector_at<d>(state.u, driven.bonds.slots.of(i)) - u).norm(), 1e-15) << i;
    EXPECT_LT((vector_at<d>(state.v, driven.bonds.slots.of(i)) - v).norm(), 1e-12) << i;
  }
}

TEST(DriveValues, AreBodyForceTractionAndPrescribedMotion) {
  for (const bool body_force : {true, false}) {
    for (const Layout layout : {Layout::node, Layout::cell}) {
      if (body_force) {  // the loads of the printed field are none
        expect_drive<2>("stretched-column", 0.25, layout, body_force);
        expect_drive<3>("stretched-column", 0.25, layout, body_force);
        expect_drive<2>("rigid-rotation", 0.125, layout, body_force);
      }
      expect_drive<2>("swinging-plate", 0.25, layout, body_force);
      expect_drive<2>("affine-patch", 0.125, layout, body_force);
      expect_drive<2>("travelling-wave", 0.125, layout, body_force);
      expect_drive<3>("trigonometric-cube", 0.2, layout, body_force);
    }
  }
}

/// Ring k of m + 1, of n particles: at its radius and angle, with the area of its sector.
TEST(PolarCloudValues, AreRingsOfSectors) {
  const Cloud<2> cloud = polar_cloud(0.75, 1.25, 0.1);
  const int rings = 6, around = 63;  // 5 steps of 0.1 m; 2 pi / 0.1
  ASSERT_EQ(cloud.size(), rings * around);
  for (int k = 0; k < rings; ++k)
    for (int m = 0; m < around; ++m) {
      const double R = 0.75 + 0.1 * k, angle = 2 * 3.141592653589793 * m / around;
      const double low = k == 0 ? R : R - 0.05, high = k == rings - 1 ? R : R + 0.05;
      const Index i = k * around + m;
      EXPECT_LT((cloud.X[i] - Vec<2>(R * std::cos(angle), R * std::sin(angle))).norm(), 1e-14);
      EXPECT_NEAR(cloud.V[i], 3.141592653589793 * (high * high - low * low) / around, 1e-15);
    }
  EXPECT_EQ(cloud.box.origin, Vec<2>(-1.25, -1.25));
  EXPECT_EQ(cloud.box.size, Vec<2>(2.5, 2.5));
  EXPECT_NO_THROW(polar_cloud(0.75, 1.25, 0.25));  // two layers are enough
  EXPECT_THROW(polar_cloud(0.75, 1.25, 0.2501), InputError);
  EXPECT_THROW(polar_cloud(0, 1.25, 0.1), InputError);
}

}  // namespace
}  // namespace plumb::mms
