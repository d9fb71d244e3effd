#pragma once
#include <functional>
#include <vector>

#include "plumbline/geometry/layout.hpp"
#include "plumbline/solid/solid.hpp"

namespace plumb {

/// One component of one particle whose motion is prescribed: x = X + V t with constant velocity V, imposed
/// strongly.
template <int d>
struct Support {
  Index particle;
  int component;
  double velocity = 0;  ///< [m/s]
};

/// Particles on a face of the body's box (axis 0..d-1, upper or lower). Cell and mirror layouts: the first
/// particle layer.
template <int d>
std::vector<Index> particles_on_face(const Cloud<d>& cloud, int axis, bool upper, Layout layout);

/// All particles for which the predicate on X holds.
template <int d>
std::vector<Index> particles_where(const Cloud<d>& cloud,
                                   const std::function<bool(const Vec<d>&)>& predicate);

/// The term that takes the force off supported components. Must be the last term. Later supports of the same
/// component win.
template <int d>
Term<d> support_term(const Solid<d>& solid, std::vector<Support<d>> supports);

/// Gives supported components their velocity in the state (at the start of a run).
template <int d>
void impose(const Solid<d>& solid, const std::vector<Support<d>>& supports, State<d>& state);

}  // namespace plumb
