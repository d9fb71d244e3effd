#include "verification/plumb/foreign/campaign_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "lib/core/error.hpp"
#include "lib/input/document.hpp"
#include "lib/output/file.hpp"
#include "lib/output/sitting.hpp"
#include "reports/run/process.hpp"
#include "reports/run/side_by_side.hpp"

namespace plumb::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// FNV-1a of all that decides what a run does.
std::string content_of(const Campaign& c, const CampaignRun& run) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](const std::string& text) {
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    hash = (hash ^ 256) * 1099511628211ULL;  // where one text ends
  };
  add(filled(c.command, c, run, "command"));
  add(filled(c.prepare, c, run, "prepare"));
  add(c.result);
  for (const auto& [name, text] : files_of(c, run)) add(name), add(text);
  return fmt::format("{:016x}", hash);
}

/// The last line that the program said.
std::string last_words(const fs::path& messages) {
  std::ifstream file(messages);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last.substr(0, 200);
}

/// What its folder says of a run that is finished, if it is of the same content.
std::optional<Json> finished(const fs::path& folder, const std::string& content) {
  std::ifstream file(folder / "done.json");
  const Json said = Json::parse(file, nullptr, false);
  if (!said.is_object() || said.value("content", "") != content) return std::nullopt;
  return said;
}

void take_cost(const Json& said, CampaignResult& result) {
  const auto number = [&](const char* key) {
    const auto at = said.find(key);
    return at != said.end() && at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
  };
  result.wall_s = number("wall_s");
  result.cpu_s = number("cpu_s");
  result.peak_rss = number("peak_rss");
}

/// The result's errors, or why there are none.
void compare(const Campaign& c, const fs::path& folder, CampaignResult& result) {
  if (!result.failure.empty()) return;
  if (!fs::exists(folder / c.result)) {
    result.failure = fmt::format("it left no {}", c.result);
    return;
  }
  try {
    result.errors = errors_of((folder / c.result).string(), c.solution, c.time, c.points);
    result.errors->spacing = result.run.spacing;
  } catch (const InputError& error) {
    result.failure = error.what();
  }
}

CampaignResult made(const Campaign& c, const CampaignRun& run, const fs::path& out) {
  CampaignResult result;
  result.run = run;
  const fs::path folder = out / run.folder;
  const std::string content = content_of(c, run);
  if (const auto said = finished(folder, content)) {
    result.recalled = true;
    take_cost(*said, result);
    compare(c, folder, result);
    return result;
  }
  prepare_run(c, run, out);
  std::error_code none;
  fs::remove(folder / c.result, none);
  const auto shell = [&](const std::string& command, const char* messages) {
    return reports::run::run_program("/bin/sh", {"-c", filled(command, c, run, "command")}, folder,
                                     folder / messages);
  };
  const auto say = [&](const reports::run::Ended& ended, const char* what, const char* messages) {
    if (ended.exit_code == 0) return;
    const std::string words = last_words(folder / messages);
    result.failure =
        fmt::format("{} ended with {}{}", what, ended.exit_code, words.empty() ? "" : ": " + words);
  };
  if (!c.prepare.empty()) say(shell(c.prepare, "prepare.txt"), "prepare", "prepare.txt");
  if (result.failure.empty()) {
    const reports::run::Ended ended = shell(c.command, "messages.txt");
    result.wall_s = ended.wall_s;
    result.cpu_s = ended.cpu_s;
    result.peak_rss = ended.peak_rss;
    say(ended, "the command", "messages.txt");
  }
  compare(c, folder, result);
  if (result.failure.empty())  // what failed is tried again
    replace_file(folder / "done.json", Json{{"content", content},
                                            {"wall_s", *result.wall_s},
                                            {"cpu_s", *result.cpu_s},
                                            {"peak_rss", *result.peak_rss}}
                                           .dump(1));
  return result;
}

/// A word of a shell as it stands.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

void prepare_run(const Campaign& c, const CampaignRun& run, const fs::path& out) {
  make_folder(out / run.folder, "--out");
  for (const auto& [name, text] : files_of(c, run)) replace_file(out / run.folder / name, text, Flush::later);
}

std::vector<CampaignResult> run_campaign(const Campaign& c, const fs::path& out, int jobs,
                                         const std::function<bool()>& go_on,
                                         const std::function<void(const CampaignResult&)>& told) {
  const std::vector<CampaignRun> runs = runs_of(c);
  std::vector<CampaignResult> results(runs.size());
  std::mutex one_at_a_time;
  std::size_t ended = 0;
  reports::run::side_by_side(
      runs.size(), jobs,
      [&](std::size_t k) {
        const std::size_t at = runs.size() - 1 - k;
        results[at] = made(c, runs[at], out);
        const std::scoped_lock lock(one_at_a_time);
        ++ended;
        told(results[at]);
      },
      go_on);
  if (ended < runs.size() || !go_on())
    throw SittingEnded(fmt::format(
        "interrupted with {} of {} runs ended; those that are finished are kept in {}, and the same call "
        "goes on from there",
        ended, runs.size(), out.string()));
  return results;
}

std::vector<CampaignResult> collect_campaign(const Campaign& c, const fs::path& out) {
  std::vector<CampaignResult> results;
  for (const CampaignRun& run : runs_of(c)) {
    CampaignResult result;
    result.run = run;
    if (const auto said = finished(out / run.folder, content_of(c, run))) take_cost(*said, result);
    compare(c, out / run.folder, result);
    results.push_back(std::move(result));
  }
  return results;
}

std::string write_jobs(const Campaign& c, const fs::path& out, const std::string& kind) {
  make_folder(out, "--out");
  const bool make = kind == "makefile";
  std::string text =
      make ? fmt::format("# {}: make -j N in this folder, then plumb campaign {} --judge --out .\nall:",
                         c.name, c.file)
           : "";
  const std::vector<CampaignRun> runs = runs_of(c);
  for (const CampaignRun& run : runs) {
    prepare_run(c, run, out);
    if (make) text += fmt::format(" {}/{}", run.folder, c.result);
  }
  if (make) text += '\n';
  for (const CampaignRun& run : runs) {
    std::string line = fmt::format("cd {} && ", quoted(run.folder));
    if (!c.prepare.empty())
      line += fmt::format("( {} ) > prepare.txt 2>&1 && ", filled(c.prepare, c, run, "prepare"));
    line += fmt::format("( {} ) > messages.txt 2>&1", filled(c.command, c, run, "command"));
    if (!make) {
      text += line + '\n';
      continue;
    }
    std::string doubled;
    for (const char sign : line) doubled += sign == '$' ? std::string("$$") : std::string(1, sign);
    text += fmt::format("\n{}/{}:\n\t{}\n", run.folder, c.result, doubled);
  }
  const std::string name = make ? "Makefile" : "jobs.txt";
  replace_file(out / name, text);
  return name;
}

}  // namespace plumb::app
