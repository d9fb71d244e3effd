#include "verification/plumb/shell/manual.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "verification/plumb/commands.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

/// `plumb manual`: the manual page, from the same texts as the help.
void add_manual(CLI::App& program, Session& session) {
  add_command(
      program, session,
      {"manual", "the manual page of all commands: plumb manual | man -l -", "plumb manual > plumb.1"}, {},
      [&session, &program] {
        const std::string page = manual(program, version(), commit_date());
        session.text() << page << std::flush;
        session.write_json({{"text", page}});
        return 0;
      });
}

}  // namespace plumb::app
