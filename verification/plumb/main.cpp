#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <new>

#include "plumb/commands.hpp"
#include "plumb/provenance.hpp"
#include "plumb/run/interrupt.hpp"
#include "plumb/run/waiting.hpp"
#include "plumb/session.hpp"
#include "plumb/usage.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/output/sitting.hpp"

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
int run(CLI::App& program, plumb::Session& session, int count, char** arguments) {
  try {
    program.parse(count, arguments);
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
  if (session.threads != 1) plumb::let_waiting_threads_sleep(arguments);
  return session.action();
}

/// The exit code when all text has been taken: what was lost on a full device must not look like success.
int flushed(int code) {
  if (std::cout.flush()) return code;
  std::cerr << "plumb: cannot write to standard output\n";
  return code == done ? failed : code;
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
    return flushed(run(program, session, count, arguments));
  } catch (const plumb::InputError& error) {
    return complain(std::string("plumb: ") + error.what(), bad_input);
  } catch (const plumb::SittingEnded& ended) {
    return complain(std::string("plumb: ") + ended.what(), plumb::interrupt_exit_code());
  } catch (const std::bad_alloc&) {
    return complain("plumb: out of memory; try a coarser spacing or fewer particles", failed);
  } catch (const std::exception& error) {
    return complain(std::string("plumb: ") + error.what(), failed);
  }
}
