#pragma once
#include <functional>

#include "lib/geometry/shape.hpp"
#include "lib/scene/scene.hpp"
#include "lib/schemes/tlsph/compatible/boundary_vectors.hpp"

/// What every scheme makes of [body].
namespace plumb {

/// The shape of [body] less its holes.
template <int d>
Shape<d> shape_of(const Body& body);

/// The surface of [body] around its particles.
template <int d>
Surface<d> surface_of(const Body& body, const Cloud<d>& cloud);

/// Particles of all bodies of a scene, one body after the other. InputError if their spacings differ.
template <int d>
Cloud<d> make_cloud(const Scene& scene);

/// Says where the cells of a graded body are halved; only for those that have body.finer.
template <int d>
std::function<bool(const Vec<d>&)> finer_of(const Body& body);

/// Particles of [body].
template <int d>
Cloud<d> make_cloud(const Body& body);

}  // namespace plumb
