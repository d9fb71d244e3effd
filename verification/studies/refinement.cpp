// Orders of manufactured solutions beside the swinging plate with its natural edges (swinging_plate.cpp): the
// interior alone, the vortex, the cube, the column; and the orders of the integrators.
#include <catch2/catch.hpp>
#include <iostream>

#include "mms/temporal.hpp"
#include "places.hpp"

using namespace plumb;

namespace {

mms::StudyResult run(const char* file, const std::vector<std::string>& overrides = {}) {
  return mms::run_study(
      read_study(std::string(PLUMBLINE_SOURCE_DIR "/verification/studies/") + file, overrides));
}

/// The fit in one norm, printed.
const mms::StudyFit& fit_of(const mms::StudyResult& result, const std::string& what,
                            const std::string& norm = "l2") {
  for (const auto& fit : result.fits)
    if (fit.norm == norm) {
      std::cout << what << ", " << norm << ": order " << fit.fit.order << " [" << fit.fit.lower << ", "
                << fit.fit.upper << "] " << fit.verdict << '\n';
      return fit;
    }
  throw std::logic_error(norm);
}

}  // namespace

// Strains of 0.3 at U = 0.2 m. Four levels here; the fifth, with the narrow interval, is the long case below.
TEST_CASE("Refinement: second order inside of a lattice, small and large strain, both pairs", "[mms]") {
  for (const char* amplitude : {"0.01", "0.2"})
    for (const char* pair : {"W1", "W0"}) {
      const auto result = run("swinging_plate_band.toml",
                              {std::string("study.parameters.amplitude=") + amplitude,
                               std::string("method.pair=") + pair, "study.spacings=[0.2,0.1,0.05,0.04]"});
      const auto& fit = fit_of(result, std::string("plate with a band, U = ") + amplitude + ", " + pair);
      CHECK(fit.verdict == "pass");
      CHECK(fit.fit.lower < 2);
      CHECK(fit.fit.upper > 2);
    }
}

TEST_CASE("Refinement: second order with an interval below 0.15 over five levels", "[mms][long]") {
  for (const char* amplitude : {"0.01", "0.2"})
    for (const char* pair : {"W1", "W0"}) {
      const auto result =
          run("swinging_plate_band.toml",
              {std::string("study.parameters.amplitude=") + amplitude, std::string("method.pair=") + pair,
               "study.spacings=[0.2,0.1,0.05,0.025,0.0125]"});
      const auto& fit =
          fit_of(result, std::string("plate with a band, five levels, U = ") + amplitude + ", " + pair);
      CHECK(fit.verdict == "pass");
      CHECK(fit.fit.lower < 2);
      CHECK(fit.fit.upper > 2);
      CHECK(fit.fit.half_width() < 0.15);
    }
}

// Cells: the first layer gets the values of the wall, half a spacing away. That alone is of first order.
TEST_CASE("Refinement: cells against the wall are of first order", "[mms]") {
  const auto result = run("swinging_plate_band.toml",
                          {"body.layout=cell", "study.held_band=0", "method.beta=0.9", "method.pair=W0",
                           "study.periods=0.125", "study.spacings=[0.1,0.0666666666666667,0.05,0.04,0.025]"});
  const auto& fit = fit_of(result, "plate of cells, held first layer");
  CHECK(fit.verdict == "fail");  // second order is declared
  CHECK(fit.fit.order == Approx(1).margin(0.15));
}

TEST_CASE("Refinement: the vortex on rings of particles converges at the declared order", "[mms]") {
  const auto result = run("generalized_vortex.toml");
  fit_of(result, "vortex on rings", "h1");
  CHECK(fit_of(result, "vortex on rings").verdict == "pass");
}

// What the literature's amplitude needs here; without the band the runs end by inverted particles.
TEST_CASE("Refinement: the vortex at full amplitude converges with an exact band", "[mms][long]") {
  const auto result = run("generalized_vortex_full.toml");
  const auto& fit = fit_of(result, "vortex at full amplitude");
  CHECK(fit.verdict == "asymptotic");
  CHECK(fit.fit.order > 1.8);
  const auto free = run("generalized_vortex_full.toml",
                        {"body.layout=node", "study.held_band=0", "study.spacings=[0.03125]"});
  CHECK(free.levels.front().failure.has_value());
}

TEST_CASE("Refinement: the cube converges at the declared order in 3D", "[mms]") {
  const auto result = run("trigonometric_cube.toml");
  fit_of(result, "cube on rollers", "h1");
  CHECK(fit_of(result, "cube on rollers").verdict == "pass");
}

// Nothing is declared: the corners at the base, where a held face meets a loaded one, are not smooth for the
// scheme. Errors must fall all the same.
TEST_CASE("Refinement: the column under tractions converges", "[mms]") {
  const auto result = run("stretched_column.toml");
  const auto& fit = fit_of(result, "column under tractions");
  CHECK(fit.fit.order > 1);
  for (std::size_t k = 1; k < result.levels.size(); ++k)
    CHECK(result.levels[k].nodal.l2 < result.levels[k - 1].nodal.l2);
}

// The loads vary in time, so that loads at t^n in all stages, as (30) prints them, show.
TEST_CASE("Refinement: the integrators have their orders, (30) as printed has one", "[mms]") {
  const Study study =
      read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/swinging_plate_finite_strain.toml",
                 {"study.periods=0.125", "study.parameters.amplitude=0.05"});
  const mms::TemporalResult result = mms::run_temporal(study);
  REQUIRE(result.orders.size() >= 3);
  for (const auto& order : result.orders) {
    std::cout << order.integrator << ": order in time " << order.fit.order << " [" << order.fit.lower << ", "
              << order.fit.upper << "]\n";
    CHECK(order.verdict == "pass");
    // the studies in space run with steps as long as the first one here: their error in time does not count
    if (order.declared > 1) CHECK(order.levels.front().error < 0.01 * result.spatial_error);
  }
}
