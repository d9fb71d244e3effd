#include "verification/plumb/drawing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "lib/output/terminal.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

bool draws(const Session& session) {
  return !session.plot.empty() || (&session.text() == &std::cout && isatty(STDOUT_FILENO) == 1);
}

void draw(const Session& session, const reports::Picture& picture) {
  if (!draws(session)) return;
  if (session.plot.empty()) {
    if (const auto text =
            reports::with_letters(picture, static_cast<std::size_t>(terminal_columns(STDOUT_FILENO))))
      session.text() << *text;
    return;
  }
  for (const auto& dropped : reports::save(picture, session.plot))
    std::cerr << fmt::format("plumb: warning: {}: {} points not drawn, {}\n", dropped.series, dropped.points,
                             dropped.why);
}

void warn(const Session& session, const std::vector<std::string>& warnings) {
  if (session.quiet) return;
  for (const auto& text : warnings) std::cerr << "plumb: warning: " << text << '\n';
}

}  // namespace plumb::app
