#include "lib/scene/make_cloud.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lib/geometry/graded_lattice.hpp"
#include "lib/geometry/shaped_cloud.hpp"
#include "lib/scene/actions_of_scene.hpp"
#include "lib/scene/cloud_file.hpp"
#include "lib/schemes/tlsph/compatible/clipped_surface.hpp"

namespace plumb {
namespace {

template <int d>
Box<d> box_of(const Body& body) {
  Box<d> box;
  for (int k = 0; k < d; ++k) {
    box.origin[k] = body.origin.empty() ? 0.0 : body.origin[k];
    box.size[k] = body.size[k];
  }
  return box;
}

}  // namespace

template <int d>
Shape<d> shape_of(const Body& body) {
  if constexpr (d == 1) {
    return {box_of<d>(body), {}};  // the reader refuses other bodies in 1D
  } else {
    Shape<d> shape =
        body.shape == "box" ? Shape<d>{box_of<d>(body), {}} : shape_named<d>(body.shape, body.lengths);
    for (const auto& hole : body.holes)
      shape = without(std::move(shape), shape_named<d>(hole.name, hole.lengths));
    return shape;
  }
}

template <int d>
std::function<bool(const Vec<d>&)> finer_of(const Body& body) {
  return [finer = *body.finer](const Vec<d>& X) { return finer.holds_at(coordinates_of(X)); };
}

template <int d>
Cloud<d> make_cloud(const Body& body) {
  const Shape<d> shape = shape_of<d>(body);
  if constexpr (d > 1) {
    if (!body.file.empty()) return cloud_of_file<d>(body);
    const bool whole_lattice = !shape.clip && body.cloud == "lattice";
    if (body.layout == Layout::mirror && !whole_lattice)
      throw InputError("layout = \"mirror\" for a shape with holes or curves, or for blue noise",
                       "images are reflected at the faces of a box that a lattice fills", "use node or cell");
    if (!whole_lattice)
      return shaped_cloud<d>(
          shape, {*body.spacing, body.layout, body.cloud == "blue-noise", body.jitter, body.seed});
  }
  if (body.finer)
    return graded_lattice<d>(shape.box, *body.spacing, finer_of<d>(body), body.jitter, body.seed);
  Cloud<d> cloud = lattice<d>(shape.box, cells_of<d>(shape.box, *body.spacing), body.layout);
  return body.jitter > 0 ? jittered<d>(std::move(cloud), body.jitter, body.seed, body.layout) : cloud;
}

template <int d>
Cloud<d> make_cloud(const Scene& scene) {
  Cloud<d> all = make_cloud<d>(scene.body);
  if (scene.others.empty()) return all;
  all.body.assign(all.X.size(), 0);
  all.line = 0;
  all.count = all.stride = {};
  for (const Body& body : scene.others) {
    const Cloud<d> cloud = make_cloud<d>(body);
    constexpr double same = 1e-9;  // two roundings of one length
    if (std::abs(cloud.spacing - all.spacing) > same * all.spacing)
      throw InputError(fmt::format("spacings of {:g} m in body \"{}\" and {:g} m in body \"{}\"", all.spacing,
                                   scene.body.name, cloud.spacing, body.name),
                       "particles of bodies that touch are as far apart", "use one spacing");
    const Vec<d> end = (all.box.origin + all.box.size).cwiseMax(cloud.box.origin + cloud.box.size);
    all.box.origin = all.box.origin.cwiseMin(cloud.box.origin);
    all.box.size = end - all.box.origin;
    all.X.insert(all.X.end(), cloud.X.begin(), cloud.X.end());
    all.V.insert(all.V.end(), cloud.V.begin(), cloud.V.end());
    all.body.resize(all.X.size(), all.body.back() + 1);
  }
  return all;
}

template <int d>
Surface<d> surface_of(const Body& body, const Cloud<d>& cloud) {
  const Shape<d> shape = shape_of<d>(body);
  if constexpr (d > 1)
    if (shape.clip) return clipped_surface<d>(cloud, shape);
  return box_surface<d>(cloud);
}

template Shape<1> shape_of<1>(const Body&);
template Shape<2> shape_of<2>(const Body&);
template Shape<3> shape_of<3>(const Body&);
template Cloud<1> make_cloud<1>(const Scene&);
template Cloud<2> make_cloud<2>(const Scene&);
template Cloud<3> make_cloud<3>(const Scene&);
template std::function<bool(const Vec<1>&)> finer_of<1>(const Body&);
template Cloud<1> make_cloud<1>(const Body&);
template std::function<bool(const Vec<2>&)> finer_of<2>(const Body&);
template Cloud<2> make_cloud<2>(const Body&);
template std::function<bool(const Vec<3>&)> finer_of<3>(const Body&);
template Cloud<3> make_cloud<3>(const Body&);
template Surface<1> surface_of<1>(const Body&, const Cloud<1>&);
template Surface<2> surface_of<2>(const Body&, const Cloud<2>&);
template Surface<3> surface_of<3>(const Body&, const Cloud<3>&);

}  // namespace plumb
