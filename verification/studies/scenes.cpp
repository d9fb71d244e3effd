// Scenes with a number to be held to that is not the paper's own.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "lib/scene/read_scene.hpp"
#include "lib/scene/tlsph.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"
#include "places.hpp"

namespace plumb::scenes_study {

namespace {

TlsphBody<2> simulation_of(const char* file, const std::vector<std::string>& overrides = {}) {
  return make_tlsph<2>(
      read_scene(std::string(PLUMBLINE_SOURCE_DIR "/verification/scenes/") + file, overrides));
}

/// Root mean square error of the axial displacement over that of the exact wave.
double wave_error(const char* spacing) {
  TlsphBody<2> s = simulation_of("tensile-bar.toml", {std::string("body.spacing=") + spacing});
  REQUIRE(run<2>(s.solid, s.state, s.integrator, s.control).completed());
  const double speed = s.solid.elastic.wave_speed(), velocity = 1e-3, length = 2;
  double error = 0, size = 0;
  for (Index i = 0; i < s.solid.cloud.size(); ++i) {
    const double exact = velocity * std::max(0.0, s.state.time - (length - s.solid.cloud.X[i][0]) / speed);
    error += std::pow(s.state.u[0][s.solid.bonds.slots.of(i)] - exact, 2);
    size += exact * exact;
  }
  return std::sqrt(error / size);
}

}  // namespace

TEST_CASE("scenes: the wave in the tensile bar is d'Alembert's, with first order at its front", "[scenes]") {
  const double coarse = wave_error("0.025"), fine = wave_error("0.0125");
  std::cout << "tensile bar: error " << coarse << " at d = 0.025 m, " << fine << " at 0.0125 m\n";
  CHECK(fine < 5e-3);  // the front, a kink of u, is smeared over some spacings of 160
  // a kink smeared over a width w ~ d^(2/3): rms error of order w^(3/2), about 1
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.4));
}

TEST_CASE("scenes: the oscillating plate has the period of thin-plate theory", "[scenes]") {
  TlsphBody<2> s = simulation_of("oscillating-plate.toml");
  const Index tip = s.solid.bonds.slots.of(s.solid.cloud.size() - 1);
  double before = 0, time_before = 0, period = 0;
  const auto result =
      run<2>(s.solid, s.state, s.integrator, s.control, [&](const Solid<2>&, const State<2>& state) {
        const double u = state.u[1][tip];
        if (before < 0 && u >= 0) period = time_before + (state.time - time_before) * before / (before - u);
        before = u;
        time_before = state.time;
        return period == 0;
      });
  CHECK_FALSE(result.failure);
  std::cout << "oscillating plate: period " << period << " s\n";
  // paper 001: 0.25416 s in theory; finite thickness (H/L = 0.1) and amplitude are not in it: 3 %, its peers
  // are off by 5
  CHECK(period == Approx(0.25416).epsilon(0.03));
}

TEST_CASE("scenes: the bar under its weight hangs as far as its stiffness says", "[scenes][loads]") {
  const auto lower_end = [](const char* spacing) {
    TlsphBody<2> s = simulation_of("hanging-bar.toml", {std::string("body.spacing=") + spacing});
    REQUIRE(run<2>(s.solid, s.state, s.integrator, s.control).completed());
    const auto lower = particles_on_face(s.solid.cloud, 1, false, Layout::node);
    double mean = 0;
    for (const Index i : lower)
      mean += s.state.u[1][s.solid.bonds.slots.of(i)] / static_cast<double>(lower.size());
    return mean;
  };
  const double exact = -1100 * 9.81 / (2 * 17e6), coarse = lower_end("0.1"), fine = lower_end("0.05");
  std::cout << "hanging bar: " << coarse << " m at d = 0.1 m, " << fine << " m at 0.05 m, exact " << exact
            << " m\n";
  // the law is off by the strain, 6e-4 at the upper end; what is left is the estimate of F in the end layers
  CHECK(fine == Approx(exact).epsilon(0.01));
  CHECK(std::abs(fine - exact) < std::abs(coarse - exact));
}

}  // namespace plumb::scenes_study
