#include "reports/run/store.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/json.hpp"
#include "lib/output/result_store.hpp"
#include "reports/run/process.hpp"

namespace plumb::reports::run {
namespace {

namespace fs = std::filesystem;

/// The last lines of what a program said, on one line.
std::string last_words(const fs::path& messages) {
  std::ifstream in(messages);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) last = line;
  return last.empty() ? "it said nothing" : last;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

std::string shell_word(const std::string& word) {
  if (!word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,:/+") ==
          std::string::npos)
    return word;
  return "'" + word + "'";
}

/// A program that was asked to end says so in its result: that is not all of it.
bool is_whole(const fs::path& result) {
  const auto json = nlohmann::json::parse(content_of(result), nullptr, false);
  return !json.is_object() || json.value("status", nlohmann::json()) != "interrupted";
}

bool has_result(const fs::path& folder) {
  return fs::exists(folder / "result.json") && fs::exists(folder / "cost.json");
}

}  // namespace

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in)
    throw InputError(fmt::format("the file \"{}\" cannot be read", file.string()), "",
                     "Run from the root folder.");
  return text.str();
}

Store::Store(fs::path folder, fs::path program, fs::path root, int threads, const std::string& code)
    : folder_(std::move(folder)),
      program_(std::move(program)),
      root_(std::move(root)),
      threads_(threads),
      code_(name_of_content(code.empty() ? content_of(program_) : code)) {}

std::string Store::key(const Job& job) const {
  std::string all = code_ + fmt::format("\nthreads {}\n{}\n", threads_, machine());
  for (const auto& argument : job.arguments) all += argument + "\n";
  for (const auto& input : job.inputs) all += input + " " + name_of_content(content_of(root_ / input)) + "\n";
  return name_of_content(all);
}

JobResult Store::get(const Job& job) const {
  JobResult result;
  result.command = "plumb";
  for (const auto& argument : job.arguments)
    result.command += " " + shell_word(replaced(argument, "{out}", "out/" + job.id));
  try {
    result.folder = folder_ / key(job);
  } catch (const InputError& error) {
    result.failure = error.what();
    return result;
  }
  if (!has_result(result.folder)) return compute(job, std::move(result));
  const auto cost = nlohmann::json::parse(content_of(result.folder / "cost.json"));
  result.wall_s = cost.at("wall_s");
  result.cpu_s = cost.at("cpu_s");
  result.exit_code = cost.at("exit_code");
  if (cost.contains("peak_rss")) result.peak_rss = cost.at("peak_rss").get<double>();
  result.reused = true;
  return result;
}

bool Store::has(const Job& job) const {
  try {
    return has_result(folder_ / key(job));
  } catch (const InputError&) {  // an input that cannot be read
    return false;
  }
}

JobResult Store::compute(const Job& job, JobResult result) const {
  // of its own, because another job may make the same call at the same time
  const fs::path work = result.folder.string() + "." + job.id + ".part";
  fs::remove_all(work);
  fs::create_directories(work);
  std::vector<std::string> arguments;
  for (const auto& argument : job.arguments) arguments.push_back(replaced(argument, "{out}", work.string()));
  arguments.insert(arguments.end(), {"--json", (work / "result.json").string()});
  if (threads_ > 0) arguments.insert(arguments.end(), {"--threads", std::to_string(threads_)});
  const Ended ended = run_program(program_, arguments, root_, work / "messages.txt");
  result.exit_code = ended.exit_code;
  result.wall_s = ended.wall_s;
  result.cpu_s = ended.cpu_s;
  result.peak_rss = ended.peak_rss;
  const fs::path made = work / "result.json";
  if (ended.exit_code > 1 || !fs::exists(made) || !is_whole(made)) {
    result.failure = fmt::format("exit code {}: {}", ended.exit_code, last_words(work / "messages.txt"));
    fs::remove_all(work);
    return result;
  }
  replace_file(work / "cost.json", json_text({{"command", result.command},
                                              {"exit_code", ended.exit_code},
                                              {"wall_s", ended.wall_s},
                                              {"cpu_s", ended.cpu_s},
                                              {"peak_rss", ended.peak_rss}}));
  if (has_result(result.folder)) {  // that of the other one, whole and perhaps being read
    fs::remove_all(work);
    return result;
  }
  fs::remove_all(result.folder);
  fs::rename(work, result.folder);
  return result;
}

}  // namespace plumb::reports::run
