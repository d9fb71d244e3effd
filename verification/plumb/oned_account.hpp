#pragma once

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Adds `plumb oned account`: which sentences of paper 000 on the 1D study hold.
void add_account(CLI::App& group, Session& session);

}  // namespace plumb::app
