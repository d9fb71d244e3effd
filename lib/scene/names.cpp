#include "lib/scene/names.hpp"

#include <algorithm>
#include <array>

#include "lib/geometry/shape.hpp"
#include "lib/kernel/catalogue.hpp"
#include "lib/material/rate_models.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/bonds/estimator_catalogue.hpp"
#include "lib/schemes/tlsph/bonds/momentum_catalogue.hpp"
#include "lib/schemes/tlsph/time/catalogue.hpp"

namespace plumb {
namespace {

struct NamedKind {
  BoundaryKind kind;
  std::string_view name;
};
constexpr std::array<NamedKind, 6> boundary_kinds{{{BoundaryKind::clamped, "clamped"},
                                                   {BoundaryKind::roller, "roller"},
                                                   {BoundaryKind::velocity, "velocity"},
                                                   {BoundaryKind::displacement, "displacement"},
                                                   {BoundaryKind::traction, "traction"},
                                                   {BoundaryKind::pressure, "pressure"}}};

}  // namespace

std::vector<std::string> kernel_names() {
  return names_of(KernelCatalogue{});
}
std::vector<std::string> pair_names() {
  return {"W1", "W0", "none"};
}

std::vector<std::string> gradient_names() {
  auto names = names_of(EstimatorCatalogue{});
  std::erase(names, "bond");
  if (std::find(names.begin(), names.end(), "compatible") == names.end()) names.emplace_back("compatible");
  return names;
}

std::vector<std::string> compatible_table_names() {
  return {"auto", "closed-form", "projected"};
}
std::vector<std::string> start_table_names() {
  return {"standard", "improved"};
}
std::vector<std::string> momentum_names() {
  auto names = names_of(MomentumCatalogue{});
  names.emplace_back("variational");
  return names;
}
std::vector<std::string> integrator_names() {
  return names_of(IntegratorCatalogue{});
}
std::vector<std::string> paper_names() {
  return {"000", "001", "002", "003", "004"};
}

std::vector<std::string> scheme_names() {
  return {"tlsph", "implicit", "mixed", "updated", "eulerian", "element"};
}

std::vector<std::string> wave_speed_names() {
  return {"linear", "stretch", "stretch-inverse"};
}
std::vector<std::string> material_names() {
  return law_names();
}
std::vector<std::string> plane_names() {
  return {"strain", "stress"};
}
std::vector<std::string> shape_names() {
  return shape_catalogue_names();
}
std::vector<std::string> cloud_names() {
  return {"lattice", "blue-noise"};
}
std::vector<std::string> layout_names() {
  return {"cell", "node", "mirror"};
}
std::vector<std::string> boundary_kind_names() {
  std::vector<std::string> names;
  for (const auto& [kind, name] : boundary_kinds) names.emplace_back(name);
  return names;
}
BoundaryKind boundary_kind_named(std::string_view wanted) {
  for (const auto& [kind, name] : boundary_kinds)
    if (name == wanted) return kind;
  throw unknown_name("boundary kind", wanted, boundary_kind_names());
}
std::string_view name_of(BoundaryKind wanted) {
  return std::ranges::find(boundary_kinds, wanted, &NamedKind::kind)->name;
}

std::vector<std::string> face_names(int dimension) {
  std::vector<std::string> names{"x-", "x+"};
  if (dimension >= 2) names.insert(names.end(), {"y-", "y+"});
  if (dimension == 3) names.insert(names.end(), {"z-", "z+"});
  return names;
}

std::vector<std::string> compatible_volume_names() {
  return {"unknown", "fixed"};
}
std::vector<std::string> compatible_surface_names() {
  return {"shape", "estimated"};
}

std::vector<SceneChoice> scene_choices() {
  return {{"body.shape", "shape", shape_names()},
          {"body.cloud", "cloud", cloud_names()},
          {"body.layout", "layout", layout_names()},
          {"material.model", "material", material_names()},
          {"material.plane", "plane", plane_names()},
          {"method.paper", "paper", paper_names()},
          {"method.kernel", "kernel", kernel_names()},
          {"method.pair", "pair", pair_names()},
          {"method.gradient", "gradient", gradient_names()},
          {"method.momentum", "momentum", momentum_names()},
          {"method.integrator", "integrator", integrator_names()},
          {"method.scheme", "scheme", scheme_names()},
          {"method.wave_speed", "wave speed", wave_speed_names()},
          {"compatible.table", "compatible table", compatible_table_names()},
          {"compatible.start", "compatible start", start_table_names()},
          {"compatible.volumes", "compatible volume", compatible_volume_names()},
          {"compatible.surface", "compatible surface", compatible_surface_names()},
          {"jst.outer", "jst level", outer_laplacian_names()},
          {"boundary.0.kind", "boundary kind", boundary_kind_names()},
          {"boundary.0.face", "face", face_names(3)}};
}

}  // namespace plumb
