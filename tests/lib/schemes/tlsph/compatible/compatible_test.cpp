// The projected table: antisymmetric, closed, exact; one table for F and the force; patch test with affine
// motion and uniform stress at finite strain, on every cloud. THEORY chapter 11.
#include "lib/schemes/tlsph/compatible/compatible.hpp"

#include <gtest/gtest.h>

#include "lib/schemes/tlsph/compatible/mesh_surface.hpp"
#include "lib/schemes/tlsph/compatible/solver/constraints.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/compatible.hpp"
#include "tests/support/typed.hpp"

namespace plumb::compatible_test {
namespace {

using Kinds = ::testing::Types<test::In<test::Plain, 1>, test::In<test::Plain, 2>, test::In<test::Plain, 3>>;

/// Both ways to treat volumes.
const double volume_weights[] = {CompatibleOptions<1>{}.volume_weight, 0.0};

template <int d>
BondOptions<d> compatible_options(double spacing, double beta, const std::string& momentum,
                                  double volume_weight, std::shared_ptr<CompatibleReport> report = nullptr) {
  testing::Scheme scheme;
  scheme.beta = beta;
  scheme.momentum = momentum;
  BondOptions<d> options = testing::options<d>(scheme, spacing);
  CompatibleOptions<d> how;
  how.volume_weight = volume_weight;
  project_compatible(options, how, report);
  return options;
}

/// On a box.
template <int d>
testing::Projected<d> projected(const Cloud<d>& cloud, double beta, double volume_weight) {
  CompatibleOptions<d> how;
  how.volume_weight = volume_weight;
  return testing::projected<d>(cloud, box_surface<d>(cloud), beta, how);
}

template <class Case>
class Compatible : public ::testing::Test {};
TYPED_TEST_SUITE(Compatible, Kinds, test::Names);

TYPED_TEST(Compatible, IsAntisymmetricClosedAndExact) {
  constexpr int d = TypeParam::d;
  for (const auto& [name, cloud] : test::all_clouds<d>())
    for (const double weight : volume_weights)
      for (const double beta : {0.9, 1.2}) {
        if (weight == 0 && name.starts_with("cell")) continue;  // see FixedVolumesNeedParticlesOnTheSurface
        SCOPED_TRACE(name + ", beta " + std::to_string(beta) + ", volumes " + std::to_string(weight));
        testing::expect_compatible(projected<d>(cloud, beta, weight), cloud.box.size.prod());
      }
}

TYPED_TEST(Compatible, BoundaryVectorsObeyTheDivergenceTheoremForQuadratics) {
  constexpr int d = TypeParam::d;
  test::Numbers numbers(5);
  const RadialKernel<d> kernel = kernel_named<d>("cubic");
  for (const auto& [name, cloud] : test::all_clouds<d>()) {
    const auto found = boundary_vectors<d>(cloud, kernel, 0.9 * cloud.spacing, box_surface<d>(cloud));
    const Vec<d> centre = cloud.box.origin + 0.5 * cloud.box.size;
    for (int c = 0; c < d; ++c) {  // field: component c is (X - point) . S (X - point)
      const Mat<d> S = numbers.matrix<d>();
      const Vec<d> point = numbers.vector<d>();
      double sum = 0, size = 0;
      for (Index i = 0; i < cloud.size(); ++i) {
        const Vec<d> x = cloud.X[i] - point;
        sum += x.dot(S * x) * found.B[i][c];
        size += std::abs(x.dot(S * x) * found.B[i][c]);
      }
      const double exact = cloud.box.size.prod() * ((S + S.transpose()) * (centre - point))[c];
      EXPECT_NEAR(sum, exact, 1e-13 * size) << name;  // sums of some hundred terms
    }
  }
}

// The null space that makes these moments necessary: multipliers l = any quadratic field, L = grad l.
TYPED_TEST(Compatible, QuadraticMultipliersChangeNothing) {
  constexpr int d = TypeParam::d;
  test::Numbers numbers(6);
  const Cloud<d> cloud = test::all_clouds<d>(1.0)[3].cloud;  // in spacings, jittered
  const auto p = projected<d>(cloud, 0.9, 0);
  AreaTable<d> table =
      area_table<d>(p.cloud, p.bonds, kernel_named<d>("cubic"), 0.9 * cloud.spacing, p.boundary);
  Multipliers<d> multipliers(cloud.size(), MultiplierBlock<d>::Zero());
  for (int a = 0; a < d; ++a) {
    const Mat<d> R = numbers.matrix<d>(), S = R + R.transpose();
    const Vec<d> g = numbers.vector<d>();
    for (Index i = 0; i < cloud.size(); ++i) {
      const Vec<d>& X = cloud.X[i];
      multipliers[i](a, 0) = g.dot(X) + X.dot(S * X) / 2;
      multipliers[i].row(a).template tail<d>() = (g + S * X).transpose();
    }
  }
  const AreaTable<d> before = table;
  add_multipliers(table, bond_operator(table, cloud.X, 1e-3), multipliers);
  double change = 0;
  for (std::size_t n = 0; n < table.pairs.size(); ++n)
    change = std::max(change, (table.pairs[n].A - before.pairs[n].A).norm());
  EXPECT_LT(change, 1e-12);  // differences of values of the order of 100
  EXPECT_GT(largest<d>(multipliers), 1);
}

template <class Case>
class CompatibleSolid : public ::testing::Test {};
using Bodies = ::testing::Types<test::In<test::Plain, 2>, test::In<test::Plain, 3>>;
TYPED_TEST_SUITE(CompatibleSolid, Bodies, test::Names);

template <int d>
Solid<d> compatible_block(Layout layout, double jitter, const std::string& momentum, double weight) {
  Cloud<d> cloud = testing::block<d>(7, layout, jitter);
  const auto options = compatible_options<d>(cloud.spacing, 0.9, momentum, weight);
  return make_solid<d>(std::move(cloud), "neo-hookean", testing::rubber, options);
}

TYPED_TEST(CompatibleSolid, SymmetrisedAndAdjointFormAreTheSame) {
  constexpr int d = TypeParam::d;
  for (const double jitter : {0.0, 0.2}) {
    const Solid<d> a = compatible_block<d>(Layout::node, jitter, "adjoint", volume_weights[0]),
                   s = compatible_block<d>(Layout::node, jitter, "symmetrised", volume_weights[0]);
    // the numbers of either form were those of c_ij to 1e-14, or they would have been kept
    EXPECT_TRUE(a.bonds.force.empty());
    EXPECT_TRUE(s.bonds.force.empty());
    EXPECT_FALSE(a.bonds.force_weights().empty());
  }
  const Solid<d> other = testing::rubber_block<d>(7, Layout::node, 0.2);
  EXPECT_EQ(other.bonds.force.size(), other.bonds.stencil.size());
}

// Affine motion at finite strain: F is exact everywhere, and the force on a particle is -P B_i.
TYPED_TEST(CompatibleSolid, PassesThePatchTest) {
  constexpr int d = TypeParam::d;
  test::Numbers numbers(8);
  const Mat<d> A = Mat<d>::Identity() + 0.3 * numbers.matrix<d>();
  for (const Layout layout : {Layout::node, Layout::cell})
    for (const double jitter : {0.0, 0.2, 0.3}) {
      Solid<d> solid = compatible_block<d>(layout, jitter, "adjoint", volume_weights[0]);
      State<d> state = make_state(solid);
      for (Index i = 0; i < solid.cloud.size(); ++i)
        set_vector<d>(state.u, solid.bonds.slots.of(i), (A - Mat<d>::Identity()) * solid.cloud.X[i]);
      Workspace<d> workspace;
      const auto f = testing::forces(solid, state, workspace);
      const auto B = boundary_vectors<d>(testing::block<d>(7, layout, jitter), kernel_named<d>("cubic"),
                                         solid.smoothing_length, box_surface<d>(solid.cloud))
                         .B;
      Mat<d> P;
      for (int a = 0; a < d; ++a)
        for (int b = 0; b < d; ++b) P(a, b) = workspace.P.at(a * d + b, solid.bonds.slots.of(0));
      const double size = P.norm() * std::pow(solid.cloud.spacing, d - 1);
      for (Index i = 0; i < solid.cloud.size(); ++i) {
        EXPECT_LT((deformation_gradient_of(solid, state, i) - A).norm(), 1e-11);
        EXPECT_LT((solid.cloud.V[i] * f[i] + P * B[i]).norm() / size,
                  1e-10);  // the table is projected to 1e-12, and a hundred bonds add up
      }
    }
}

TYPED_TEST(CompatibleSolid, ForceIsMinusTheDerivativeOfTheEnergy) {
  constexpr int d = TypeParam::d;
  Solid<d> solid = compatible_block<d>(Layout::node, 0.2, "symmetrised", volume_weights[0]);
  State<d> state = make_state(solid);
  testing::deform(solid, state, 0.1);
  const auto f = testing::forces(solid, state);
  test::Numbers numbers(9);
  std::vector<Vec<d>> direction;
  double power = 0, size = 0;
  for (Index i = 0; i < solid.cloud.size(); ++i) {
    direction.push_back(numbers.vector<d>());
    power += solid.cloud.V[i] * f[i].dot(direction[i]);
    size += solid.cloud.V[i] * f[i].norm();
  }
  const auto energy_at = [&](double step) {
    State<d> moved = state;
    for (Index i = 0; i < solid.cloud.size(); ++i)
      for (int k = 0; k < d; ++k) moved.u[k][solid.bonds.slots.of(i)] += step * direction[i][k];
    return energy_of(solid, moved).strain;
  };
  const double h = 1e-5 * solid.cloud.spacing;
  const double slope = (energy_at(h) - energy_at(-h)) / (2 * h);
  EXPECT_NEAR(slope, -power, 1e-6 * size);  // step^2 and round-off/step, both about 1e-10 of the energy
}

TEST(MeshSurface, OfATetrahedron) {
  Cloud<3> cloud;
  cloud.X = {Vec<3>(1, 0, 0), Vec<3>(3, 0, 0), Vec<3>(1, 1, 0), Vec<3>(1, 0, 1)};
  const Surface<3> surface = mesh_surface<3>(cloud, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  EXPECT_NEAR(surface.volume, 2.0 / 6, 1e-15);
  EXPECT_LT((surface.centroid - Vec<3>(1.5, 0.25, 0.25)).norm(), 1e-15);
  Vec<3> sum = Vec<3>::Zero();
  for (const auto& facet : surface.facets) sum += facet.area;
  EXPECT_LT(sum.norm(), 1e-15);
}

TEST(CompatibleErrors, ASurfaceThatDoesNotCloseIsRefused) {
  Cloud<2> cloud = testing::block<2>(7, Layout::node, 0.2);
  BondOptions<2> options = testing::options<2>({}, cloud.spacing);
  CompatibleOptions<2> how;
  how.surface = [](const Cloud<2>& c) {
    Surface<2> surface = box_surface(c);
    std::erase_if(surface.facets, [](const Facet<2>& f) { return f.area[0] != 0; });
    return surface;
  };
  project_compatible(options, how);
  EXPECT_THROW(make_bond_table<2>(cloud, options), InputError);
}

// In 1D closedness alone determines the area vectors and so the volumes: 3/4, 5/4, 1, .. spacings on a cell
// layout.
TEST(CompatibleErrors, FixedVolumesNeedParticlesOnTheSurface) {
  Cloud<1> cloud = test::small_lattice<1>(Layout::cell, 1.0);
  EXPECT_THROW(projected<1>(cloud, 0.9, 0), InputError);
  const auto p = projected<1>(cloud, 0.9, volume_weights[0]);
  EXPECT_NEAR(p.cloud.V[0], 0.75, 1e-12);
  EXPECT_NEAR(p.cloud.V[1], 1.25, 1e-12);
  EXPECT_NEAR(p.cloud.V[2], 1, 1e-12);
}

TEST(CompatibleErrors, TooFewNeighboursAreRefused) {
  Cloud<2> cloud = testing::block<2>(7, Layout::node, 0.3);
  const BondOptions<2> options = compatible_options<2>(cloud.spacing, 0.55, "adjoint", volume_weights[0]);
  EXPECT_THROW(make_bond_table<2>(cloud, options), InputError);
}

}  // namespace
}  // namespace plumb::compatible_test
