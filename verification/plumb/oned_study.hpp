#pragma once

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Adds `plumb oned study`: errors under refinement, with fitted orders.
void add_oned_study(CLI::App& group, Session& session);

}  // namespace plumb::app
