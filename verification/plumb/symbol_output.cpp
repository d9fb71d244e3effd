#include "verification/plumb/symbol_output.hpp"

#include <nlohmann/json.hpp>
#include <numbers>

#include "lib/core/dimension.hpp"
#include "lib/linear/dense.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/spectrum/lattice_symbol.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

template <int d>
Json symbol_in(const Scene& scene, int points) {
  const LatticeSymbol<d> symbol(bond_options<d>(scene, 1), scene.method.beta);
  const Elastic elastic = in_dimension(d, scene.material.elastic(), scene.material.plane);
  Json rows = Json::array();
  Vec<d> direction = Vec<d>::Zero();
  for (int axes = 0; axes < d; ++axes) {
    direction[axes] = 1;
    const std::string name = std::string(static_cast<std::size_t>(axes) + 1, '1') +
                             std::string(static_cast<std::size_t>(d - axes - 1), '0');
    for (int n = 1; n <= points; ++n) {
      const Vec<d> theta = std::numbers::pi * n / points * direction;
      const Eigen::VectorXcd values = complex_values(symbol.dynamical_matrix(theta, elastic));
      rows.push_back({{"direction", name},
                      {"theta", theta[0]},
                      {"gradient", symbol.gradient(theta).dot(theta) / theta.squaredNorm()},
                      {"lowest", values.real().minCoeff()},
                      {"largest", values.real().maxCoeff()}});
    }
  }
  return rows;
}

}  // namespace

Json symbol_rows(const Scene& scene, int points) {
  return plumb::with_dimension(scene.dimension, [&]<int d>() { return symbol_in<d>(scene, points); });
}

}  // namespace plumb::app
