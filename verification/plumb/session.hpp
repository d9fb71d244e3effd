#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "lib/output/progress.hpp"
#include "lib/output/table.hpp"

namespace CLI {
class App;
}

namespace plumb::app {

/// One call of the program: the options that every subcommand shares, and the only ways out for results.
/// A subcommand computes first and writes last, so that bad input leaves nothing behind.
struct Session {
  std::string json;          ///< --json FILE; "-" is standard output, empty: not asked for
  std::string csv;           ///< --csv FILE; likewise
  std::string plot;          ///< --plot FILE.svg|.png
  int threads = 0;           ///< --threads N; 0: all that OpenMP offers
  bool quiet = false;        ///< --quiet: no progress, no text, only errors and what was asked for
  std::string command_line;  ///< "plumb oned study --n 20,40", quoted for a shell
  std::string kind;          ///< words of the chosen subcommand: "oned study"

  std::function<int()> action;  ///< the chosen subcommand; returns the exit code (0 done, 1 a check failed)

  /// Text for people: standard output, or nowhere when quiet or when results go to standard output.
  std::ostream& text() const;
  /// Progress for long work on standard error, in the style that fits.
  Progress::Style progress() const { return Progress::style_for_stderr(quiet); }

  /// Takes `result` (an object) for --json, if asked for. It is written in the shape of all results
  /// (result.hpp), non-finite numbers as null with a reason, when the exit code is known: by finish().
  void write_json(const nlohmann::ordered_json& result) const;
  /// Writes what write_json() took, if anything. Returns the exit code. Throws OutputError if that fails.
  int finish(int exit_code) const;
  /// Writes a result at once, whether asked for or not, to a file that the subcommand chose.
  void write_json_file(const nlohmann::ordered_json& result, const std::filesystem::path& file,
                       int exit_code) const;
  /// A warning on standard error, unless quiet.
  void warn(const std::string& text) const;
  /// Writes the table to --csv, if asked for.
  void write_csv(const Table& table) const;
  /// Writes a JSON array of flat objects ("rows") to --csv, if asked for.
  void write_csv(const nlohmann::ordered_json& rows) const;
  /// Shows the table as text and writes it to --csv.
  void write_table(const nlohmann::ordered_json& rows) const;

  /// Checks the shared options and applies --threads. Throws InputError.
  void check() const;

 private:
  mutable std::shared_ptr<const nlohmann::ordered_json> result_;  ///< waits for the exit code
};

/// What a subcommand is called and how it is explained. `example` is one copyable line.
struct CommandText {
  std::string name;
  std::string description;
  std::string example;
};

/// What a subcommand can make beside JSON: a table for --csv, a picture for --plot.
struct Makes {
  bool table = false;
  bool plot = false;
};

/// Heading of the options that every subcommand shares, in the help.
inline constexpr const char* shared_options = "Options of all commands";

/// Adds a subcommand with the shared options to `parent`; `action` runs after parsing and returns the exit
/// code. The caller adds its own options to the value returned.
CLI::App& add_command(CLI::App& parent, Session& session, const CommandText& text, Makes makes,
                      std::function<int()> action);

/// Adds a group of subcommands ("oned"). Called without one of them, it runs `alone`, or prints its help.
CLI::App& add_command_group(CLI::App& parent, Session& session, const CommandText& text,
                            std::function<int()> alone = {});

}  // namespace plumb::app
