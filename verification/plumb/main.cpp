#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>

#include "plumb/commands.hpp"
#include "plumb/provenance.hpp"
#include "plumb/session.hpp"
#include "plumb/usage.hpp"
#include "plumbline/core/sentences.hpp"

namespace {

constexpr int done = 0;
constexpr int failed = 1;
constexpr int bad_input = 2;

int complain(const std::string& text, int code) {
  std::cout << std::flush;
  std::cerr << text << '\n';
  return code;
}

/// Parses, checks at the door, runs the chosen subcommand; the exit code.
int run(CLI::App& program, plumb::Session& session, std::vector<std::string> arguments) {
  try {
    program.parse(arguments);
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    return complain(plumb::usage_error(program, error), bad_input);
  }
  if (!session.action) {
    std::cout << plumb::first_steps(program);
    return done;
  }
  session.check();
  return session.action();
}

}  // namespace

int main(int count, char** arguments) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is a write error with a message, not a death
  try {
    plumb::Session session;
    session.command_line = plumb::shell_line({arguments + std::min(count, 1), arguments + count});
    CLI::App program("Plumbline: total Lagrangian SPH for solids, checked against mathematics", "plumb");
    program.set_version_flag("--version", plumb::version_text());
    plumb::add_all_commands(program, session);
    std::vector<std::string> words =
        plumb::with_help_option(program, {arguments + std::min(count, 1), arguments + count});
    std::reverse(words.begin(), words.end());  // as CLI11 takes a list
    return run(program, session, std::move(words));
  } catch (const plumb::InputError& error) {
    return complain("plumb: " + plumb::message_of(error), bad_input);
  } catch (const std::bad_alloc&) {
    return complain("plumb: out of memory; try a coarser spacing or fewer particles", failed);
  } catch (const std::exception& error) {
    return complain(std::string("plumb: ") + error.what(), failed);
  }
}
