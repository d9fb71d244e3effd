#include "verification/plumb/program.hpp"

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
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/result.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/run/waiting.hpp"
#include "verification/plumb/session.hpp"
#include "verification/plumb/usage.hpp"

namespace plumb::app {
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
int complain(const std::exception& error, const std::string& text, int code, const std::string& line,
             const std::vector<std::string>& words) {
  const std::string file = json_destination(words);
  if (!file.empty()) try {
      const auto json = json_text(error_document(error, {"", line, code}));
      file == "-" ? void(std::cout << json) : replace_file(file, json);
    } catch (const std::exception&) {
    }
  return complain(text, code);
}

/// Parses, checks at the door, runs the chosen subcommand; the exit code.
int run(CLI::App& program, Session& session, const std::vector<std::string>& words, char** arguments) {
  try {
    std::vector<std::string> list = with_help_option(program, words);
    std::reverse(list.begin(), list.end());  // as CLI11 takes a list
    program.parse(std::move(list));
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::string text = usage_error(program, error);
    return complain(InputError(text, "", ""), text, bad_input, session.command_line, words);
  }
  if (!session.action) {
    std::cout << first_steps(program);
    return done;
  }
  session.check();
  if (session.threads != 1) let_waiting_threads_sleep(arguments);
  return session.finish(session.action());
}

/// The exit code when all text has been taken: what was lost on a full device must not look like success.
int flushed(const std::string& name, int code) {
  if (std::cout.flush()) return code;
  std::cerr << name << ": cannot write to standard output\n";
  return code == done ? failed : code;
}

}  // namespace

int run_program(const Program& described, int count, char** arguments) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is a write error with a message, not a death
  const std::vector<std::string> words = words_of(count, arguments);
  const std::string line = shell_line(words, described.name), start = described.name + ": ";
  try {
    if (described.hand_over) described.hand_over(words, arguments);
    Session session;
    session.command_line = line;
    CLI::App program(described.description, described.name);
    program.set_version_flag("--version", version_text());
    described.add_commands(program, session);
    return flushed(described.name, run(program, session, words, arguments));
  } catch (const InputError& error) {
    return complain(error, start + error.what(), bad_input, line, words);
  } catch (const SittingEnded& ended) {  // no error: the same call goes on from there
    return complain(start + ended.what(), interrupt_exit_code());
  } catch (const std::bad_alloc&) {
    const std::runtime_error error("out of memory; try a coarser spacing or fewer particles");
    return complain(error, start + error.what(), failed, line, words);
  } catch (const std::exception& error) {
    return complain(error, start + error.what(), failed, line, words);
  }
}

std::optional<std::filesystem::path> program_beside(const std::string& name) {
  std::error_code none;
  const auto beside = std::filesystem::canonical("/proc/self/exe", none).parent_path() / name;
  return !none && std::filesystem::exists(beside) ? std::optional(beside) : std::nullopt;
}

std::filesystem::path required_program() {
  if (const auto program = program_beside("plumb")) return *program;
  throw InputError("there is no plumb beside this program", "its commands are called",
                   "install the package plumbline, or build the target plumb");
}

}  // namespace plumb::app
