#pragma once
#include <gtest/gtest.h>

#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "tests/support/solids.hpp"

/// Projected tables for tests.
namespace plumb::testing {

/// Constants of all bonds after the projection, and the cloud with its new volumes.
template <int d>
struct Projected {
  Cloud<d> cloud;
  std::vector<std::vector<BondConstants<d>>> bonds;
  std::vector<Vec<d>> boundary;
  CompatibleReport report;
};

/// Bonds by the options' estimator, one list per particle.
template <int d>
std::vector<std::vector<BondConstants<d>>> all_bonds(const Cloud<d>& cloud, const BondOptions<d>& options) {
  const Neighbours all = find_neighbours<d>(cloud, options.kernel.support * options.smoothing_length);
  std::vector<std::vector<BondConstants<d>>> bonds;
  for (Index i = 0; i < cloud.size(); ++i) bonds.push_back(bonds_of<d>(cloud, all.of(i), i, options));
  return bonds;
}

template <int d>
Projected<d> projected(Cloud<d> cloud, const Surface<d>& surface, double beta,
                       CompatibleOptions<d> how = {}) {
  const BondOptions<d> options = testing::options<d>({.beta = beta}, cloud.spacing);
  how.surface = [&surface](const Cloud<d>&) { return surface; };
  Projected<d> p;
  p.bonds = all_bonds<d>(cloud, options);
  p.boundary = boundary_vectors<d>(cloud, options.kernel, options.smoothing_length, surface).B;
  p.report = make_compatible<d>(cloud, p.bonds, options.kernel, options.smoothing_length, how);
  p.cloud = std::move(cloud);
  return p;
}

/// Antisymmetric, closed, exact; volumes are positive and fill the body. THEORY (11.1), (11.2).
template <int d>
void expect_compatible(const Projected<d>& p, double volume) {
  const double area = std::pow(p.cloud.spacing, d - 1), cell = std::pow(p.cloud.spacing, d);
  std::vector<Vec<d>> closed = p.boundary;
  double total = 0, skew = 0;
  for (Index i = 0; i < p.cloud.size(); ++i) {
    Mat<d> exact = -p.cloud.V[i] * Mat<d>::Identity();
    for (const auto& ij : p.bonds[i]) {
      const Vec<d> A = 2 * p.cloud.V[i] * ij.stencil;
      closed[i] += A;
      exact += A * ij.separation.transpose() / 2;
      for (const auto& ji : p.bonds[ij.other])
        if (ji.other == i) skew = std::max(skew, (A + 2 * p.cloud.V[ij.other] * ji.stencil).norm());
    }
    total += p.cloud.V[i];
    // the projection's own tolerance; skewness is that of one division
    EXPECT_LT(closed[i].norm(), 1e-12 * area) << i;
    EXPECT_LT(exact.norm(), 1e-12 * cell) << i;
    EXPECT_GT(p.cloud.V[i], 0) << i;
  }
  EXPECT_LT(skew, 1e-14 * area);
  EXPECT_NEAR(total / volume, 1, 1e-12);
}

}  // namespace plumb::testing
