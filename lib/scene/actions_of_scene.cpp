#include "lib/scene/actions_of_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/core/error.hpp"
#include "lib/scene/held_motion.hpp"
#include "lib/schemes/tlsph/boundary/supports.hpp"

namespace plumb {
namespace {

/// "x-", or "where = ..": what results call a boundary that has no name.
std::string name_of(const Boundary& boundary) {
  if (!boundary.face) return fmt::format("where {}", boundary.where->text());
  return fmt::format("{}{}", "xyz"[boundary.face->axis], boundary.face->side > 0 ? '+' : '-');
}

InputError holds_nowhere(const Boundary& boundary, const std::string& what) {
  return {fmt::format("boundary where = \"{}\" holds at no {}", boundary.where->text(), what),
          is_load(boundary.kind) ? "nothing would be loaded" : "nothing would be held",
          "widen the condition"};
}

template <int d>
std::vector<Index> held_particles(const Cloud<d>& cloud, const Boundary& boundary, Layout layout) {
  if (boundary.face) {
    auto found = particles_on_face(cloud, boundary.face->axis, boundary.face->side > 0, layout);
    if (found.empty())
      throw InputError("no particle lies on a face that a boundary names",
                       "it is a face of the box around the body", "use where = \"..\"");
    return found;
  }
  auto found =
      particles_where<d>(cloud, [&](const Vec<d>& X) { return boundary.where->holds_at(coordinates_of(X)); });
  if (found.empty()) throw holds_nowhere(boundary, "particle");
  return found;
}

template <int d>
Held<d> held_of(const Cloud<d>& cloud, const Boundary& boundary, Layout layout, double time_scale) {
  Held<d> held;
  held.name = name_of(boundary);
  held.steady = is_steady(boundary);
  held.motion = [boundary, time_scale](const Vec<d>& at, int component, double time) {
    return prescribed_motion(boundary, coordinates_of(at), component, time, time_scale);
  };
  for (const Index i : held_particles<d>(cloud, boundary, layout)) {
    if (boundary.kind == BoundaryKind::roller) {
      held.places.push_back({i, boundary.face->axis, cloud.X[i]});
      continue;
    }
    for (int k = 0; k < d; ++k) held.places.push_back({i, k, cloud.X[i]});
  }
  held.places.shrink_to_fit();
  return held;
}

/// Whether the facet lies on the face: on its plane and turned outwards.
template <int d>
bool lies_on(const Facet<d>& facet, const Face& face, const Cloud<d>& cloud) {
  const double plane = cloud.box.origin[face.axis] + (face.side > 0 ? cloud.box.size[face.axis] : 0);
  // 1e-6: rounding of cells that were cut; a slope of 1e-6 rad is no slope
  return std::abs(facet.centroid[face.axis] - plane) < 1e-6 * cloud.spacing &&
         facet.area[face.axis] * face.side > (1 - 1e-12) * facet.area.norm();
}

/// The middle of a facet. Those of node lattices are told at their particle, which lies at the rim of the
/// facets of edges and corners.
template <int d>
Vec<d> middle_of(const Facet<d>& facet, const Cloud<d>& cloud) {
  Vec<d> middle = facet.centroid;
  if (cloud.line == 0) return middle;
  for (int a = 0; a < d; ++a) {
    if (std::abs(facet.area[a]) > 0) continue;  // the facet's own axis
    const double cell = cloud.box.size[a] / static_cast<double>(std::max<Index>(1, cloud.count[a] - 1));
    const double below = middle[a] - cloud.box.origin[a], above = cloud.box.size[a] - below;
    if (below < 1e-6 * cell) middle[a] += cell / 4;
    if (above < 1e-6 * cell) middle[a] -= cell / 4;
  }
  return middle;
}

/// The pieces of the surface, and the flat sides that they make, if it is known who shares those.
template <int d>
struct Pieces {
  std::vector<Facet<d>> facets;
  std::vector<FlatSide<d>> sides;
};

/// Loads every particle that shares a side at the point of the side next to it.
template <int d, class On>
void load_sides(const Cloud<d>& cloud, const Pieces<d>& pieces, On&& on, SurfaceLoad<d>& load) {
  for (const FlatSide<d>& side : pieces.sides)
    for (const AreaShare& part : side.areas([&](Index f) { return on(pieces.facets[f]); })) {
      const Vec<d>& X = cloud.X[part.particle];
      const Vec<d> at = X + side.normal.dot(side.point - X) * side.normal;
      load.places.push_back({part.particle, at, side.normal, part.share});
    }
}

template <int d>
SurfaceLoad<d> surface_load_of(const Cloud<d>& cloud, const Boundary& boundary, const Pieces<d>& pieces) {
  SurfaceLoad<d> load;
  load.name = name_of(boundary);
  const auto on = [&](const Facet<d>& facet) {
    return boundary.face ? lies_on(facet, *boundary.face, cloud)
                         : boundary.where->holds_at(coordinates_of(middle_of(facet, cloud)));
  };
  load_sides(cloud, pieces, on, load);
  if (pieces.sides.empty())
    for (const Facet<d>& facet : pieces.facets)
      if (on(facet)) load.places.push_back({facet.owner, middle_of(facet, cloud), facet.area});
  if (load.places.empty()) {
    if (!boundary.face) throw holds_nowhere(boundary, "piece of the surface");
    throw InputError("no piece of the surface lies on a face that a boundary names",
                     "it is a face of the box around the body", "use where = \"..\"");
  }
  const auto& formulas = boundary.traction;
  if (boundary.kind == BoundaryKind::pressure) {
    load.pressure = [boundary](const Vec<d>& at, double time) {
      return ramp_share(boundary.ramp, time) * boundary.pressure->at(coordinates_of(at), time);
    };
    load.steady = !boundary.ramp && !boundary.pressure->uses_time();
  } else {
    load.traction = [boundary](const Vec<d>& at, const Vec<d>&, double time) -> Vec<d> {
      return ramp_share(boundary.ramp, time) * evaluate_at<d>(boundary.traction, at, time);
    };
    load.steady = !boundary.ramp && std::none_of(formulas.begin(), formulas.end(),
                                                 [](const Expression& f) { return f.uses_time(); });
  }
  return load;
}

template <int d>
void add_body_force(const std::string& name, const std::vector<Expression>& formulas, double factor,
                    const std::optional<double>& ramp, Actions<d>& actions) {
  if (formulas.empty()) return;
  BodyForce<d> force;
  force.name = name;
  force.per_volume = [formulas, factor, ramp](const Vec<d>& X, double time) -> Vec<d> {
    return factor * ramp_share(ramp, time) * evaluate_at<d>(formulas, X, time);
  };
  force.steady = !ramp && std::none_of(formulas.begin(), formulas.end(),
                                       [](const Expression& f) { return f.uses_time(); });
  actions.body_forces.push_back(std::move(force));
}

}  // namespace

template <int d>
Actions<d> actions_of_scene(const Cloud<d>& cloud, const Scene& scene,
                            const std::function<std::vector<Facet<d>>()>& facets, double time_scale,
                            const std::function<std::vector<FlatSide<d>>()>& sides) {
  Actions<d> actions;
  std::optional<Pieces<d>> surface;
  for (const Boundary& boundary : scene.boundaries) {
    if (is_load(boundary.kind)) {
      if (!surface) surface = Pieces<d>{facets(), sides ? sides() : std::vector<FlatSide<d>>()};
      actions.surface.push_back(surface_load_of<d>(cloud, boundary, *surface));
      continue;
    }
    const bool images_hold_it = boundary.kind == BoundaryKind::roller && scene.body.layout == Layout::mirror;
    if (!images_hold_it) actions.held.push_back(held_of<d>(cloud, boundary, scene.body.layout, time_scale));
  }
  if (!scene.load) return actions;
  add_body_force<d>("gravity", scene.load->gravity, scene.material.density, scene.load->ramp, actions);
  add_body_force<d>("body force", scene.load->body_force, 1, scene.load->ramp, actions);
  return actions;
}

template <int d>
void refuse_contradictions(const Cloud<d>& cloud, const Actions<d>& actions, double time_scale) {
  struct Entry {
    Index particle;
    int component;
    const Held<d>* held;
  };
  std::vector<Entry> entries;
  for (const auto& held : actions.held)
    for (const auto& place : held.places) entries.push_back({place.particle, place.component, &held});
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return a.particle != b.particle ? a.particle < b.particle : a.component < b.component;
  });
  for (std::size_t n = 1; n < entries.size(); ++n) {
    const auto &a = entries[n - 1], &b = entries[n];
    if (a.particle != b.particle || a.component != b.component) continue;
    const Vec<d>& X = cloud.X[a.particle];
    for (const double part :
         {0.0, 0.37, 1.0}) {  // of the time: paths that agree there are taken for the same
      const double va = a.held->motion(X, a.component, part * time_scale).velocity;
      const double vb = b.held->motion(X, b.component, part * time_scale).velocity;
      // 1e-9: the same velocity from two formulas
      if (std::abs(va - vb) <= 1e-9 * std::max(std::abs(va), std::abs(vb))) continue;
      std::string place;
      for (int k = 0; k < d; ++k) place += fmt::format("{}{:.6g}", k ? ", " : "", X[k]);
      throw InputError(
          fmt::format("boundaries contradict each other at particle {} at ({})", a.particle, place),
          fmt::format("its {} velocity is to be {:g} and {:g} m/s", "xyz"[a.component], va, vb),
          "let only one of them hold there");
    }
  }
}

#define PLUMBLINE_INSTANTIATE(d)                                                                 \
  template Actions<d> actions_of_scene<d>(const Cloud<d>&, const Scene&,                         \
                                          const std::function<std::vector<Facet<d>>()>&, double, \
                                          const std::function<std::vector<FlatSide<d>>()>&);     \
  template void refuse_contradictions<d>(const Cloud<d>&, const Actions<d>&, double);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb
