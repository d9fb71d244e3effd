// Mirror images behind rollers: a body with them against the whole body that it is a part of, in which every
// image is a particle and no loop knows of images.
#include "lib/schemes/tlsph/loops/mirror.hpp"

#include <gtest/gtest.h>

#include "lib/schemes/tlsph/loops/linearise.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/parts/jst.hpp"
#include "tests/support/solids.hpp"

namespace plumb::testing {
namespace {

struct Case {
  std::string name;
  double jitter;
  std::string momentum, estimator;
  double beta;
  bool transpose;  ///< outer level of JST
};

template <int d>
struct Bodies {
  Solid<d> part, whole;
  State<d> of_part, of_whole;
  std::vector<Ghost<d>> ghosts;
};

/// Walls at x-, x+ and y-: a face, an opposite face, edges where they meet. With x+ the images are three
/// bodies wide, and what the outer ones do at their far ends is too far to be seen.
const std::vector<Wall> walls{{0, false}, {0, true}, {1, false}};

template <int d>
Bodies<d> bodies(const Case& c) {
  const auto cloud = block<d>(d == 2 ? 12 : 7, Layout::cell, c.jitter);
  Scheme scheme{c.estimator, c.momentum, plumb::Correction::W1, c.beta, true};
  auto how = options<d>(scheme, cloud.spacing);
  how.outer_transpose = c.transpose;
  Bodies<d> pair;
  pair.ghosts = ghosts_behind(cloud, walls, cloud.box.size[0]);
  pair.whole = make_solid<d>(with_ghosts(cloud, pair.ghosts), "neo-hookean", rubber, how);
  how.walls = walls;
  pair.part = make_solid<d>(cloud, "neo-hookean", rubber, how);
  pair.of_part = make_state(pair.part);
  pair.of_whole = make_state(pair.whole);
  deform(pair.part, pair.of_part, 0.01);  // not zero at the walls: the whole body has a kink there
  for (Index i = 0; i < cloud.size(); ++i) {
    Vec<d> v;
    for (int k = 0; k < d; ++k) v[k] = std::cos(3 * cloud.X[i][k] + static_cast<double>(i));
    set_vector<d>(pair.of_part.v, pair.part.bonds.slots.of(i), v);
  }
  for (Index i = 0; i < pair.whole.cloud.size(); ++i) {
    const bool image = i >= cloud.size();
    const Index slot = pair.part.bonds.slots.of(image ? pair.ghosts[i - cloud.size()].real : i);
    const Vec<d> signs = image ? signs_of(pair.ghosts[i - cloud.size()]) : Vec<d>(Vec<d>::Ones());
    set_vector<d>(pair.of_whole.u, i, signs.cwiseProduct(vector_at<d>(pair.of_part.u, slot)));
    set_vector<d>(pair.of_whole.v, i, signs.cwiseProduct(vector_at<d>(pair.of_part.v, slot)));
  }
  return pair;
}

const std::vector<Case> cases{{"lattice", 0, "adjoint", "improved", 0.9, false},
                              {"lattice, (22)", 0, "symmetrised", "standard", 0.9, true},
                              {"lattice, wide", 0, "adjoint", "standard", 1.5, false},
                              {"jitter", 0.2, "adjoint", "improved", 0.9, true},
                              {"jitter, (22)", 0.2, "symmetrised", "improved", 1.2, false}};

/// Sums of some hundred products in another order, relative to the largest: 1e-13; a hundred times that
/// where they are differences of larger ones (force from stress, twice the Laplacian).
template <int d>
void expect_equal_forces(const Case& c, bool jst) {
  Bodies<d> pair = bodies<d>(c);
  if (jst)
    for (Solid<d>* solid : {&pair.part, &pair.whole})
      add_term(*solid, jst_term(*solid, JstOptions{0.3, 0.125}));
  const auto part = forces(pair.part, pair.of_part), whole = forces(pair.whole, pair.of_whole);
  double worst = 0, size = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    worst = std::max(worst, (part[i] - whole[i]).norm());
    size = std::max(size, part[i].norm());
  }
  EXPECT_LT(worst, 1e-11 * size) << d << "D " << c.name << (jst ? " with JST" : "");
}

TEST(Mirror, ForcesAreThoseOfTheWholeBody) {
  for (const Case& c : cases)
    for (const bool jst : {false, true}) {
      expect_equal_forces<2>(c, jst);
      expect_equal_forces<3>(c, jst);
    }
}

template <int d>
void expect_equal_gradients(const Case& c) {
  const Bodies<d> pair = bodies<d>(c);
  double worst = 0;
  for (Index i = 0; i < pair.part.cloud.size(); ++i)
    worst = std::max(worst, (deformation_gradient_of(pair.part, pair.of_part, i) -
                             deformation_gradient_of(pair.whole, pair.of_whole, i))
                                .norm());
  EXPECT_LT(worst, 1e-12) << d << "D " << c.name;
}

TEST(Mirror, DeformationGradientsAreThoseOfTheWholeBody) {
  for (const Case& c : cases) {
    expect_equal_gradients<2>(c);
    expect_equal_gradients<3>(c);
  }
}

/// The packed loops and the plain one find the same strain energy, and so does the whole body of two halves.
TEST(Mirror, EnergyIsHalfOfTheWholeBody) {
  for (const double jitter : {0.0, 0.2}) {
    const auto cloud = block<2>(12, Layout::cell, jitter);
    auto how = options<2>(Scheme{}, cloud.spacing);
    const auto ghosts = ghosts_behind<2>(cloud, {{1, true}}, 2.0);
    Solid<2> whole = make_solid<2>(with_ghosts(cloud, ghosts), "neo-hookean", rubber, how);
    how.walls = {{1, true}};
    Solid<2> part = make_solid<2>(cloud, "neo-hookean", rubber, how);
    State<2> of_part = make_state(part), of_whole = make_state(whole);
    deform(part, of_part, 0.01);
    for (Index i = 0; i < whole.cloud.size(); ++i) {
      const bool image = i >= cloud.size();
      const Index slot = part.bonds.slots.of(image ? ghosts[i - cloud.size()].real : i);
      const Vec<2> u = vector_at<2>(of_part.u, slot);
      set_vector<2>(of_whole.u, i, image ? Vec<2>(u[0], -u[1]) : u);
    }
    const double half = energy_of(part, of_part).strain, full = energy_of(whole, of_whole).strain;
    EXPECT_NEAR(full, 2 * half, 1e-12 * full);  // a sum of some hundred energies
  }
}

/// Fields with the symmetry of the walls, u_x = 0 at x = 0, u_y = 0 at y = 0: exact at every particle.
template <int d>
void expect_exact(double jitter) {
  const auto cloud = block<d>(d == 2 ? 8 : 6, Layout::cell, jitter);
  for (const char* estimator : {"standard", "improved"}) {
    auto how = options<d>(Scheme{estimator}, cloud.spacing);
    how.walls = {{0, false}, {1, false}};
    const Solid<d> solid = make_solid<d>(cloud, "neo-hookean", rubber, how);
    State<d> state = make_state(solid);
    Mat<d> G = Mat<d>::Zero();
    for (int k = 0; k < d; ++k) G(k, k) = 0.1 * (k + 1);
    if (d == 3) G(2, 2) = -0.2;
    for (Index i = 0; i < cloud.size(); ++i) set_vector<d>(state.u, solid.bonds.slots.of(i), G * cloud.X[i]);
    for (Index i = 0; i < cloud.size(); ++i)  // some twenty products of order 1
      EXPECT_LT((deformation_gradient_of(solid, state, i) - Mat<d>::Identity() - G).norm(), 1e-13) << i;
  }
}

TEST(Mirror, SymmetricLinearFieldsAreExactAtWallsAndCorners) {
  for (const double jitter : {0.0, 0.2}) {
    expect_exact<2>(jitter);
    expect_exact<3>(jitter);
  }
}

/// The matrix of small motions acts as the loops do, and is symmetric for the adjoint force.
TEST(Mirror, LinearisedForceIsTheDerivative) {
  for (const double jitter : {0.0, 0.2}) {
    const auto cloud = block<2>(7, Layout::cell, jitter);
    auto how = options<2>(Scheme{}, cloud.spacing);
    how.walls = {{0, false}, {1, true}};
    Solid<2> solid = make_solid<2>(cloud, "neo-hookean", rubber, how);
    const Linearised linear = linearise(solid);
    const SparseMatrix skew = linear.stiffness - SparseMatrix(linear.stiffness.transpose());
    EXPECT_LT(skew.norm(), 1e-13 * linear.stiffness.norm());
    State<2> state = make_state(solid);
    Eigen::VectorXd u(2 * cloud.size());
    const double small = 1e-7;  // error of the difference: small^2, rounding / small
    std::vector<Vec<2>> f[2];
    for (const int side : {0, 1}) {
      for (Index i = 0; i < cloud.size(); ++i) {
        for (int k = 0; k < 2; ++k) u[2 * i + k] = std::sin(12.9898 * static_cast<double>(2 * i + k + 1));
        set_vector<2>(state.u, solid.bonds.slots.of(i), (side ? small : -small) * u.segment<2>(2 * i));
      }
      f[side] = forces(solid, state);
    }
    const Eigen::VectorXd Ku = linear.stiffness * u;
    double worst = 0;
    for (Index i = 0; i < cloud.size(); ++i)
      worst = std::max(worst, (Ku.segment<2>(2 * i) + cloud.V[i] * (f[1][i] - f[0][i]) / (2 * small)).norm());
    EXPECT_LT(worst, 1e-6 * Ku.norm());
  }
}

TEST(Mirror, WithoutWallsThereIsNothing) {
  const Solid<2> solid = rubber_block<2>(6, Layout::cell, 0);
  EXPECT_FALSE(solid.bonds.mirror);
  EXPECT_TRUE(solid.terms.empty());
}

TEST(Mirror, ThinBodiesBetweenWallsAreRefused) {
  const auto cloud = block<2>(6, Layout::cell, 0);
  auto how = options<2>(Scheme{}, cloud.spacing);
  how.smoothing_length = 0.6;  // support 1.2 m, the body is 1 m
  how.walls = {{0, false}, {0, true}};
  EXPECT_THROW(make_solid<2>(cloud, "neo-hookean", rubber, how), InputError);
}

}  // namespace
}  // namespace plumb::testing
