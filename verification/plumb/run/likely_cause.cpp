#include "verification/plumb/run/likely_cause.hpp"

#include <fmt/format.h>

#include <optional>

namespace plumb::app {
namespace {

/// The largest step that small motion bears, over the time of a pressure wave between the closest neighbours:
/// the least of all gradients and beta in plumb stability verification/stability/small-motion.toml (1.09
/// to 1.41 for Verlet, 0.96 to 1.25 for RK3).
std::optional<double> stable_share(const std::string& integrator) {
  if (integrator == "verlet") return 1.09;
  if (integrator == "rk3") return 0.96;
  return std::nullopt;
}

}  // namespace

template <int d>
std::string likely_cause(const Scene& scene, const TlsphBody<d>& simulation, double first_step) {
  const double crossing = simulation.solid.cloud.spacing / simulation.solid.elastic.wave_speed();
  const auto limit = stable_share(scene.method.integrator);
  if (limit && first_step > *limit * crossing)
    return fmt::format(
        "the time step is {:.3g} of the time that a pressure wave needs from particle to "
        "particle, and {} "
        "bears about {:.2g}; use {}",
        first_step / crossing, scene.method.integrator, *limit,
        scene.method.time_step ? fmt::format("time_step = {:.2g} or less", 0.5 * crossing)
                               : std::string("cfl = 0.5"));
  if (scene.method.momentum == "symmetrised" && scene.method.gradient != "compatible" && !scene.method.jst)
    return "with momentum = \"symmetrised\" motion grows near free "
           "faces at any time step; use momentum = \"adjoint\"";
  return "";
}

template std::string likely_cause<1>(const Scene&, const TlsphBody<1>&, double);
template std::string likely_cause<2>(const Scene&, const TlsphBody<2>&, double);
template std::string likely_cause<3>(const Scene&, const TlsphBody<3>&, double);

}  // namespace plumb::app
