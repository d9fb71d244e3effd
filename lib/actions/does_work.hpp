#pragma once
#include <algorithm>

#include "lib/actions/actions.hpp"

namespace plumb {

/// Says whether loads or supports that move can change the energy of a body.
template <int d>
bool does_work(const Actions<d>& actions) {
  return actions.has_loads() ||
         std::any_of(actions.held.begin(), actions.held.end(), [](const Held<d>& held) {
           return !held.steady ||
                  std::any_of(held.places.begin(), held.places.end(), [&](const HeldPlace<d>& place) {
                    return held.motion(place.at, place.component, 0).velocity != 0;
                  });
         });
}

}  // namespace plumb
