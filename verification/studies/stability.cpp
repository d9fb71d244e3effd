// Stability found by running, beside what linear theory says.
#include "places.hpp"
#include "plumbline/scene/simulation.hpp"
#include "plumbline/spectrum/spectrum.hpp"
#include "plumbline/stability/edge.hpp"
#include "plumbline/stability/stability_study.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace plumb;

namespace {

StabilityStudy study_named(const std::string& name) {
  return read_stability_study(std::string(PLUMBLINE_SOURCE_DIR "/verification/stability/") + name + ".toml");
}

bool stable(const StabilityStudy& study, const std::vector<std::string>& overrides, double value) {
  return try_scene(scene_of(study, overrides, value), study.bounds, [] { return true; })->stable();
}

}  // namespace

TEST_CASE("the cfl limit of small motion is that of the largest eigenvalue", "[stability]") {
  const StabilityStudy study = study_named("small-motion");
  for (const auto& variant : study.variants)
    for (const auto& beta : study.values) {
      const Scene scene = scene_of(study, overrides_of(study, variant, beta, 1), 1);
      const Simulation<2> simulation = make_simulation<2>(scene);
      LinearOperator<2> op(simulation.solid, simulation.supports);
      const double theory = oscillation_limit(scene.method.integrator) / std::sqrt(spectrum_of(op).largest);
      const Edge edge = find_edge(0.8 * theory, 1.25 * theory, 0.01, [&](double cfl) {
        return stable(study, overrides_of(study, variant, beta, cfl), cfl);
      });
      INFO(variant.name << ", beta " << beta << ": theory " << theory << ", run " << edge.stable);
      // 1 % of the bisection; and just above the limit growth needs longer than the run to show
      CHECK(edge.stable / theory == Approx(1).margin(0.05));
    }
}

TEST_CASE("the largest dissipation at a fixed step is that of (6.5)", "[stability]") {
  const StabilityStudy study = study_named("plate-eta4-step");
  const auto& variant = study.variants.back();  // symmetrised, improved F
  for (const auto& step : {study.values[1], study.values[2]}) {
    Scene scene = scene_of(study, overrides_of(study, variant, step, 1), 1);
    const Simulation<2> simulation = make_simulation<2>(scene);
    // the limit on the step at eta4 = 1 is inversely proportional to eta4
    const double theory = simulation.solid.step_limit / *scene.method.time_step;
    const Edge edge = find_edge(0.8 * theory, 1.25 * theory, 0.02, [&](double eta4) {
      return stable(study, overrides_of(study, variant, step, eta4), eta4);
    });
    INFO("step " << step << ": theory " << theory << ", run " << edge.stable);
    CHECK(edge.stable / theory ==
          Approx(1).margin(0.05));  // 2 % of the bisection, and the elastic part beside it
  }
}

TEST_CASE("every stability study can be read and its scenes exist", "[stability]") {
  for (const char* name :
       {"small-motion", "plate-eta4-step", "plate-jitter-beta", "plate-cfl-kernel", "strip-cfl-thickness",
        "bending-cfl-nu", "bending-cfl-beta", "pulling-stretch-nu", "twisting-rate-resolution"})
    CHECK(study_named(name).variants.size() >= 2);
}

TEST_CASE("the same scene in other units and at other scales gives the same numbers", "[stability]") {
  // (length, mass, time) of one unit: SI; mm-tonne-s; a millionth and a million of everything.
  struct Units {
    double length, mass, time;
  };
  const auto scaled = [](const Scene& si, const Units& u) {
    Scene scene = si;
    for (double& size : scene.body.size) size /= u.length;
    for (double& origin : scene.body.origin) origin /= u.length;
    *scene.body.spacing /= u.length;
    scene.material.young *= u.length * u.time * u.time / u.mass;
    scene.material.density *= u.length * u.length * u.length / u.mass;
    *scene.end_time /= u.time;
    for (auto& formula : scene.initial->velocity) {
      std::string text = formula.text();
      for (const char axis : {'X', 'Y', 'Z'}) {
        std::string with;
        for (const char c : text)
          with +=
              c == axis ? "(" + std::string(1, axis) + fmt::format("*{:.17g})", u.length) : std::string(1, c);
        text = with;
      }
      formula = Expression(fmt::format("{:.17g}*({})", u.time / u.length, text), scene.dimension);
    }
    return scene;
  };
  StabilityStudy study = study_named("bending-cfl-nu");
  for (const auto& variant : study.variants) {
    const auto overrides = overrides_of(study, variant, "0.45", 0.3);
    auto short_run = overrides;
    const bool nodes = std::ranges::find(overrides, "body.layout=node") != overrides.end();
    short_run.insert(short_run.end(), {"scene.end_time=10 ms", nodes ? "body.spacing=0.3333333333333333"
                                                                     : "body.particles=[4, 4, 24]"});
    const Scene si = scene_of(study, short_run, 0.3);
    const auto reference = try_scene(si, study.bounds, [] { return true; });
    for (const Units u : {Units{1e-3, 1e3, 1}, Units{1e-6, 1e-6, 1e-6}, Units{1e6, 1e6, 1e6}}) {
      const auto other = try_scene(scaled(si, u), study.bounds, [] { return true; });
      INFO(variant.name << ", length " << u.length);
      CHECK(other->cause == reference->cause);
      CHECK(other->refused == "");
      CHECK(other->steps == reference->steps);
      // Rounding of the scale factors, grown over some hundred steps of a smooth motion.
      CHECK(other->time * u.time == Approx(reference->time).epsilon(1e-12));
      CHECK(other->stretch == Approx(reference->stretch).epsilon(1e-12));
      CHECK(other->energy == Approx(reference->energy).epsilon(1e-12));
      CHECK(other->hourglass == Approx(reference->hourglass).epsilon(1e-11));
    }
  }
}
