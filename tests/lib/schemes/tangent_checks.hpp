#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/material/law.hpp"
#include "lib/schemes/implicit/discrete_energy.hpp"
#include "tests/support/clouds.hpp"

/// Residual and tangent are the first and second derivative of the energy, whatever has the energy.
namespace plumb::testing {

inline std::vector<LawChoice> elastic_laws(int d) {
  std::vector<LawChoice> laws;
  for (const char* name : {"neo-hookean", "mooney-rivlin", "polyconvex", "saint-venant-kirchhoff",
                           "neo-hookean-logarithmic", "linear-elastic"}) {
    laws.emplace_back(name);
    if (d == 2) laws.emplace_back(name, std::map<std::string, double>{}, Plane::stress);
  }
  return laws;
}

template <int d>
Eigen::VectorXd some_direction(Index n, std::uint64_t seed) {
  test::Numbers numbers(seed);
  Eigen::VectorXd v(n);
  for (Index i = 0; i < n; ++i) v[i] = numbers.next();
  return v;
}

/// dR/ds by differences of fourth order: strains of 1e-3 leave (1e-3)^4 of truncation and 1e-13 of round-off.
template <int d>
Eigen::VectorXd slope_of_residual(const DiscreteEnergy<d>& energy, const Eigen::VectorXd& u,
                                  const Eigen::VectorXd& v, double s) {
  const auto r = [&](double t) { return energy.residual(u + t * s * v).value(); };
  return (8 * (r(1) - r(-1)) - (r(2) - r(-2))) / (12 * s);
}

/// d2E/ds2 by differences of sixth order.
template <int d>
double curvature_of_energy(const DiscreteEnergy<d>& energy, const Eigen::VectorXd& u,
                           const Eigen::VectorXd& v, double s) {
  const auto pair = [&](double t) { return energy.energy(u + t * s * v) + energy.energy(u - t * s * v); };
  return (pair(3) / 90 - 3 * pair(2) / 20 + 3 * pair(1) / 2 - 49 * energy.energy(u) / 18) / (s * s);
}

/// At displacements u, along a direction that no symmetry spares.
template <int d>
void tangent_is_the_derivative(DiscreteEnergy<d> energy, const Eigen::VectorXd& u, const std::string& what) {
  const Eigen::VectorXd v = some_direction<d>(u.size(), 5);
  energy.linearise_at(u);
  const SparseMatrix K = energy.tangent();
  const Eigen::VectorXd Kv = K * v;
  const double s = 1e-3 * energy.cloud().spacing;
  EXPECT_LT((Kv - slope_of_residual(energy, u, v, s)).norm(), 1e-9 * Kv.norm()) << what;
  EXPECT_LT((Kv - energy.tangent_times(v)).norm(), 1e-13 * Kv.norm()) << what;
  EXPECT_LT((K - SparseMatrix(K.transpose())).norm(), 1e-14 * K.norm()) << what;
  const double curvature = v.dot(Kv);
  EXPECT_NEAR(curvature_of_energy(energy, u, v, 5 * s), curvature, 1e-9 * curvature) << what;
}

}  // namespace plumb::testing
