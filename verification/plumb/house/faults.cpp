#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/core/error.hpp"
#include "lib/output/terminal.hpp"
#include "places.hpp"
#include "verification/plumb/house_commands.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

Json read_score(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError("cannot read " + file, "", "Run verification/faults/run to make it.");
  const Json score = Json::parse(in, nullptr, false);
  if (!score.is_object() || !score.contains("faults"))
    throw InputError(file + " is no score of planted faults", "", "Run verification/faults/run to make it.");
  return score.at("faults");
}

/// What verification/faults/sample stored, without its list of mutants; null if there is no such file.
Json read_sample(const std::string& file) {
  std::ifstream in(file);
  if (!in) return nullptr;
  Json sample = Json::parse(in, nullptr, false);
  if (!sample.is_object() || !sample.contains("all"))
    throw InputError(file + " is no score of a sample", "", "Run verification/faults/sample to make it.");
  sample.erase("mutants");
  return sample;
}

/// "lib/schemes/tlsph/time: 9 of 12 caught, 75.0 % [46.8, 91.1]".
std::string sample_line(const Json& row, const std::string& name) {
  const int killed = row.at("killed").get<int>(), judged = killed + row.at("alive").get<int>();
  std::string line = fmt::format("{:<22} {:>3} of {:>3} caught", name, killed, judged);
  if (judged > 0)
    line += fmt::format(", {:.1f} % [{:.1f}, {:.1f}]", 100 * row.at("share").get<double>(),
                        100 * row.at("interval").at(0).get<double>(),
                        100 * row.at("interval").at(1).get<double>());
  return line + '\n';
}

void tell_sample(std::ostream& text, const Json& sample) {
  const Json& all = sample.at("all");
  const std::string drawn = fmt::format(
      "A random sample of small slips in the sources, at commit {} (seed {}; {} drawn, {} do not compile, {} "
      "equivalent); shares with 95 % intervals:",
      sample.at("commit").get<std::string>(), sample.at("seed").get<long>(), all.at("sampled").get<int>(),
      all.at("not_compiled").get<int>(), all.at("equivalent").get<int>());
  text << '\n' << wrapped(drawn, static_cast<std::size_t>(terminal_columns(1)), 0, 0) << '\n';
  text << sample_line(all, "in all");
  text << fmt::format("before tests were written for it: {:.1f} % [{:.1f}, {:.1f}]\n",
                      100 * all.at("share_at_first").get<double>(),
                      100 * all.at("interval_at_first").at(0).get<double>(),
                      100 * all.at("interval_at_first").at(1).get<double>());
  for (const auto& row : sample.at("folders")) text << sample_line(row, row.at("folder").get<std::string>());
}

int show(const Session& session, const std::string& file, const std::string& sample_file) {
  const Json faults = read_score(file), sample = read_sample(sample_file);
  int caught = 0, equivalent = 0;
  Json rows = Json::array();
  for (const auto& fault : faults) {
    const bool seen = fault.at("caught_by").is_string();
    caught += seen;
    equivalent += !seen && fault.contains("equivalent");
    rows.push_back({{"fault", fault.at("name")},
                    {"file", fault.at("file")},
                    {"caught_by", seen ? fault.at("caught_by")
                                       : Json(fault.contains("equivalent") ? "equivalent" : "survived")}});
  }
  const int survived = static_cast<int>(faults.size()) - caught - equivalent;
  const auto columns = static_cast<std::size_t>(terminal_columns(1));
  for (const auto& row : rows)
    session.text() << wrapped(row["fault"].get<std::string>(), columns, 0, 4) << "\n    "
                   << wrapped(row["file"].get<std::string>() + ": " + row["caught_by"].get<std::string>(),
                              columns, 4, 4)
                   << '\n';
  session.write_csv(rows);
  session.text() << fmt::format("{} of {} caught, {} equivalent, {} survived\n", caught, faults.size(),
                                equivalent, survived);
  if (!sample.is_null() && sample.at("all").at("sampled") > 0) tell_sample(session.text(), sample);
  session.write_json({{"faults", faults},
                      {"caught", caught},
                      {"equivalent", equivalent},
                      {"survived", survived},
                      {"sampled", sample},
                      {"status", survived == 0 ? "pass" : "fail"}});
  return survived == 0 ? 0 : 1;
}

}  // namespace

/// `plumb-house faults`: the stored score of the planted faults.
void add_faults(CLI::App& program, Session& session) {
  const auto file = std::make_shared<std::string>(PLUMBLINE_SOURCE_DIR "/verification/faults/score.json");
  const auto sample = std::make_shared<std::string>(PLUMBLINE_SOURCE_DIR "/verification/faults/sampled.json");
  CLI::App& command = add_command(
      program, session,
      {"faults", "planted faults and the tests that caught them, as stored by verification/faults/run",
       "plumb-house faults --json -"},
      {.table = true}, [&session, file, sample] { return show(session, *file, *sample); });
  command.add_option("score", *file, "score file")->capture_default_str();
  command.add_option("--sampled", *sample, "score of a random sample, by verification/faults/sample")
      ->capture_default_str();
}

}  // namespace plumb::app
