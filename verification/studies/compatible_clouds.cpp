// Compatible bonds on every kind of cloud: lattice, jitter, blue noise. Order 2 where it is claimed, and not
// with the schemes that are not projected. The report section compatible-evidence has all of them in one
// table.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "lib/scene/study.hpp"
#include "mms/static_study.hpp"
#include "places.hpp"
#include "reports/evidence.hpp"

namespace plumb::compatible_clouds_study {

namespace {

using Set = std::vector<std::string>;

const std::string folder = PLUMBLINE_SOURCE_DIR "/verification/studies/";
const Set &compatible = reports::schemes()[0].set, &adjoint = reports::schemes()[1].set,
          &paper = reports::schemes()[2].set, &blue = reports::cloud_of("blue").set;

const Set projected{"compatible.table=projected"};

Set jitter(const std::string& fraction) {
  return {"body.jitter=" + fraction};
}

Set operator+(Set one, const Set& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

void print(const std::string& name, const std::vector<mms::StudyFit>& fits) {
  for (std::size_t n = 0; n < 2; ++n)
    std::cout << fmt::format("  {:44} {} order {:5.2f} [{:5.2f}, {:5.2f}] {}\n", n == 0 ? name : "",
                             fits[n].norm, fits[n].fit.order, fits[n].fit.lower, fits[n].fit.upper,
                             fits[n].verdict);
}

/// Fits of L2 and H1 of the static plate.
std::vector<mms::StudyFit> static_plate(const std::string& name, const Set& set) {
  auto fits = mms::run_static_study(read_study(folder + "static_plate.toml", set)).fits;
  print("static plate, " + name, fits);
  return fits;
}

/// The same in motion and at finite strain.
std::vector<mms::StudyFit> moving_plate(const std::string& name, const Set& set) {
  auto fits = mms::run_study(read_study(folder + "swinging_plate_finite_strain.toml",
                                        set + Set{"study.quadrature=nodal"}))
                  .fits;
  print("moving plate, " + name, fits);
  return fits;
}

/// L2 of order 2, H1 of order 1 or better: verdicts do not resolve more than 0.1 of an order.
void expect_order_2(const std::vector<mms::StudyFit>& fits) {
  REQUIRE(fits[0].norm == "l2");
  REQUIRE(fits[1].norm == "h1");
  CHECK(fits[0].verdict == "pass");
  CHECK(fits[1].fit.order > 0.9);
}

/// Neither of order 2 nor on the way to it.
void expect_no_order_2(const std::vector<mms::StudyFit>& fits) {
  CHECK(fits[0].verdict != "pass");
  CHECK(fits[0].fit.upper < 2);
}

}  // namespace

TEST_CASE("compatible: static plate on jittered clouds and blue noise", "[compatible][clouds]") {
  expect_order_2(static_plate("lattice", compatible + jitter("0")));
  expect_order_2(static_plate("lattice, projected", compatible + jitter("0") + projected));
  expect_order_2(static_plate("jitter 0.1", compatible + jitter("0.1")));
  expect_order_2(static_plate("blue noise", compatible + blue));
  expect_no_order_2(static_plate("blue noise, adjoint", adjoint + blue));
  expect_no_order_2(static_plate("blue noise, paper", paper + blue));
}

TEST_CASE("compatible: swinging plate at finite strain on jittered clouds and blue noise",
          "[compatible][clouds]") {
  for (const char* fraction : {"0", "0.1", "0.2", "0.3"})
    expect_order_2(moving_plate(std::string("jitter ") + fraction, compatible + jitter(fraction)));
  expect_order_2(moving_plate("lattice, projected", compatible + jitter("0") + projected));
  expect_order_2(moving_plate("blue noise", compatible + blue));
  for (const auto& [name, cloud] : {std::pair{"jitter 0.2", jitter("0.2")}, std::pair{"blue noise", blue}})
    expect_no_order_2(moving_plate(std::string(name) + ", adjoint", adjoint + cloud));
  expect_no_order_2(moving_plate("jitter 0.3, paper", paper + jitter("0.3")));
}

TEST_CASE("compatible: a nearly incompressible static plate does not lock", "[compatible][clouds]") {
  std::vector<double> finest;
  for (const char* poisson : {"0.3", "0.49995"}) {
    const auto result = mms::run_static_study(
        read_study(folder + "static_plate.toml", Set{std::string("material.poisson=") + poisson}));
    print(std::string("static plate, jitter 0.2, nu = ") + poisson, result.fits);
    expect_order_2(result.fits);
    finest.push_back(result.levels.back().relative(&mms::ErrorNorms::l2));
  }
  CHECK(finest[1] / finest[0] ==
        Approx(1).margin(0.05));  // measured 1.008; what locks is off by powers of ten
}

TEST_CASE("compatible: nearly incompressible static plates of every Poisson ratio",
          "[compatible][clouds][long]") {
  for (const char* poisson : {"0.3", "0.4", "0.45", "0.49", "0.495", "0.499", "0.4999", "0.49995"})
    for (const char* fraction : {"0", "0.2"}) {
      const Set set = jitter(fraction) + Set{std::string("material.poisson=") + poisson};
      const std::string name = fmt::format("nu {}, jitter {}", poisson, fraction);
      expect_order_2(static_plate(name, compatible + set));
      if (fraction == std::string("0")) continue;
      expect_no_order_2(static_plate(name + ", adjoint", adjoint + set));
      expect_no_order_2(static_plate(name + ", paper", paper + set));
    }
}

TEST_CASE("compatible: column under traction and cube on irregular clouds", "[compatible][clouds][long]") {
  const auto order_of = [](const std::string& file, const std::string& name, const Set& set) {
    auto fits = mms::run_study(read_study(folder + file, set)).fits;
    print(name, fits);
    return fits;
  };
  const Set declared{"expect.l2=2", "expect.reason=as inside"};
  for (const char* seed : {"1", "2", "3"})
    expect_order_2(order_of("stretched_column.toml", std::string("column, jitter 0.2, seed ") + seed,
                            compatible + jitter("0.2") + declared + Set{std::string("body.seed=") + seed}));
  // coarser levels are not asymptotic: from 1/4 to 1/12 seeds 2 and 3 have orders 2.15 and 2.20
  for (const char* seed : {"1", "2", "3"})
    expect_order_2(order_of("trigonometric_cube.toml", std::string("cube, jitter 0.2, seed ") + seed,
                            compatible + jitter("0.2") +
                                Set{"study.spacings=[0.125,0.0833333333333333,0.0625,0.0416666666666667]",
                                    std::string("body.seed=") + seed}));
  expect_no_order_2(
      order_of("stretched_column.toml", "column, jitter 0.2, adjoint", adjoint + jitter("0.2") + declared));
}

}  // namespace plumb::compatible_clouds_study
