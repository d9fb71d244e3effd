#pragma once
#include <string>
#include <vector>

#include "reports/picture.hpp"

namespace plumb::app {
struct Session;

/// Draws to --plot, if it was given; says on standard error what could not be drawn.
void draw(const Session& session, const reports::Picture& picture);
/// Warns on standard error, unless quiet.
void warn(const Session& session, const std::vector<std::string>& warnings);

}  // namespace plumb::app
