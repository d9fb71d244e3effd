#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "lib/output/terminal.hpp"
#include "places.hpp"
#include "reports/run/store.hpp"
#include "verification/plumb/claims/measure.hpp"
#include "verification/plumb/house_commands.hpp"
#include "verification/plumb/program.hpp"
#include "verification/plumb/run/kept_folder.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct ClaimsOptions {
  fs::path ledger = PLUMBLINE_SOURCE_DIR "/verification/claims";
  fs::path root = PLUMBLINE_SOURCE_DIR;
  fs::path store;
  bool check = false, long_too = false;
};

using Remeasured = std::vector<claims::Remeasured>;

/// "2/3 inside: 0.667; first particle: 0.122" for one claim; what was measured again stands beside it, with
/// more digits where it differs.
std::string found_text(const claims::Claim& claim, const Remeasured& again = {}) {
  std::string text;
  for (const auto& r : claim.readings) {
    text += fmt::format("{}{}: {:.4g}", text.empty() ? "" : "; ", r.name, r.value);
    const auto found =
        std::find_if(again.begin(), again.end(), [&](const auto& m) { return m.reading == &r; });
    if (found != again.end())
      text += found->same
                  ? fmt::format(" (measured {:.4g})", found->value)
                  : fmt::format(" (CHANGED: recorded {:.8g}, measured {:.8g})", r.value, found->value);
    if (!claim.unit.empty()) text += " " + claim.unit;
  }
  return text;
}

std::string evidence_text(const claims::Claim& claim) {
  const claims::Reading& chosen = claim.readings.front();
  std::string text = chosen.test.empty() ? "plumb " + chosen.command : "test \"" + chosen.test + "\"";
  if (!claim.second_evidence.empty()) text += "; besides: " + claim.second_evidence;
  return text;
}

Json json_of(const claims::Claim& claim) {
  Json readings = Json::array();
  for (const auto& r : claim.readings)
    readings.push_back({{"name", r.name},
                        {"value", r.value},
                        {"holds", claim.holds_for(r.value)},
                        {"command", r.command},
                        {"test", r.test},
                        {"long", r.long_run}});
  return {{"id", claim.id},
          {"paper", claim.paper},
          {"where", claim.where},
          {"claim", claim.claim},
          {"published", claim.published},
          {"ours", found_text(claim)},
          {"status", name_of(claim.status)},
          {"finding", claim.finding},
          {"evidence", evidence_text(claim)},
          {"picture", claim.picture},
          {"chosen", claim.readings.front().name},
          {"unit", claim.unit},
          {"readings", readings}};
}

/// Runs a command of the ledger once and keeps its JSON; a run writes into the store's folder.
claims::RunCommand runner(const ClaimsOptions& options, int threads) {
  if (options.store.empty())
    throw InputError("there is no folder for the results", "neither XDG_CACHE_HOME nor HOME names one",
                     "give one with --store");
  const auto store = std::make_shared<reports::run::Store>(options.store, required_program(),
                                                           fs::canonical(options.root), threads);
  return [store](const std::string& command) {
    reports::Job job{"claim", {}, {}};
    boost::split(job.arguments, command, boost::is_any_of(" "), boost::token_compress_on);
    for (const auto& word : job.arguments)
      if (boost::ends_with(word, ".toml")) job.inputs.push_back(word);
    if (job.arguments.front() == "run")
      job.arguments.insert(job.arguments.end(), {"--set", "output.vtk=false", "--out", "{out}"});
    const reports::JobResult result = store->get(job);
    if (!result.failure.empty()) throw InputError("plumb " + command, result.failure, "correct the ledger");
    Json whole = Json::parse(reports::run::content_of(result.folder / "result.json"));
    const fs::path series = result.folder / "series.csv";
    if (fs::exists(series)) whole["series"] = claims::columns_of(reports::run::content_of(series));
    return whole;
  };
}

claims::CheckResult check_claims(const Session& session, const ClaimsOptions& options,
                                 const std::vector<claims::Claim>& ledger) {
  Progress progress("claims", session.progress());
  auto checked = claims::check(ledger, options.long_too, runner(options, session.threads),
                               [&](double share, const std::string& id) { progress.update(share, id); });
  progress.finish();
  return checked;
}

/// Puts the numbers that were measured again into the result and says what has changed.
int tell_changes(const Session& session, const claims::CheckResult& checked, Json& result) {
  Json measured = Json::array();
  for (const auto& r : checked.readings)
    measured.push_back({{"id", r.claim->id},
                        {"reading", r.reading->name},
                        {"recorded", r.reading->value},
                        {"measured", r.value},
                        {"same", r.same}});
  result["measured"] = measured;
  result["changes"] = checked.changes;
  for (const auto& change : checked.changes) std::cerr << "plumb-house: " << change << '\n';
  session.text() << fmt::format("{} numbers measured again, {} changes\n", checked.readings.size(),
                                checked.changes.size());
  result["status"] = checked.changes.empty() ? "pass" : "fail";
  return exit_code_of(result["status"].get<std::string>());
}

int run_claims(const Session& session, const ClaimsOptions& options) {
  const auto ledger = claims::read_ledger(options.ledger);
  const auto checked = options.check ? check_claims(session, options, ledger) : claims::CheckResult{};
  const auto columns = static_cast<std::size_t>(terminal_columns(1));
  Json rows = Json::array(), count = Json::object();
  for (const auto& claim : ledger) {
    rows.push_back(json_of(claim));
    const std::string status(name_of(claim.status));
    count[status] = count.value(status, 0) + 1;
    const std::string said =
        fmt::format("{} {}: {} [{}]", claim.paper, claim.where, claim.claim, claim.published);
    session.text() << fmt::format("{:12} {}\n             {}\n", status, wrapped(said, columns, 13, 13),
                                  wrapped(found_text(claim, checked.readings), columns, 13, 13));
  }
  for (const auto& [status, number] : count.items())
    session.text() << fmt::format("{} {}\n", number.get<int>(), status);
  Json result{{"claims", rows}, {"count", count}};
  const int code = options.check ? tell_changes(session, checked, result) : 0;
  Json flat = rows;
  for (auto& row : flat) row.erase("readings");
  session.write_csv(flat);
  session.write_json(result);
  return code;
}

}  // namespace

/// `plumb-house claims`: the ledger of the papers' claims.
void add_claims(CLI::App& program, Session& session) {
  const auto options = std::make_shared<ClaimsOptions>();
  options->store = kept_folder("claims");
  CLI::App& command =
      add_command(program, session,
                  {"claims", "what the papers say, what was found, and whether it is reproduced",
                   "plumb-house claims --json -"},
                  {.table = true}, [&session, options] { return run_claims(session, *options); });
  command.add_flag("--check", options->check, "measure the numbers again; exit code 1 if one has changed");
  command.add_flag("--long", options->long_too, "with --check: those that take minutes too");
  command.add_option("--ledger", options->ledger, "folder of the ledger")->type_name("DIR");
  command.add_option("--root", options->root, "folder that the commands are run in")->type_name("DIR");
  command
      .add_option(
          "--store", options->store,
          "with --check: keeps results, so that each is computed once (" + kept_folder_text("claims") + ")")
      ->type_name("DIR");
}

}  // namespace plumb::app
