// Every norm that `plumb mms` and `plumb static` report, by its value and not by its slope: the field of the
// same run summed up here, by formulas of this file, against closed forms of the swinging plate.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "lib/schemes/tlsph/statics/statics.hpp"
#include "mms/level.hpp"
#include "places.hpp"
#include "tests/support/program.hpp"

namespace plumb {
namespace {

using std::numbers::pi;
using Overrides = std::vector<std::string>;

const std::string studies = PLUMBLINE_SOURCE_DIR "/verification/studies/";
const std::array<const char*, 5> names{"l2", "h1", "linf", "velocity_l2", "stress_l2"};

nlohmann::json result_of(const std::string& command, const std::string& file, const Overrides& set) {
  std::string call = command + " " + studies + file + " --json -";
  for (const auto& one : set) call += " --set '" + one + "'";
  const auto outcome = test::run_plumb(call);
  EXPECT_LE(outcome.code, 1) << outcome.error;
  return nlohmann::json::parse(outcome.out);
}

/// The plate of linear elasticity on [0, 2]^2 m at one phase of its swing.
struct Plate {
  double swing, speed;  ///< U sin(omega t) [m], U omega cos(omega t) [m/s]
  double mu;            ///< [Pa]

  Plate(double amplitude, double periods, double young, double poisson, double density) {
    mu = young / (2 * (1 + poisson));
    const double omega = pi / 2 * std::sqrt(2 * mu / density), phase = 2 * pi * periods;
    swing = amplitude * std::sin(phase);
    speed = amplitude * omega * std::cos(phase);
  }
  mms::PointValue<2> at(const Vec<2>& X) const {
    const double a = pi / 2 * X[0], b = pi / 2 * X[1];
    const Vec<2> shape(-std::sin(a) * std::cos(b), std::cos(a) * std::sin(b));
    const double cc = pi / 2 * std::cos(a) * std::cos(b), ss = pi / 2 * std::sin(a) * std::sin(b);
    mms::PointValue<2> value;
    value.u = swing * shape;
    value.v = speed * shape;
    value.gradient << -cc, ss, -ss, cc;
    value.gradient *= swing;
    value.stress << -2 * mu * cc * swing, 0, 0, 2 * mu * cc * swing;
    return value;
  }
  /// L2 norms over the plate, by hand: the integrals of sin^2 cos^2 and cos^2 cos^2 are 1.
  std::map<std::string, double> sizes() const {
    return {{"l2", std::abs(swing) * std::sqrt(2)},
            {"h1", std::abs(swing) * pi},
            {"velocity_l2", std::abs(speed) * std::sqrt(2)},
            {"stress_l2", mu * std::abs(swing) * pi * std::sqrt(2)}};
  }
};

/// Sums of squares of the differences, by weights.
struct Norms {
  std::map<std::string, double> sum;
  void add(const mms::PointValue<2>& a, const mms::PointValue<2>& b, double weight) {
    sum["l2"] += weight * (a.u - b.u).squaredNorm();
    sum["h1"] += weight * (a.gradient - b.gradient).squaredNorm();
    sum["velocity_l2"] += weight * (a.v - b.v).squaredNorm();
    sum["stress_l2"] += weight * (a.stress - b.stress).squaredNorm();
    sum["linf"] = std::max(sum["linf"], (a.u - b.u).squaredNorm());
  }
  double value(const std::string& name) const { return std::sqrt(sum.at(name)); }
};

/// 10 tiles of 5 Gauss points an axis on [0, 2]; abscissas and weights from a table.
std::vector<std::pair<double, double>> gauss_points() {
  const double at[] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
  const double weight[] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                           0.2369268850561891};
  std::vector<std::pair<double, double>> points;
  for (int tile = 0; tile < 10; ++tile)
    for (int k = 0; k < 5; ++k) points.emplace_back(0.2 * tile + 0.1 * (1 + at[k]), 0.1 * weight[k]);
  return points;
}

/// The field between particles with the corrected kernel of W1, from all particles within the support.
mms::PointValue<2> interpolated(const mms::LevelRun<2>& run, const Vec<2>& X, double h) {
  const auto kernel = kernel_named<2>("cubic");
  std::vector<Neighbour<2>> near;
  std::vector<std::size_t> who;
  for (std::size_t j = 0; j < run.values.size(); ++j)
    if ((run.cloud.X[j] - X).norm() < kernel.support * h)
      near.push_back({run.cloud.X[j] - X, run.cloud.V[j]}), who.push_back(j);
  const auto weights = correct<2>(Correction::W1, kernel, h, near);
  mms::PointValue<2> value;
  for (std::size_t k = 0; k < who.size(); ++k) {
    const auto& at = run.values[who[k]];
    value.u += weights.weight[k] * at.u;
    value.v += weights.weight[k] * at.v;
    value.stress += weights.weight[k] * at.stress;
    value.gradient += at.u * weights.gradient[k].transpose();
  }
  return value;
}

// Jittered, so that sums over particles and Gauss points differ. The stress of the neo-Hookean solid differs
// from that of Hooke's law by the strain, 1e-5, and its error is a tenth of it or more: 1e-3.
TEST(NormValues, OfAMovingPlateAreThoseOfItsField) {
  const Overrides set{"study.spacings=[0.25,0.2]", "body.jitter=0.2", "body.seed=3"};
  const auto result = result_of("mms", "swinging_plate.toml", set);
  const Study study = read_study(studies + "swinging_plate.toml", set);
  const Plate plate(1e-5, 1.125, 17e6, 0.495, 1100);
  const auto solution = mms::solution_of<2>(study);
  Sitting sitting;
  for (std::size_t k = 0; k < 2; ++k) {
    const double d = study.spacings[k];
    const auto run = mms::run_level<2>(study, solution, d, {.body_force = false}, sitting);
    Norms nodal, nodal_size, gauss, gauss_size;
    for (std::size_t i = 0; i < run.values.size(); ++i) {
      nodal.add(run.values[i], plate.at(run.cloud.X[i]), run.cloud.V[i]);
      nodal_size.add(mms::PointValue<2>{}, plate.at(run.cloud.X[i]), run.cloud.V[i]);
    }
    for (const auto& [x, wx] : gauss_points())
      for (const auto& [y, wy] : gauss_points()) {
        const Vec<2> X(x, y);
        gauss.add(interpolated(run, X, 0.9 * d), plate.at(X), wx * wy);
        gauss_size.add(mms::PointValue<2>{}, plate.at(X), wx * wy);
      }
    const auto& level = result["levels"][k];
    for (const std::string name : names) {
      const double error = level[name], relative = level["relative_" + name],
                   by_gauss = level[name + "_gauss"],
                   relative_by_gauss = level["relative_" + name + "_gauss"];
      EXPECT_NEAR(error / nodal.value(name), 1, 1e-3) << name << " at " << d;
      EXPECT_NEAR(by_gauss / gauss.value(name), 1, 1e-3) << name << " at " << d;
      EXPECT_NEAR(error / relative / nodal_size.value(name), 1, 1e-4) << name << " at " << d;
      EXPECT_NEAR(by_gauss / relative_by_gauss / gauss_size.value(name), 1, 1e-4) << name << " at " << d;
      if (const auto sizes = plate.sizes(); sizes.contains(name)) {
        EXPECT_NEAR(by_gauss / relative_by_gauss / sizes.at(name), 1, 1e-4) << name << " at " << d;
      }
    }
    // the largest displacement lies on a particle of the edge, and 0.009 m away from the next Gauss point
    EXPECT_GT(nodal_size.value("linf") / gauss_size.value("linf"), 1.00015);
  }
  EXPECT_EQ(result["units"]["l2"], "m^2");
  EXPECT_EQ(result["units"]["stress_l2_gauss"], "Pa m");
}

// The same for the plate as an equilibrium: solved here once more, with the load V mu pi^2/2 u of the closed
// form.
TEST(NormValues, OfAStaticPlateAreThoseOfItsField) {
  const Overrides set{"study.spacings=[0.5,0.25]", "method.gradient=improved"};
  const auto result = result_of("static", "static_plate.toml", set);
  const Study study = read_study(studies + "static_plate.toml", set);
  const Plate plate(1e-7, 0.25, 17e6, 0.3, 1100);
  const double lambda = 17e6 * 0.3 / (1.3 * 0.4);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto simulation = mms::driven_simulation<2>(study, mms::solution_of<2>(study), study.spacings[k]);
    const Solid<2>& solid = simulation.solid;
    const Cloud<2>& cloud = solid.cloud;
    Eigen::VectorXd load(2 * cloud.size());
    std::vector<Prescribed> edge;
    for (Index i = 0; i < cloud.size(); ++i) {
      const Vec<2> X = cloud.X[i], u = plate.at(X).u;
      const double to_edge = std::min({X[0], X[1], 2 - X[0], 2 - X[1]});
      for (int a = 0; a < 2; ++a) {
        load[2 * i + a] = cloud.V[i] * plate.mu * pi * pi / 2 * u[a];
        if (to_edge < 1e-9) edge.push_back({2 * i + a, u[a]});
      }
    }
    const Eigen::VectorXd u = equilibrium(linearise(solid).stiffness, load, edge);
    State<2> state = make_state(solid);
    for (Index i = 0; i < cloud.size(); ++i)
      set_vector<2>(state.u, solid.bonds.slots.of(i), u.segment<2>(2 * i));
    Norms error, size;
    for (Index i = 0; i < cloud.size(); ++i) {
      mms::PointValue<2> found;
      found.u = u.segment<2>(2 * i);
      found.gradient = deformation_gradient_of(solid, state, i) - Mat<2>::Identity();
      found.stress = plate.mu * (found.gradient + found.gradient.transpose()) +
                     lambda * found.gradient.trace() * Mat<2>::Identity();
      mms::PointValue<2> exact = plate.at(cloud.X[i]);
      exact.v.setZero();
      error.add(found, exact, cloud.V[i]);
      size.add(mms::PointValue<2>{}, exact, cloud.V[i]);
    }
    const auto& level = result["levels"][k];
    for (const std::string name : {"l2", "h1", "linf", "stress_l2"}) {
      EXPECT_NEAR(level[name].get<double>() / error.value(name), 1, 1e-3) << name;
      EXPECT_NEAR(level["relative_" + name].get<double>() * size.value(name) / error.value(name), 1, 1e-3)
          << name;
    }
  }
  EXPECT_EQ(result["units"]["stress_l2"], "Pa m");
}

}  // namespace
}  // namespace plumb
