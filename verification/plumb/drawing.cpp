#include "verification/plumb/drawing.hpp"

#include <fmt/format.h>

#include <iostream>

#include "verification/plumb/session.hpp"

namespace plumb::app {

void draw(const Session& session, const reports::Picture& picture) {
  if (session.plot.empty()) return;
  for (const auto& dropped : reports::save(picture, session.plot))
    std::cerr << fmt::format("plumb: warning: {}: {} points not drawn, {}\n", dropped.series, dropped.points,
                             dropped.why);
}

void warn(const Session& session, const std::vector<std::string>& warnings) {
  if (session.quiet) return;
  for (const auto& text : warnings) std::cerr << "plumb: warning: " << text << '\n';
}

}  // namespace plumb::app
