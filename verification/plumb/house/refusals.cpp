#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "lib/core/error.hpp"
#include "lib/input/section.hpp"
#include "lib/output/file.hpp"
#include "lib/scene/material_path.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/simulation.hpp"
#include "lib/scene/study.hpp"
#include "mms/manufactured.hpp"
#include "reports/run/process.hpp"
#include "verification/plumb/house_commands.hpp"
#include "verification/plumb/program.hpp"
#include "verification/plumb/run/scene_options.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

/// Nobody waits longer to be told: CPU time [s].
constexpr double longest_s = 1;

/// One mistake and what a user is told about it.
struct BadInput {
  std::string what;
  std::string base;           ///< the file that the mistake is made in: "scene", "bar", "study" or "path"
  std::string line, instead;  ///< of the file; both empty: as it is
  std::vector<std::string> overrides;  ///< --set
  std::vector<std::string> arguments;  ///< of a call of plumb; empty: the file is read and built
  std::string message;
};

BadInput read_bad_input(const Section& section) {
  BadInput bad;
  bad.what = section.text("what");
  bad.base = section.choice_or("base", "scene", {"scene", "bar", "study", "path"});
  if (section.has("line")) {
    bad.line = section.text("line");
    bad.instead = section.has("without") ? "" : section.text("instead");
  }
  if (section.has("set")) bad.overrides.push_back(section.text("set"));
  if (section.has("call")) bad.arguments = CLI::detail::split_up(section.text("call"));
  bad.message = section.text_or("message", "?");
  section.reject_unknown();
  return bad;
}

std::string with(const BadInput& bad, const std::map<std::string, std::string>& files) {
  std::string text = files.at(bad.base);
  if (bad.line.empty()) return text;
  const auto place = text.find(bad.line);
  if (place == std::string::npos)
    throw InputError(bad.what + ": the " + bad.base + " has no line \"" + bad.line + "\"", "", "");
  return text.replace(place, bad.line.size(), bad.instead);
}

/// Whether the text is the expected one, in which "<any>" stands for whatever depends on the machine.
bool fits(const std::string& said, const std::string& expected) {
  const std::string any = "<any>";
  std::size_t at = 0, from = 0;
  for (auto next = expected.find(any); next != std::string::npos; next = expected.find(any, from)) {
    const std::size_t found = said.find(expected.substr(from, next - from), at);
    if (found == std::string::npos || (from == 0 && found != 0)) return false;
    at = found + next - from;
    from = next + any.size();
  }
  const std::string rest = expected.substr(from);
  return from == 0 ? said == expected : said.size() >= at + rest.size() && said.ends_with(rest);
}

/// What plumb says to the file: the message, or nothing if it is accepted.
std::string refusal_of_file(const BadInput& bad, const std::string& text) {
  try {
    if (bad.base == "study") {
      parse_study(text, "study.toml", bad.overrides, mms::solution_names());
      return "";
    }
    if (bad.base == "path") {
      follow(parse_material_path(text, "path.toml", bad.overrides));
      return "";
    }
    const Scene scene = parse_scene(text, bad.base + ".toml", bad.overrides);
    require_memory(scene);
    with_dimension(scene,
                   [&scene]<int d>() { return make_simulation<d>(scene).simulation.counts().particles > 0; });
  } catch (const InputError& error) {
    return std::string("plumb: ") + error.what();
  }
  return "";
}

/// What is said, and the CPU time until it is [s]: the clock's would count other programs.
struct Refusal {
  std::string said;
  double cpu_s;
};

Refusal timed_refusal_of_file(const BadInput& bad, const std::string& text) {
  const std::clock_t start = std::clock();
  std::string said = refusal_of_file(bad, text);
  return {std::move(said), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

/// What the program says to a command line, with its exit code if that is not 2.
Refusal refusal_of_call(const BadInput& bad, const std::map<std::string, std::string>& files) {
  namespace fs = std::filesystem;
  std::string name = (fs::temp_directory_path() / "plumbline_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw OutputError("cannot make " + name);
  const fs::path folder = name;
  for (const auto& [base, text] : files)
    replace_file(folder / (base + ".toml"), base == bad.base ? with(bad, files) : text);
  const auto ended =
      reports::run::run_program(required_program(), bad.arguments, folder, folder / "messages.txt");
  std::string said = read_text((folder / "messages.txt").string());
  fs::remove_all(folder);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return {ended.exit_code == 2 ? said : fmt::format("exit code {}: {}", ended.exit_code, said), ended.cpu_s};
}

int refusals(const Session& session, const std::string& table) {
  const TomlValue document = parse_document(read_text(table), table);
  const Section root(document, "");
  const std::map<std::string, std::string> files{{"scene", root.text("scene")},
                                                 {"bar", root.text_or("bar", "")},
                                                 {"study", root.text("study")},
                                                 {"path", root.text_or("path", "")}};
  Json rows = Json::array();
  int wrong = 0;
  double slowest = 0;
  for (const auto& section : root.sections("bad")) {
    const BadInput bad = read_bad_input(section);
    const auto [said, cpu_s] =
        bad.arguments.empty() ? timed_refusal_of_file(bad, with(bad, files)) : refusal_of_call(bad, files);
    const bool as_written = fits(said, bad.message), at_once = cpu_s < longest_s;
    wrong += as_written && at_once ? 0 : 1;
    slowest = std::max(slowest, cpu_s);
    rows.push_back({{"what", bad.what},
                    {"message", said.empty() ? "accepted" : said},
                    {"as_written", as_written},
                    {"cpu_s", cpu_s}});
    if (!at_once) session.text() << fmt::format("{}: {:.2f} s until it is refused\n", bad.what, cpu_s);
    if (!as_written)
      session.text() << fmt::format("{}\n  expected: {}\n  is said:  {}\n", bad.what, bad.message, said);
  }
  root.reject_unknown();
  session.text() << fmt::format(
      "{} bad inputs, {} with another message than written or after more than {} s; the "
      "slowest took {:.2f} s\n",
      rows.size(), wrong, longest_s, slowest);
  session.write_csv(rows);
  session.write_json({{"count", rows.size()}, {"wrong", wrong}, {"slowest_s", slowest}, {"rows", rows}});
  return wrong == 0 ? 0 : 1;
}

}  // namespace

/// `plumb-house refusals TABLE.toml`: every bad input of a table against the message that a user shall see.
void add_refusals(CLI::App& program, Session& session) {
  const auto table = std::make_shared<std::string>();
  CLI::App& command = add_command(program, session,
                                  {"refusals", "tries bad inputs and compares what is said with a table",
                                   "plumb-house refusals verification/bad_inputs.toml"},
                                  {.table = true}, [&session, table] { return refusals(session, *table); });
  command.add_option("TABLE", *table, "the table (.toml)")->required()->type_name("FILE");
}

}  // namespace plumb::app
