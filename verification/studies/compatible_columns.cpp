// The paper's columns by projected compatible bonds (THEORY chapters 11, 12): twisted, bent, pulled, without
// dissipation. Those of lattices in closed form: lattice_closure.cpp.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <iostream>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/measures/solid_measures.hpp"
#include "places.hpp"

namespace plumb::compatible_columns_study {

namespace {

struct Ending {
  bool completed;
  double energy_change, hourglass_share;
};

Ending outcome_of(const std::string& scene_file, std::vector<std::string> overrides) {
  overrides.emplace_back("compatible.table=projected");
  TlsphBody<3> simulation =
      make_tlsph<3>(read_scene(PLUMBLINE_SOURCE_DIR "/verification/scenes/" + scene_file, overrides));
  const double energy = energy_of(simulation.solid, simulation.state).total();
  const auto result = run(simulation.solid, simulation.state, simulation.integrator, simulation.control);
  const double change = energy > 0 ? energy_of(simulation.solid, simulation.state).total() / energy - 1 : 0;
  const Ending outcome{result.completed(), change, hourglass_share(simulation.solid, simulation.state)};
  std::string text;
  for (const auto& o : overrides) text += " " + o;
  std::cout << fmt::format("{}{}: {}, energy {:+.2e}, hourglass share {:.3f}\n", scene_file, text,
                           outcome.completed ? "completed" : "failed", outcome.energy_change,
                           outcome.hourglass_share);
  return outcome;
}

}  // namespace

// The bounds are what the default scheme has to reach on these columns.
TEST_CASE("compatible: twisting column, 105 rad/s", "[compatible]") {
  for (const char* jitter : {"0", "0.2"}) {
    const Ending o =
        outcome_of("twisting-column-105-compatible.toml", {std::string("body.jitter=") + jitter});
    CHECK(o.completed);
    CHECK(std::abs(o.energy_change) < 0.01);
    CHECK(o.hourglass_share < 0.15);
  }
  // without the energy the share is 0.69 when the step collapses
  CHECK(!outcome_of("twisting-column-105-compatible.toml", {"body.jitter=0", "hourglass.alpha=0"}).completed);
}

// The coefficient's default: the smallest that serves all of the paper's cases.
TEST_CASE("compatible: share of the twisted column by hourglass coefficient",
          "[compatible][hourglass][long]") {
  for (const char* jitter : {"0", "0.2"}) {
    double before = 1;
    for (const char* alpha : {"0.5", "1", "2", "4"}) {
      const Ending o =
          outcome_of("twisting-column-105-compatible.toml",
                     {std::string("body.jitter=") + jitter, std::string("hourglass.alpha=") + alpha});
      CHECK(o.completed);
      CHECK(o.hourglass_share < before);
      before = o.hourglass_share;
    }
  }
}

TEST_CASE("compatible: bending column, and twists of 300 and 400 rad/s", "[compatible][long]") {
  for (const char* jitter : {"0", "0.2"}) {
    const std::string set = std::string("body.jitter=") + jitter;
    const Ending bend =
        outcome_of("bending-column.toml",
                   {set, "body.layout=node", "body.particles=[5,5,25]", "method.gradient=compatible",
                    "method.momentum=adjoint", "method.integrator=verlet", "jst.eta4=0"});
    CHECK(bend.completed);
    CHECK(std::abs(bend.energy_change) < 1e-2);
    for (const char* rate : {"300", "400"})
      for (const char* alpha : {"2", "8"}) {
        const Ending twist =
            outcome_of(std::string("twisting-column-") + rate + ".toml",
                       {set, "body.layout=node", "body.particles=[5,5,25]", "method.gradient=compatible",
                        "method.momentum=adjoint", "method.integrator=verlet", "jst.eta4=0",
                        std::string("hourglass.alpha=") + alpha});
        // at this resolution and alpha = 2 a perfect lattice collapses (THEORY 12); no other one does
        if (jitter != std::string("0") || alpha == std::string("8")) CHECK(twist.completed);
        CHECK(std::abs(twist.energy_change) < 1e-3);
      }
  }
}

TEST_CASE("compatible: column pulled to 533 %", "[compatible][long]") {
  for (const char* poisson : {"0.45", "0.495"})
    for (const char* jitter : {"0", "0.2"}) {
      const Ending o =
          outcome_of("pulling-column-compatible.toml",
                     {std::string("body.jitter=") + jitter, std::string("material.poisson=") + poisson});
      CHECK(o.completed);
      CHECK(o.hourglass_share < 0.15);
    }
}

}  // namespace plumb::compatible_columns_study
