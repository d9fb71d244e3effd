#pragma once

namespace CLI {
class App;
}

namespace plumb::app {
struct Session;

/// Adds `plumb oned correction`: what a correction does to the kernel along the body.
void add_correction(CLI::App& group, Session& session);
/// Adds `plumb oned function`: the function itself as corrected kernels estimate it.
void add_function(CLI::App& group, Session& session);

}  // namespace plumb::app
