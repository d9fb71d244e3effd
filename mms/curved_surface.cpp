#include "mms/curved_surface.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "lib/kernel/kernel.hpp"
#include "lib/scene/make_cloud.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"
#include "mms/level.hpp"

namespace plumb::mms {
namespace {

constexpr double rounding = 1e-9;  // of faces that voro++ cuts

/// Whether a facet is a piece of a face of the box.
template <int d>
bool is_part_of_a_face(const Facet<d>& facet, const Box<d>& box) {
  for (int k = 0; k < d; ++k) {
    const double along = std::abs(facet.area[k]) / facet.area.norm();
    const double below = facet.centroid[k] - box.origin[k];
    const double off = facet.area[k] > 0 ? box.size[k] - below : below;
    if (along > 1 - rounding && std::abs(off) < rounding * box.size[k]) return true;
  }
  return false;
}

template <int d>
bool lies_on_a_face(const Vec<d>& X, const Box<d>& box) {
  for (int k = 0; k < d; ++k)
    if (std::min(X[k] - box.origin[k], box.origin[k] + box.size[k] - X[k]) < rounding * box.size[k])
      return true;
  return false;
}

/// Area vectors B_i [m^(d-1)] that compatible bonds of this body are made with, THEORY (11.6): they depend on the volumes before these
/// are changed, too.
template <int d>
std::vector<Vec<d>> areas_of_bonds(const Study& study, const Manufactured<d>& solution,
                                   const Solid<d>& solid) {
  const Cloud<d> cloud = make_cloud<d>(with_spacing(study.body, solid.cloud.spacing));
  return boundary_vectors<d>(cloud, kernel_named<d>(study.method.kernel), solid.smoothing_length,
                             surface_of<d>(study, solution, cloud))
      .B;
}

}  // namespace

bool has_curved_surface(const Study& study) {
  return study.body.shape != "box" || !study.body.holes.empty();
}

template <int d>
CurvedSurface<d> curved_surface(const Study& study, const Manufactured<d>& solution, const Solid<d>& solid) {
  const Cloud<d>& cloud = solid.cloud;
  const bool box = study.body.shape == "box";
  std::set<Index> owners;
  for (const Facet<d>& facet : surface_of<d>(study, solution, cloud).facets)
    if (!box || !is_part_of_a_face(facet, cloud.box)) owners.insert(facet.owner);
  CurvedSurface<d> found;
  if (study.surface == "displaced") found.displaced.assign(owners.begin(), owners.end());
  const auto areas = areas_of_bonds<d>(study, solution, solid);
  for (Index i = 0; i < cloud.size(); ++i) {
    const bool follows = study.surface == "displaced" && owners.contains(i);
    const Vec<d>& area = areas[static_cast<std::size_t>(i)];
    if (!follows && !(box && lies_on_a_face(cloud.X[i], cloud.box)) && area.norm() > 0)
      found.pulled.push_back({i, cloud.X[i], area});
  }
  return found;
}

template <int d>
void hold_half(const Cloud<d>& cloud, CurvedSurface<d>& surface) {
  const double middle = cloud.box.origin[0] + cloud.box.size[0] / 2;
  const auto is_held = [&](const LoadedPlace<d>& place) { return place.at[0] < middle; };
  for (const LoadedPlace<d>& place : surface.pulled)
    if (is_held(place)) surface.displaced.push_back(place.particle);
  std::erase_if(surface.pulled, is_held);
  std::sort(surface.displaced.begin(), surface.displaced.end());
}

#define PLUMBLINE_INSTANTIATE(d)                                                                      \
  template CurvedSurface<d> curved_surface<d>(const Study&, const Manufactured<d>&, const Solid<d>&); \
  template void hold_half<d>(const Cloud<d>&, CurvedSurface<d>&);
PLUMBLINE_INSTANTIATE(1)
PLUMBLINE_INSTANTIATE(2)
PLUMBLINE_INSTANTIATE(3)
#undef PLUMBLINE_INSTANTIATE

}  // namespace plumb::mms
