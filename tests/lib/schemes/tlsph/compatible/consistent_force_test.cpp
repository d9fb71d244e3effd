#include "lib/schemes/tlsph/compatible/consistent_force.hpp"

#include <gtest/gtest.h>

#include "lib/geometry/layout.hpp"
#include "lib/material/models/neo_hookean.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"
#include "tests/support/solids.hpp"

namespace plumb {
namespace {

template <int d>
Cloud<d> cloud_of(double jitter) {
  const Box<d> box{Vec<d>::Zero(), Vec<d>::Constant(0.8)};
  Cloud<d> cloud = lattice<d>(box, cells_of<d>(box, 0.1), Layout::node);
  return jitter > 0 ? jittered<d>(std::move(cloud), jitter, 3, Layout::node) : cloud;
}

template <int d>
BondOptions<d> options_of() {
  BondOptions<d> options;
  options.kernel = kernel_named<d>("cubic");
  options.smoothing_length = 0.09;
  options.pair = Correction::W1;
  options.estimator = estimator_named<d>("improved");
  options.momentum = momentum_form_named<d>("adjoint");
  return options;
}

/// Force per volume on particle i under the uniform stress I.
template <int d>
Vec<d> force_under_unit_stress(const BondTable<d>& t, Index particle) {
  const Index i = t.slots.of(particle), row = t.row[i / t.width], lane = i % t.width;
  Vec<d> sum;
  for (int k = 0; k < d; ++k) sum[k] = t.own_force[(row * d + k) * t.width + lane];
  for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n)
    for (int k = 0; k < d; ++k) sum[k] += t.force[(n * d + k) * t.width + lane];
  return sum;
}

template <int d>
void uniform_stress_leaves_boundary_areas_only(double jitter) {
  Cloud<d> cloud = cloud_of<d>(jitter);
  BondOptions<d> options = options_of<d>();
  const Surface<d> surface = box_surface<d>(cloud);
  const auto B = boundary_vectors<d>(cloud, options.kernel, options.smoothing_length, surface).B;
  const BondTable<d> plain = make_bond_table<d>(cloud, options);
  make_force_consistent<d>(options, cloud, surface);
  const BondTable<d> mended = make_bond_table<d>(cloud, options);
  double worst = 0, before = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    // in units of 1/spacing: round-off of some tens of terms of order 1
    worst = std::max(worst, (force_under_unit_stress(mended, i) + B[i] / cloud.V[i]).norm() * 0.1);
    before = std::max(before, (force_under_unit_stress(plain, i) + B[i] / cloud.V[i]).norm() * 0.1);
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_GT(before, 0.1);
}

TEST(ConsistentForce, UniformStressLeavesTheBoundaryAreasOnly) {
  for (double jitter : {0.0, 0.2}) {
    uniform_stress_leaves_boundary_areas_only<2>(jitter);
    uniform_stress_leaves_boundary_areas_only<3>(jitter);
  }
}

/// Without a known surface the particles' own estimate is closed all the same: under a uniform stress the
/// force is -P B_i with the estimate's B_i, and nothing inside.
template <int d>
void estimated_surface_leaves_its_own_areas(double jitter) {
  const double side = 0.8;
  Scene scene;
  scene.dimension = d;
  scene.max_steps = 1;
  scene.body.size.assign(d, side);
  scene.body.spacing = 0.1;
  scene.body.layout = Layout::cell;
  scene.body.jitter = jitter;
  scene.material = {"neo-hookean", 17e6, 0.3, 1100};
  scene.method.momentum = "variational";
  scene.method.gradient = "improved";
  scene.method.compatible.surface = "estimated";
  auto made = make_tlsph<d>(scene);
  EXPECT_EQ(made.warnings.size(), 1U);
  Solid<d>& solid = made.solid;
  Mat<d> G = Mat<d>::Constant(0.1);
  G(0, 0) = 0.3;
  for (Index i = 0; i < solid.cloud.size(); ++i)
    set_vector<d>(made.state.u, solid.bonds.slots.of(i), G * solid.cloud.X[i]);
  const auto f = testing::forces(solid, made.state);
  const Shape<d> shape = shape_around(solid.cloud);
  const auto B = boundary_vectors<d>(solid.cloud, kernel_named<d>("cubic"), solid.smoothing_length,
                                     clipped_surface<d>(solid.cloud, shape))
                     .B;
  const NeoHookean material(solid.elastic);
  const Mat<d> P = material.first_piola(Mat<d>(Mat<d>::Identity() + G));
  const double size = P.norm() * std::pow(0.1, d - 1);
  double worst = 0, flux = 0;
  Index inside = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    worst = std::max(worst, (solid.cloud.V[i] * f[i] + P * B[i]).norm() / size);
    flux += B[i].dot(solid.cloud.X[i]);
    inside += B[i].norm() < 1e-12;
  }
  EXPECT_LT(worst, 1e-12);  // round-off of some tens of terms of order 1
  if (d == 2) {             // the body in space is too small to have an inside
    EXPECT_GT(inside, 0);
  }
  // the divergence theorem gives d times the volume; corners and edges of the estimate are rounded
  EXPECT_NEAR(flux / (d * std::pow(side, d)), 1, 0.1);
}

