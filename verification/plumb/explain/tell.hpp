#pragma once
#include <iosfwd>

#include "verification/plumb/explain/explanation.hpp"

namespace plumb::app {

/// The result of `plumb explain` as text for people.
void tell(std::ostream& out, const Explanation& explanation);

}  // namespace plumb::app
