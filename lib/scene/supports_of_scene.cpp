#include "plumbline/scene/supports_of_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

template <int d>
std::vector<Index> supported_particles(const Cloud<d>& cloud, const Boundary& boundary, Layout layout) {
  if (boundary.face) {
    auto found = particles_on_face(cloud, boundary.face->axis, boundary.face->side > 0, layout);
    if (found.empty())
      throw InputError("no particle lies on a face that a boundary names",
                       "it is a face of the box around the body", "use where = \"..\"");
    return found;
  }
  auto found =
      particles_where<d>(cloud, [&](const Vec<d>& X) { return boundary.where->holds_at(in_space(X)); });
  if (found.empty())
    throw InputError(fmt::format("boundary where = \"{}\" holds at no particle", boundary.where->text()),
                     "nothing would be held", "widen the condition");
  return found;
}

}  // namespace

template <int d>
std::vector<Support<d>> supports_of_scene(const Cloud<d>& cloud, const Scene& scene) {
  std::vector<Support<d>> supports;
  for (const auto& boundary : scene.boundaries)
    for (const Index i : supported_particles<d>(cloud, boundary, scene.body.layout)) {
      if (boundary.kind == BoundaryKind::roller) {
        if (scene.body.layout == Layout::mirror) continue;  // images hold it
        supports.push_back({i, boundary.face->axis, 0});
        continue;
      }
      Vec<d> velocity = Vec<d>::Zero();
      if (boundary.kind == BoundaryKind::velocity) velocity = evaluate_at<d>(boundary.velocity, cloud.X[i]);
      for (int k = 0; k < d; ++k) supports.push_back({i, k, velocity[k]});
    }
  supports.shrink_to_fit();
  return supports;
}

template <int d>
void refuse_contradictions(const Cloud<d>& cloud, std::vector<Support<d>> supports) {
  std::stable_sort(supports.begin(), supports.end(), [](const auto& a, const auto& b) {
    return a.particle != b.particle ? a.particle < b.particle : a.component < b.component;
  });
  for (std::size_t n = 1; n < supports.size(); ++n) {
    const auto &a = supports[n - 1], &b = supports[n];
    const double apart = std::abs(a.velocity - b.velocity);
    // 1e-9: the same velocity from two formulas
    if (a.particle != b.particle || a.component != b.component ||
        apart <= 1e-9 * std::max(std::abs(a.velocity), std::abs(b.velocity)))
      continue;
    std::string place;
    for (int k = 0; k < d; ++k) place += fmt::format("{}{:.6g}", k ? ", " : "", cloud.X[a.particle][k]);
    throw InputError(
        fmt::format("boundaries contradict each other at particle {} at ({})", a.particle, place),
        fmt::format("its {} velocity is to be {:g} and {:g} m/s", "xyz"[a.component], a.velocity, b.velocity),
        "let only one of them hold there");
  }
}

template std::vector<Support<2>> supports_of_scene<2>(const Cloud<2>&, const Scene&);
template std::vector<Support<3>> supports_of_scene<3>(const Cloud<3>&, const Scene&);
template void refuse_contradictions<2>(const Cloud<2>&, std::vector<Support<2>>);
template void refuse_contradictions<3>(const Cloud<3>&, std::vector<Support<3>>);

}  // namespace plumb
