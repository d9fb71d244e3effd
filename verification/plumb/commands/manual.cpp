#include "verification/plumb/shell/manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "verification/plumb/commands.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {

/// `plumb manual`, `plumb-house manual`: the manual page, from the same texts as the help.
void add_manual(CLI::App& program, Session& session) {
  const std::string name = program.get_name();
  add_command(program, session,
              {"manual", fmt::format("the manual page of all commands: {} manual | man -l -", name),
               fmt::format("{0} manual > {0}.1", name)},
              {}, [&session, &program] {
                const std::string page = manual(program, version(), commit_date());
                session.text() << page << std::flush;
                session.write_json({{"text", page}});
                return 0;
              });
}

}  // namespace plumb::app
