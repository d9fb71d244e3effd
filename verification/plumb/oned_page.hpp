#pragma once
#include <string>

namespace plumb::app {

/// The explorer of kernel corrections as one page that needs nothing else: kernels, radii, jitters, places,
/// fields and estimates to choose from, every number computed by the functions behind `plumb oned`.
std::string explorer_page();

/// What the page shows first, in words: the correction at a wall and inside, and how long waves must be.
std::string explorer_overview();

}  // namespace plumb::app
