#pragma once
#include <string>
#include <vector>

#include "reports/picture.hpp"

namespace plumb::app {
struct Session;

/// Says whether draw() would draw anything.
bool draws(const Session& session);
/// Draws to --plot, if it was given; says on standard error what could not be drawn. Without --plot it draws
/// with letters where text goes to a terminal and gnuplot is installed.
void draw(const Session& session, const reports::Picture& picture);
/// Warns on standard error, unless quiet.
void warn(const Session& session, const std::vector<std::string>& warnings);

}  // namespace plumb::app
