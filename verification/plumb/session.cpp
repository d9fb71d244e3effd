#include "verification/plumb/session.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/json.hpp"
#include "verification/plumb/result.hpp"

namespace plumb::app {
namespace {

constexpr int most_threads = 1024;

void write(const std::string& file, const std::string& content) {
  if (file != "-") return replace_file(file, content);
  std::cout << content << std::flush;
  if (!std::cout) throw OutputError("cannot write to standard output");
}

void check_file(const std::string& file, const char* option) {
  if (!file.empty() && file != "-") require_writable(file, option);
}

/// The complaint about a file name, empty if there is none.
std::string file_name(const std::string& text) {
  return text.empty() ? "the file name is empty" : "";
}

/// The complaint about the value of --threads, empty if there is none.
std::string thread_count(const std::string& text) {
  const bool whole =
      !text.empty() && text.find_first_not_of("0123456789") == std::string::npos && text.size() < 5;
  const int count = whole ? std::stoi(text) : 0;
  if (count >= 1 && count <= most_threads) return {};
  return fmt::format("\"{}\" is not a whole number from 1 to {}", text, most_threads);
}

/// "oned study" for the subcommand of that name below `parent`.
std::string words_of(const CLI::App& parent, const std::string& name) {
  return parent.get_parent() == nullptr ? name
                                        : words_of(*parent.get_parent(), parent.get_name()) + " " + name;
}

}  // namespace

std::ostream& Session::text() const {
  static std::ostream nowhere(nullptr);
  return quiet || json == "-" || csv == "-" ? nowhere : std::cout;
}

void Session::write_json(const nlohmann::ordered_json& result) const {
  if (!json.empty()) result_ = std::make_shared<const nlohmann::ordered_json>(result);
}

int Session::finish(int exit_code) const {
  if (result_) write(json, json_text(document(*result_, {kind, command_line, exit_code})));
  result_.reset();
  return exit_code;
}

void Session::write_json_file(const nlohmann::ordered_json& result, const std::filesystem::path& file,
                              int exit_code) const {
  replace_file(file, json_text(document(result, {kind, command_line, exit_code})));
}

void Session::warn(const std::string& text) const {
  if (!quiet) std::cerr << "warning: " << text << '\n';
}

void Session::write_csv(const Table& table) const {
  if (!csv.empty()) write(csv, csv_text(table));
}

void Session::write_csv(const nlohmann::ordered_json& rows) const {
  if (!csv.empty()) write_csv(table_of(rows));
}

void Session::write_table(const nlohmann::ordered_json& rows) const {
  const Table table = table_of(rows);
  text() << plain_text(table) << std::flush;
  write_csv(table);
}

void Session::check() const {
  for (const auto& [file, other] : {std::pair(&json, &csv), std::pair(&json, &plot), std::pair(&csv, &plot)})
    if (!file->empty() && *file == *other)
      throw InputError(fmt::format("\"{}\" is named for two results", *file), "one would replace the other",
                       "give each its own file");
  check_file(json, "--json");
  check_file(csv, "--csv");
  check_file(plot, "--plot");
  const auto extension = std::filesystem::path(plot).extension();
  if (!plot.empty() && extension != ".svg" && extension != ".png")
    throw InputError(fmt::format("--plot: unknown kind of picture \"{}\"", plot),
                     "the name must end in .svg or .png", "");
  if (threads > 0) omp_set_num_threads(threads);
}

CLI::App& add_command(CLI::App& parent, Session& session, const CommandText& text, Makes makes,
                      std::function<int()> action) {
  CLI::App& command = *parent.add_subcommand(text.name, text.description);
  command.footer("Example: " + text.example);
  const auto file_option = [&command](const char* name, std::string& file, const char* description) {
    command.add_option(name, file, description)->type_name("FILE")->check(file_name)->group(shared_options);
  };
  file_option("--json", session.json, "write the result as JSON to FILE (- for standard output)");
  if (makes.table)
    file_option("--csv", session.csv, "write the table as CSV to FILE (- for standard output)");
  if (makes.plot) file_option("--plot", session.plot, "draw to FILE.svg or FILE.png");
  command.add_option("--threads", session.threads, "threads to use (default: all cores)")
      ->type_name("N")
      ->check(thread_count)
      ->group(shared_options);
  command.add_flag("--quiet", session.quiet, "no progress and no text")->group(shared_options);
  command.final_callback([&session, words = words_of(parent, text.name), action = std::move(action)] {
    session.kind = words;
    session.action = action;
  });
  return command;
}

CLI::App& add_command_group(CLI::App& parent, Session& session, const CommandText& text,
                            std::function<int()> alone) {
  CLI::App& group = *parent.add_subcommand(text.name, text.description);
  group.footer("Example: " + text.example);
  const auto say_help = [&group] {
    std::cout << group.help("plumb");
    return 0;
  };
  group.final_callback([&session, &group, action = alone ? std::move(alone) : say_help] {
    if (group.get_subcommands().empty()) session.action = action;
  });
  return group;
}

}  // namespace plumb::app
