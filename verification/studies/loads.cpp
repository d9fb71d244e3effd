// Solutions with loads, linear elasticity: order in L2 with its interval, against the exact field.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "lib/scene/study.hpp"
#include "mms/static_study.hpp"
#include "places.hpp"

namespace plumb::loads_study {

namespace {

using Set = std::vector<std::string>;

Study study(const std::string& file, const Set& set, StudyOf use = StudyOf::space) {
  return read_study(PLUMBLINE_SOURCE_DIR "/verification/studies/" + file, set, {}, use);
}

/// Prints the fits; those with a declared order must pass, or lie above it: an order that is higher than claimed is no fault.
void expect_declared(const std::string& what, const std::vector<mms::StudyFit>& fits) {
  for (const mms::StudyFit& fit : fits) {
    std::cout << fmt::format("  {:44} {:12} order {:5.2f} [{:5.2f}, {:5.2f}] {}\n", what, fit.norm,
                             fit.fit.order, fit.fit.lower, fit.fit.upper, fit.verdict);
    INFO(what << ", " << fit.norm);
    if (fit.declared) CHECK((fit.verdict == "pass" || fit.verdict == "above"));
  }
  REQUIRE(fits[0].declared);
}

void moving(const std::string& file, const Set& set = {}) {
  expect_declared(file + (set.empty() ? "" : ", " + set[0]), mms::run_study(study(file, set)).fits);
}

void at_rest(const std::string& file, const Set& set = {}) {
  expect_declared(file + (set.empty() ? "" : ", " + set[0]),
                  mms::run_static_study(study(file, set, StudyOf::equilibrium)).fits);
}

}  // namespace

TEST_CASE("loads: Lame's mode of a square without supports is of second order, for every Poisson's ratio",
          "[loads]") {
  moving("lame_mode.toml");
  moving("lame_mode.toml", {"material.poisson=0"});
  moving("lame_mode.toml", {"material.poisson=0.45"});
}

TEST_CASE("loads: bars with a loaded end are of second order", "[loads]") {
  moving("loaded_bar.toml");
  moving("churchill_bar.toml");
}

TEST_CASE("loads: static fields with tractions are of second order", "[loads]") {
  at_rest("kirsch_plate.toml");
  at_rest("lame_ring.toml");
  at_rest("plane_cantilever.toml");
  at_rest("plane_cantilever.toml", {"body.jitter=0.2", "body.seed=1"});
}

}  // namespace plumb::loads_study
