#include "lib/geometry/shape.hpp"

#include <fmt/format.h>

#include "lib/geometry/flat_pieces.hpp"
#include "lib/geometry/shape_catalogue.hpp"  // made by CMake from geometry/shapes/*.hpp

namespace plumb {
namespace {

/// Fills in what may be left out; refuses what is missing or has the wrong number of values.
template <int d>
ShapeLengths complete(std::string_view name, const std::vector<ShapeLength>& wanted, ShapeLengths lengths) {
  for (const auto& entry : wanted) {
    const auto found = lengths.find(entry.name);
    if (found == lengths.end()) {
      if (entry.required)
        throw InputError(fmt::format("shape \"{}\" without {}", name, entry.name),
                         "it is not a body without it", fmt::format("give {}", entry.name));
      lengths[entry.name] = std::vector<double>(d, 0.0);
      continue;
    }
    const std::size_t count = found->second.size(), whole = d;
    const bool fits = entry.kind == ShapeLength::Kind::points   ? count > 0 && count % whole == 0
                      : entry.kind == ShapeLength::Kind::length ? count == 1
                                                                : count == whole;
    if (!fits)
      throw InputError(fmt::format("{} of shape \"{}\" has {} values", entry.name, name, count),
                       fmt::format("the scene has {} dimensions", d), "give as many as it needs");
  }
  return lengths;
}

/// The clip of a model; one that knows its flat pieces if the model has flats<d>(X, radius, planes).
template <int d, class S>
std::function<double(const Vec<d>&)> clip_of(const S& model) {
  const auto distance = [model](const Vec<d>& X) { return model.template distance<d>(X); };
  if constexpr (requires(const Vec<d>& X, std::vector<Plane<d>>& planes) {
                  model.template flats<d>(X, 0.0, planes);
                })
    return ClipWithPlanes<d>{distance,
                             [model](const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) {
                               model.template flats<d>(X, radius, planes);
                             }};
  else
    return distance;
}

/// Planes of the faces of a box that come within the radius; none of one without bounds.
template <int d>
void faces_near(const Box<d>& box, const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) {
  if (!box.size.allFinite()) return;
  for (int k = 0; k < d; ++k)
    for (const double face : {box.origin[k], box.origin[k] + box.size[k]})
      if (std::abs(X[k] - face) <= radius)
        planes.push_back({X + (face - X[k]) * Vec<d>::Unit(k), Vec<d>::Unit(k)});
}

/// Whether a shape has flat pieces that are known: those of its clip, or the faces of its box alone.
template <int d>
bool has_planes(const Shape<d>& shape) {
  return !shape.clip || shape.clip.template target<ClipWithPlanes<d>>();
}

}  // namespace

template <int d>
double Shape<d>::distance(const Vec<d>& X) const {
  if (!box.size.allFinite()) return clip(X);
  const Vec<d> half = 0.5 * box.size;
  const Vec<d> beyond = (X - box.origin - half).cwiseAbs() - half;
  const double of_box = beyond.cwiseMax(0).norm() + std::min(0.0, beyond.maxCoeff());
  return clip ? std::max(of_box, clip(X)) : of_box;
}

template <int d>
Shape<d> shape_named(std::string_view name, const ShapeLengths& lengths) {
  Shape<d> shape;
  const bool found = with_named(ShapeCatalogue{}, name, [&]<class S>(Type<S>) {
    if constexpr (S::template dimensions<d>) {
      static_assert(ShapeModel<S, d>);
      const S model(complete<d>(name, S::lengths(), lengths));
      shape.box = model.template box<d>();
      bool whole = requires {
        std::bool_constant<S::fills_its_box>{};
      };
      if constexpr (requires { model.fills_its_box(); }) whole = model.fills_its_box();
      if (!whole) shape.clip = clip_of<d>(model);
    } else {
      throw InputError(fmt::format("shape \"{}\" in {} dimensions", name, d), "it does not exist there", "");
    }
  });
  if (!found) throw unknown_name("shape", name, shape_catalogue_names());
  return shape;
}

template <int d>
Shape<d> without(Shape<d> body, const Shape<d>& hole) {
  const auto distance = [kept = body.clip, hole](const Vec<d>& X) {
    return kept ? std::max(kept(X), -hole.distance(X)) : -hole.distance(X);
  };
  if (!has_planes(hole) && !(body.clip && has_planes(body))) {
    body.clip = distance;
    return body;
  }
  body.clip = ClipWithPlanes<d>{
      distance, [kept = body, hole](const Vec<d>& X, double radius, std::vector<Plane<d>>& planes) {
        planes_near(kept, X, radius, planes);
        planes_near(hole, X, radius, planes);
        if (has_planes(hole)) faces_near(hole.box, X, radius, planes);
      }};
  return body;
}

std::vector<ShapeLength> lengths_of_shape(std::string_view name) {
  std::vector<ShapeLength> lengths;
  if (!with_named(ShapeCatalogue{}, name, [&]<class S>(Type<S>) { lengths = S::lengths(); }))
    throw unknown_name("shape", name, shape_catalogue_names());
  return lengths;
}

std::vector<std::string> shape_catalogue_names() {
  return names_of(ShapeCatalogue{});
}

template struct Shape<2>;
template struct Shape<3>;
template Shape<2> shape_named<2>(std::string_view, const ShapeLengths&);
template Shape<3> shape_named<3>(std::string_view, const ShapeLengths&);
template Shape<2> without<2>(Shape<2>, const Shape<2>&);
template Shape<3> without<3>(Shape<3>, const Shape<3>&);

}  // namespace plumb
