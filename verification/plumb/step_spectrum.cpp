#include "verification/plumb/step_spectrum.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "lib/core/dimension.hpp"
#include "lib/run/checkpoint.hpp"
#include "lib/scene/scheme_simulation.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/spectrum/own_step.hpp"
#include "verification/plumb/state_at.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

template <int d>
Json step_spectrum(const Scene& scene, const std::string& at) {
  Simulation<d> simulation = make_simulation<d>(scene).simulation;
  if (!at.empty()) simulation.restore(saved_state<d>(scene, at));
  const Elastic elastic = scene.material.elastic();
  const StateScales scales{simulation.spacing, elastic.wave_speed(), elastic.density};
  const double time = simulation.steps.now().time, unit = scales.length / scales.speed;
  const StepSpectrum s = spectrum_of_step(simulation, scales);
  Json result{{"scene", scene.name},
              {"scheme", simulation.scheme},
              {"unknowns", s.unknowns},
              {"time_step", s.time_step},
              {"time_unit", unit},
              {"growth_rate", s.growth * unit},
              {"growth_aperiodic", s.growth_aperiodic * unit},
              {"growth_resolution", s.resolution * unit},
              {"growing", s.growing},
              {"fastest", s.fastest * unit}};
  if (!at.empty()) {
    result["at"] = at;
    result["time"] = time;
  }
  return result;
}

}  // namespace

bool asked_by_steps(const Scene& scene) {
  return has_own_body(scene.method.scheme);
}

Json step_spectrum(const Scene& scene, const std::string& at) {
  return plumb::with_dimension(scene.dimension, [&]<int d>() { return step_spectrum<d>(scene, at); });
}

std::string step_spectrum_text(const Json& r) {
  const double resolution = r["growth_resolution"].get<double>();
  std::string text =
      fmt::format("{}: a step of {:.4g} s of scheme = \"{}\", {} unknowns\n", r["scene"].get<std::string>(),
                  r["time_step"].get<double>(), r["scheme"].get<std::string>(), r["unknowns"].get<int>());
  if (r["growing"] == 0)
    text += fmt::format("  no motion grows faster than {:.2g} c_p/d\n", resolution);
  else
    text += fmt::format("  {} motions grow, the fastest by {:.4g} c_p/d; without oscillation {}\n",
                        r["growing"].get<int>(), r["growth_rate"].get<double>(),
                        r["growth_aperiodic"] == 0
                            ? "none"
                            : fmt::format("by {:.4g} c_p/d", r["growth_aperiodic"].get<double>()));
  return text + fmt::format("  fastest oscillation: omega d/c_p = {:.5g}\n", r["fastest"].get<double>());
}

}  // namespace plumb::app
