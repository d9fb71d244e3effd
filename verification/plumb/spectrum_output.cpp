#include "plumb/spectrum_output.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "plumbline/scene/simulation.hpp"
#include "plumbline/spectrum/lattice_symbol.hpp"

namespace plumb {
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
      const Eigen::VectorXcd values =
          Eigen::EigenSolver<Eigen::MatrixXd>(symbol.dynamical_matrix(theta, elastic), false).eigenvalues();
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

template <int d>
Json worst_mode(const Spectrum& spectrum, const LinearOperator<d>& op) {
  if (spectrum.low.empty()) return {};
  const Mode& mode = spectrum.low.front();
  const Cloud<d>& cloud = op.solid().cloud;
  std::vector<std::vector<double>> X, u(static_cast<std::size_t>(cloud.size()), std::vector<double>(d, 0));
  for (Index i = 0; i < cloud.size(); ++i) X.emplace_back(cloud.X[i].data(), cloud.X[i].data() + d);
  const double most = mode.motion.cwiseAbs().maxCoeff();
  for (Index n = 0; n < op.size(); ++n) {
    const auto& [particle, axis] = op.components()[n];
    u[static_cast<std::size_t>(particle)][static_cast<std::size_t>(axis)] = mode.motion[n] / most;
  }
  return {{"value", mode.value},
          {"unexplained", mode.unexplained},
          {"spurious", mode.spurious()},
          {"spacing", cloud.spacing},
          {"X", X},
          {"u", u}};
}

Json symbol_rows(const Scene& scene, int points) {
  return scene.dimension == 2 ? symbol_in<2>(scene, points) : symbol_in<3>(scene, points);
}

template Json worst_mode<2>(const Spectrum&, const LinearOperator<2>&);
template Json worst_mode<3>(const Spectrum&, const LinearOperator<3>&);

}  // namespace plumb
