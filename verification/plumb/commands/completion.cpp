#include "verification/plumb/shell/completion.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "verification/plumb/commands.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

/// `plumb completion bash|zsh`: scripts for the shells, from the same texts as the help.
void add_completion(CLI::App& program, Session& session) {
  CLI::App& group = add_command_group(
      program, session,
      {"completion", "completion of commands and options in a shell: bash, zsh", "plumb completion bash"});
  const auto add = [&](const CommandText& text, std::string (*script)(const CLI::App&)) {
    add_command(group, session, text, {}, [&session, &program, script] {
      session.text() << script(program) << std::flush;
      session.write_json({{"text", script(program)}});
      return 0;
    });
  };
  add({"bash", "completion script for bash", "plumb completion bash > plumb.bash"}, &bash_completion);
  add({"zsh", "completion script for zsh", "plumb completion zsh > _plumb"}, &zsh_completion);
}

}  // namespace plumb::app
