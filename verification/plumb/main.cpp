#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/json.hpp"
#include "lib/output/sitting.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/result.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/run/waiting.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/usage.hpp"

namespace {

constexpr int done = 0;
constexpr int failed = 1;
constexpr int bad_input = 2;

int complain(const std::string& text, int code) {
  std::cout << std::flush;
  std::cerr << text << '\n';
  return code;
}

/// The arguments behind the name of the program.
std::vector<std::string> words_of(int count, char** arguments) {
  return {arguments + std::min(count, 1), arguments + count};
}

/// Says the error, and writes it as JSON where --json asks for the result. That it cannot be written there is
/// no second error.
int complain(const std::exception& error, const std::string& text, int code,
             const std::vector<std::string>& words) {
  const std::string file = plumb::app::json_destination(words);
  if (!file.empty()) try {
      const auto json =
          plumb::json_text(plumb::app::error_document(error, {"", plumb::app::shell_line(words), code}));
      file == "-" ? void(std::cout << json) : plumb::replace_file(file, json);
    } catch (const std::exception&) {
    }
  return complain(text, code);
}

/// Parses, checks at the door, runs the chosen subcommand; the exit code.
int run(CLI::App& program, plumb::app::Session& session, const std::vector<std::string>& words,
        char** arguments) {
  try {
    std::vector<std::string> list = plumb::app::with_help_option(program, words);
    std::reverse(list.begin(), list.end());  // as CLI11 takes a list
    program.parse(std::move(list));
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::string text = plumb::app::usage_error(program, error);
    return complain(plumb::InputError(text, "", ""), text, bad_input, words);
  }
  if (!session.action) {
    std::cout << plumb::app::first_steps(program);
    return done;
  }
  session.check();
  if (session.threads != 1) plumb::app::let_waiting_threads_sleep(arguments);
  return session.finish(session.action());
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
    plumb::app::Session session;
    session.command_line = plumb::app::shell_line(words_of(count, arguments));
    CLI::App program("Plumbline: total Lagrangian SPH for solids, checked against mathematics", "plumb");
    program.set_version_flag("--version", plumb::app::version_text());
    plumb::app::add_all_commands(program, session);
    return flushed(run(program, session, words_of(count, arguments), arguments));
  } catch (const plumb::InputError& error) {
    return complain(error, std::string("plumb: ") + error.what(), bad_input, words_of(count, arguments));
  } catch (const plumb::SittingEnded& ended) {  // no error: the same call goes on from there
    return complain(std::string("plumb: ") + ended.what(), plumb::app::interrupt_exit_code());
  } catch (const std::bad_alloc&) {
    const std::runtime_error error("out of memory; try a coarser spacing or fewer particles");
    return complain(error, std::string("plumb: ") + error.what(), failed, words_of(count, arguments));
  } catch (const std::exception& error) {
    return complain(error, std::string("plumb: ") + error.what(), failed, words_of(count, arguments));
  }
}
