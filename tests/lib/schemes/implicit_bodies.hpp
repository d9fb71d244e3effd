#pragma once
#include <Eigen/Geometry>
#include <string>

#include "lib/schemes/implicit/discrete_energy.hpp"
#include "lib/schemes/tlsph/bonds/own_supports.hpp"
#include "lib/schemes/tlsph/compatible/compatible.hpp"
#include "lib/schemes/tlsph/loops/make_solid.hpp"
#include "lib/schemes/tlsph/parts/hourglass.hpp"
#include "lib/schemes/tlsph/parts/slope_hourglass.hpp"
#include "tests/support/clouds.hpp"
#include "tests/support/solids.hpp"

/// Bodies with every table, law and term for the tests of the implicit scheme.
namespace plumb::testing {

/// Which bond table: an estimator of the catalogue, "compatible", or "dual": supports of their own per
/// particle, as paper 004 (10)-(18) has them.
struct TableChoice {
  std::string name = "improved";
  Correction pair = Correction::W1;
};

inline const std::vector<TableChoice>& all_tables() {
  static const std::vector<TableChoice> tables{{"improved", Correction::W1},   {"standard", Correction::W0},
                                               {"standard", Correction::W1},   {"bond38", Correction::W1},
                                               {"compatible", Correction::W1}, {"dual", Correction::none}};
  return tables;
}

/// Support radii that change by a third from particle to particle: about a fifth of the pairs are one-sided.
template <int d>
std::vector<double> varied_radii(const Cloud<d>& cloud) {
  std::vector<double> radius;
  for (const Vec<d>& X : cloud.X) radius.push_back(cloud.spacing * (2.4 + 0.5 * std::cos(20 * X.sum())));
  return radius;
}

template <int d>
BondOptions<d> table_options(const TableChoice& table, const Cloud<d>& cloud) {
  Scheme scheme{.pair = table.pair};
  if (table.name != "compatible" && table.name != "dual") scheme.estimator = table.name;
  if (table.name == "dual") scheme = {.estimator = "standard", .pair = Correction::none, .beta = 1.5};
  BondOptions<d> options = testing::options<d>(scheme, cloud.spacing);
  if (table.name == "compatible") project_compatible(options);
  if (table.name == "dual") use_own_supports(options, varied_radii(cloud));
  return options;
}

template <int d>
Solid<d> elastic_body(const TableChoice& table, const LawChoice& law, double alpha, double jitter,
                      Index cells = d == 2 ? 6 : 4, const std::string& weight = "kernel") {
  Cloud<d> cloud = testing::block<d>(cells, Layout::node, jitter);
  const BondOptions<d> options = table_options<d>(table, cloud);
  Solid<d> solid = make_solid<d>(std::move(cloud), law, rubber, options);
  if (alpha > 0 && weight == "slope")
    add_term(solid, slope_hourglass_term(
                        solid, options.kernel, alpha,
                        table.name == "dual"
                            ? varied_radii(solid.cloud)
                            : std::vector<double>(solid.cloud.X.size(), 1.9 * solid.cloud.spacing)));
  else if (alpha > 0)
    add_term(solid, hourglass_term(solid, options.kernel, alpha));
  return solid;
}

/// A body with the operator of paper 004: quintic kernel, a support of its own for every particle, and the hourglass energy (21).
template <int d>
Solid<d> dual_body(Cloud<d> cloud, const std::vector<double>& radius, const std::string& law,
                   const Elastic& elastic, double alpha = 0) {
  BondOptions<d> options =
      testing::options<d>({.estimator = "standard", .pair = Correction::none}, cloud.spacing);
  options.kernel = kernel_named<d>("quintic");
  use_own_supports(options, radius);
  Solid<d> solid = make_solid<d>(std::move(cloud), law, elastic, options);
  if (alpha > 0) add_term(solid, slope_hourglass_term(solid, options.kernel, alpha, radius));
  return solid;
}

/// The energy of all unknowns.
template <int d>
DiscreteEnergy<d> energy_of_all(const Solid<d>& solid) {
  return {solid, free_unknowns(d * solid.cloud.size(), {})};
}

/// Strains of some percent that no symmetry spares.
template <int d>
Eigen::VectorXd smooth_motion(const Cloud<d>& cloud, double size) {
  Eigen::VectorXd u(d * cloud.size());
  for (Index i = 0; i < cloud.size(); ++i)
    for (int k = 0; k < d; ++k) {
      const Vec<d>& X = cloud.X[i];
      u[d * i + k] = size * (std::sin(2 * X[0] + k) * X[(k + 1) % d] + 0.3 * std::cos(3 * X[d - 1] - k));
    }
  return u;
}

}  // namespace plumb::testing
