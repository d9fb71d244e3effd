#include "lib/scene/compatible_table.hpp"

#include <fmt/format.h>

#include "lib/schemes/tlsph/compatible/lattice_closure.hpp"

namespace plumb {

template <int d>
std::optional<std::string> reason_to_project(const Scene& scene, const Cloud<d>& cloud) {
  const Compatible& compatible = scene.method.compatible;
  if (compatible.table == "projected") return "the scene says so";
  const double R = kernel_named<d>(scene.method.kernel).support * scene.method.beta * cloud.spacing;
  std::optional<std::string> reason = reason_against_closure<d>(cloud, R);
  if (!reason && scene.method.momentum != "adjoint")
    reason = fmt::format("momentum = \"{}\" needs bonds that are antisymmetric", scene.method.momentum);
  if (!reason && compatible.surface == "estimated") reason = "the surface is estimated";
  if (reason && compatible.table == "closed-form")
    throw InputError("no closed form of the compatible table", *reason,
                     "use [compatible] table = \"auto\" or \"projected\"");
  return reason;
}

template <int d>
bool needs_surface(const Scene& scene, const Cloud<d>& cloud) {
  if (scene.method.momentum == "variational") return true;
  return scene.method.gradient == "compatible" && reason_to_project<d>(scene, cloud);
}

template <int d>
std::shared_ptr<CompatibleReport> make_it_compatible(BondOptions<d>& options, const Scene& scene,
                                                     const Cloud<d>& cloud,
                                                     const std::optional<Surface<d>>& surface) {
  auto report = std::make_shared<CompatibleReport>();
  const auto reason = reason_to_project<d>(scene, cloud);
  if (!reason) {
    close_on_lattice<d>(options, cloud);
    report->closed_form = true;
    return report;
  }
  const Compatible& compatible = scene.method.compatible;
  CompatibleOptions<d> how;
  if (compatible.volumes == "fixed") how.volume_weight = 0;
  how.cache = compatible.cache;
  how.surface = [surface](const Cloud<d>&) { return *surface; };
  project_compatible(options, how, report);
  report->why_projected = *reason;
  return report;
}

#define PLUMB_INSTANTIATE(d)                                                               \
  template std::optional<std::string> reason_to_project<d>(const Scene&, const Cloud<d>&); \
  template bool needs_surface<d>(const Scene&, const Cloud<d>&);                           \
  template std::shared_ptr<CompatibleReport> make_it_compatible<d>(                        \
      BondOptions<d>&, const Scene&, const Cloud<d>&, const std::optional<Surface<d>>&);
PLUMB_INSTANTIATE(1)
PLUMB_INSTANTIATE(2)
PLUMB_INSTANTIATE(3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
