#pragma once
#include <string>

namespace CLI {
class App;
}

namespace plumb::app {

/// A script that makes bash complete subcommands, options and files of `program`.
std::string bash_completion(const CLI::App& program);

/// The same for zsh, with what each word means. To be found as `_plumb` in a folder of $fpath.
std::string zsh_completion(const CLI::App& program);

}  // namespace plumb::app
