#pragma once
#include <string>

#include "lib/run/frame.hpp"
#include "reports/picture.hpp"

namespace plumb::app {

/// A body as it is now, coloured by its von Mises stress; of a bar the stress along it. `spacing` is the
/// distance of its particles [m].
template <int d>
reports::Picture body_plot(const std::string& name, const Snapshot<d>& shown, double spacing);

}  // namespace plumb::app
