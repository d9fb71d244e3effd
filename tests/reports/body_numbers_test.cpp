#include "reports/body_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "reports/drawn_bodies.hpp"
#include "reports/named.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;

/// A lattice of cells in [0,1]^2 x [0,2], moved by a motion; the value is linear in X.
template <class Motion>
BodyState lattice(Motion&& motion) {
  BodyState state;
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const Point X{(i + 0.5) / 4, (j + 0.5) / 4, (k + 0.5) / 4};
        state.reference.push_back(X);
        state.position.push_back(motion(X));
        state.value.push_back(2 * X[0] - X[1] + 3 * X[2]);
      }
  return state;
}

TEST(BodyNumbers, APlaceIsExactForMultilinearMotionsAlsoBeyondTheOuterParticles) {
  const auto motion = [](const Point& X) { return Point{X[0] + 0.5 * X[1] * X[2], X[1], 2 * X[2] - X[0]}; };
  const BodyState state = lattice(motion);
  for (const Point& X : {Point{0, 0, 2}, Point{1, 1, 2}, Point{0.5, 0.5, 1}, Point{0.125, 0.625, 0.375}})
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(place_of(state, X)[k], motion(X)[k], 1e-12);
  EXPECT_NEAR(value_of(state, {1, 0, 2}), 8, 1e-12);
}

TEST(BodyNumbers, APlaceAmongParticlesThatAreNoLatticeIsRefused) {
  BodyState state = lattice([](const Point& X) { return X; });
  for (auto* points : {&state.reference, &state.position}) points->pop_back();  // a corner is missing
  state.value.pop_back();
  EXPECT_THROW(place_of(state, {1, 1, 2}), MissingResult);
}

/// Small strain: Young's modulus. Incompressible: mu (l^2 - 1/l).
TEST(BodyNumbers, UniaxialStressHasItsLimits) {
  const double mu = 5, kappa = 20, young = 9 * kappa * mu / (3 * kappa + mu);
  EXPECT_NEAR(uniaxial_stress(1 + 1e-6, mu, kappa) / 1e-6, young, 1e-4 * young);
  EXPECT_NEAR(uniaxial_stress(2, mu, 1e7), mu * (4 - 0.5), 1e-4);
  EXPECT_NEAR(uniaxial_stress(3, mu, 1e7), mu * (9 - 1 / 3.0), 1e-3);
}

TEST(BodyNumbers, ThePeriodIsTheSecondReturnThroughZero) {
  std::vector<double> time, tip;
  for (int n = 0; n < 200; ++n) {
    time.push_back(0.01 * n);
    tip.push_back(std::sin(2 * std::numbers::pi * time.back() / 0.77));
  }
  EXPECT_NEAR(first_period(time, tip), 0.77, 1e-4);
  tip.resize(50);
  time.resize(50);
  EXPECT_THROW(first_period(time, tip), MissingResult);
}

struct Thing {
  std::string id;
  int value;
};

TEST(Named, WhatIsNotThereIsAnErrorAndNotTheNextOne) {
  const std::vector<Thing> things{{"a", 1}, {"b", 2}};
  EXPECT_EQ(by_id(things, "b").value, 2);
  EXPECT_THROW(by_id(things, "c"), MissingResult);
  const std::vector<Series> series{{"one", {}, {}}, {"two", {}, {}}};
  EXPECT_EQ(place_of(series, "two"), 1u);
  EXPECT_THROW(by_label(series, "three"), MissingResult);
  const DataTable table{"t", "T", {{"d"}, {"error"}}, {{0.1, 0.5}}};
  EXPECT_EQ(std::get<double>(cell_of(table, table.rows[0], "error")), 0.5);
  EXPECT_THROW(cell_of(table, table.rows[0], "l2"), MissingResult);
}

/// The number of the oscillating plate, whose tip swings with that period.
Check period_of(double period) {
  const plumb::test::TemporaryFolder folder;
  std::ofstream(folder / "result.json") << R"({"status": "completed", "failure": null})";
  std::ofstream series(folder / "series.csv");
  series << "time [s],tip displacement y [m]\n";
  for (int n = 0; n < 400; ++n)
    series << 0.001 * n << ',' << std::sin(2 * std::numbers::pi * 0.001 * n / period) << '\n';
  series.close();
  JobResult result;
  result.folder = folder.path();
  Results results;
  results.add("oscillating-20", result);
  for (const auto& body : paper_size_bodies())
    if (body.id == "oscillating-20") return number_of(body, results);
  throw std::runtime_error("no such body");
}

/// A clamped thin plate: omega = 3.516015 sqrt(D/(rho h))/L^2 with D = E h^3/(12 (1 - nu^2)).
TEST(BodyNumbers, ThePeriodOfAThinPlate) {
  const double E = 1.9985e6, nu = 0.39754, rho = 1000, h = 0.02, L = 0.2;
  const double D = E * h * h * h / (12 * (1 - nu * nu));
  const double period = 2 * std::numbers::pi * L * L / (3.516015 * std::sqrt(D / (rho * h)));
  // tolerance of the check 3 %; periods are read off rows 0.4 % of them apart
  EXPECT_EQ(period_of(period).verdict, "pass") << period_of(period).measured;
  EXPECT_EQ(period_of(1.024 * period).verdict, "pass");
  EXPECT_EQ(period_of(0.976 * period).verdict, "pass");
  EXPECT_EQ(period_of(1.036 * period).verdict, "fail");
  EXPECT_EQ(period_of(0.964 * period).verdict, "fail");
}

/// The number of a column of n x n x 6n cells, lowest layer held, whose run has that energy at the start.
Check start_energy_of(const std::string& id, int n, double energy) {
  const plumb::test::TemporaryFolder folder;
  std::ofstream(folder / "result.json") << nlohmann::json{
      {"status", "completed"}, {"particles", 6 * n * n * n}, {"energy", {{"initial", energy}}}};
  JobResult result;
  result.folder = folder.path();
  Results results;
  results.add(id, result);
  for (const auto& body : paper_size_bodies())
    if (body.id == id) return number_of(body, results);
  throw std::runtime_error("no such body");
}

/// The bending column starts with v = 5 Z/3: rho/2 (5/3)^2 (sum of the squares of the layers' middles) d. The sum of (k + 1/2)^2 below N
/// is N (4 N^2 - 1)/12.
TEST(BodyNumbers, TheEnergyOfAColumnThatIsThrown) {
  const double n = 10, N = 6 * n, d = 1 / n;
  const double squares = N * (4 * N * N - 1) / 12 - 0.25;  // without the lowest layer
  const double energy = 1100 / 2.0 * 25 / 9 * squares * d * d * d;
  EXPECT_EQ(start_energy_of("column-10-adjoint", 10, energy).verdict, "pass")
      << start_energy_of("column-10-adjoint", 10, energy).expected;
  EXPECT_EQ(start_energy_of("column-10-adjoint", 10, energy * (1 + 1e-9)).verdict, "fail");
}

}  // namespace
