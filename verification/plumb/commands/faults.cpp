#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "places.hpp"
#include "plumb/commands.hpp"
#include "plumb/session.hpp"
#include "plumbline/core/error.hpp"
#include "plumbline/output/terminal.hpp"

namespace plumb {
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

int show(const Session& session, const std::string& file) {
  const Json faults = read_score(file);
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
  session.write_json({{"faults", faults},
                      {"caught", caught},
                      {"equivalent", equivalent},
                      {"survived", survived},
                      {"status", survived == 0 ? "pass" : "fail"}});
  return survived == 0 ? 0 : 1;
}

}  // namespace

/// `plumb faults`: the stored score of the planted faults.
void add_faults(CLI::App& program, Session& session) {
  const auto file = std::make_shared<std::string>(PLUMBLINE_SOURCE_DIR "/verification/faults/score.json");
  CLI::App& command = add_command(
      program, session,
      {"faults", "planted faults and the tests that caught them, as stored by verification/faults/run",
       "plumb faults --json -"},
      {.table = true}, [&session, file] { return show(session, *file); });
  command.add_option("score", *file, "score file")->capture_default_str();
}

}  // namespace plumb