TEST(ConsistentForce, WithAnEstimatedSurface) {
  for (const double jitter : {0.0, 0.2}) {
    estimated_surface_leaves_its_own_areas<2>(jitter);
  }
}

// F is not touched: both tables of an irregular cloud hold the same stencils, bit by bit.
TEST(ConsistentForce, LeavesTheDeformationGradientAlone) {
  Cloud<2> cloud = cloud_of<2>(0.2);
  BondOptions<2> options = options_of<2>();
  const BondTable<2> plain = make_bond_table<2>(cloud, options);
  make_force_consistent<2>(options, cloud, box_surface<2>(cloud));
  const BondTable<2> mended = make_bond_table<2>(cloud, options);
  ASSERT_EQ(plain.stencil.size(), mended.stencil.size());
  for (std::size_t n = 0; n < plain.stencil.size(); ++n) EXPECT_EQ(plain.stencil[n], mended.stencil[n]);
}

// What is paid for it: forces of pairs are not opposite, so momentum is not kept. The adjoint form keeps it.
TEST(ConsistentForce, DoesNotKeepLinearMomentum) {
  Cloud<2> cloud = cloud_of<2>(0.2);
  BondOptions<2> options = options_of<2>();
  const auto imbalance = [&](const BondTable<2>& t) {
    double worst = 0;  // of what the stress of one particle does to all others and itself, in V/spacing
    std::vector<Vec<2>> total(cloud.X.size(), Vec<2>::Zero());
    for (Index i = 0; i < cloud.size(); ++i) {
      const Index row = t.row[t.slots.of(i)];
      total[i] += cloud.V[i] * Vec<2>(t.own_force[row * 2], t.own_force[row * 2 + 1]);
      for (std::int64_t n = t.begin[row]; n < t.begin[row + 1]; ++n)
        total[i + t.offset[n]] += cloud.V[i] * Vec<2>(t.force[n * 2], t.force[n * 2 + 1]);
    }
    for (const Vec<2>& sum : total) worst = std::max(worst, sum.norm() / 0.1);
    return worst;
  };
  EXPECT_LT(imbalance(make_bond_table<2>(cloud, options)), 1e-13);
  make_force_consistent<2>(options, cloud, box_surface<2>(cloud));
  EXPECT_GT(imbalance(make_bond_table<2>(cloud, options)), 1e-3);
}

TEST(ConsistentForce, IsRefusedWhereItHasNothingToDo) {
  const std::string scene = R"([scene]
dimension = 2
max_steps = 1
[body]
shape = "box"
size = [1, 1]
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[method]
momentum = "variational"
)";
  EXPECT_NO_THROW(make_tlsph<2>(parse_scene(scene, "test.toml")));
  try {
    parse_scene(scene, "test.toml", {"method.gradient=compatible"});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("adjoint"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace plumb
