#include "verification/plumb/loaded_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "lib/core/dimension.hpp"
#include "lib/core/error.hpp"
#include "lib/scene/loaded_body.hpp"
#include "lib/schemes/implicit/loaded_vibrations.hpp"
#include "verification/plumb/state_at.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

template <int d>
Json vibrations_of(const Scene& scene, const std::string& at, int count) {
  if (has_history(scene.material.model))
    throw InputError(fmt::format("--at with a body of \"{}\"", scene.material.model),
                     "its stiffness depends on what was before", "leave out --at, or name an elastic law");
  const LoadedBody<d> body = loaded_body<d>(scene, saved_state<d>(scene, at));
  Balance<d> balance = body.balance();
  Json modes = Json::array();
  int unstable = 0;
  for (const LoadedVibration& mode : vibrations_about<d>(balance, body.motion.u, count)) {
    const double frequency = std::sqrt(std::abs(mode.square)) / (2 * std::numbers::pi);
    const bool grows = mode.square < 0;
    unstable += grows ? 1 : 0;
    modes.push_back({{"number", modes.size() + 1},
                     {"omega_squared", mode.square},
                     {"frequency_hz", grows ? Json() : Json(frequency)},
                     {"kind", grows ? "grows" : "vibrates"}});
  }
  return {{"scene", scene.name},
          {"at", at},
          {"time", body.motion.time},
          {"unstable", unstable},
          {"modes", modes}};
}

}  // namespace

Json loaded_vibrations(const Scene& scene, const std::string& at, int count) {
  return plumb::with_dimension(scene.dimension, [&]<int d>() { return vibrations_of<d>(scene, at, count); });
}

std::string loaded_text(const Json& result) {
  std::string text =
      fmt::format("{} at {:g} s: {}\n", result["scene"].get<std::string>(), result["time"].get<double>(),
                  result["unstable"] == 0 ? "the state is stable" : "the state is unstable");
  for (const auto& mode : result["modes"])
    text += mode["frequency_hz"].is_null()
                ? fmt::format("  {:>3}  grows, omega^2 = {:.6g} 1/s^2\n", mode["number"].get<int>(),
                              mode["omega_squared"].get<double>())
                : fmt::format("  {:>3}  {:.6g} Hz\n", mode["number"].get<int>(),
                              mode["frequency_hz"].get<double>());
  return text;
}

}  // namespace plumb::app
