#include "reports/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "verification/plumb/code.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/data_folder.hpp"
#include "verification/plumb/provenance.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

int report(const Session& session, reports::ReportOptions options) {
  options.root = data_folder(options.root);
  options.program = std::filesystem::canonical("/proc/self/exe");
  options.code = PLUMB_CODE;
  options.threads = session.threads;
  const Json from = provenance();
  const auto entry = [&from](const char* key) { return from.value(key, Json()); };
  options.facts = {{"commit", entry("commit").get<std::string>()},
                   {"version", version()},
                   {"compiler", entry("compiler").get<std::string>() + ", " +
                                    entry("build").get<std::string>() + " build"},
                   {"made", entry("date").get<std::string>()}};
  Progress progress("report", session.progress());
  options.progress = [&progress](double fraction, const std::string& job) { progress.update(fraction, job); };
  const InterruptGuard guard;
  options.go_on = [] { return !interrupted(); };
  const auto summary = reports::make_report(options);
  progress.finish();
  Json verdicts = Json::object();
  std::vector<Judged> judged(summary.problems.size(), Judged{"not-computed"});
  for (const auto& [name, count] : summary.verdicts) {
    verdicts[name] = count;
    judged.insert(judged.end(), count, Judged{name});
    session.text() << fmt::format("{:>5} {}\n", count, name);
  }
  const std::string_view status = status_of(judged);
  for (const auto& problem : summary.problems) std::cerr << "plumb: no answer in section " << problem << '\n';
  session.text() << fmt::format("status: {}\n{} studies, {} of them stored ones\nreport: {}\n", status,
                                summary.jobs, summary.reused,
                                std::filesystem::absolute(summary.page).lexically_normal().string());
  Json rows = Json::array(), kinds = Json::object();
  for (const auto& kind : reports::check_kinds()) kinds[name_of(kind)] = {{"pass", 0}, {"all", 0}};
  for (const auto& [section, check] : summary.checks) {
    rows.push_back({{"section", section},
                    {"kind", name_of(check.kind)},
                    {"what", check.what},
                    {"expected", check.expected},
                    {"measured", check.measured},
                    {"verdict", check.verdict}});
    Json& count = kinds[name_of(check.kind)];
    count["all"] = count["all"].get<int>() + 1;
    count["pass"] = count["pass"].get<int>() + (check.verdict == "pass" ? 1 : 0);
  }
  for (const auto& [kind, count] : kinds.items())
    session.text() << fmt::format("{:>5} of {} {} checks pass\n", count["pass"].get<int>(),
                                  count["all"].get<int>(), kind);
  session.write_json({{"page", summary.page.string()},
                      {"verdicts", verdicts},
                      {"status", status},
                      {"kinds", kinds},
                      {"rows", rows},
                      {"problems", summary.problems},
                      {"studies", summary.jobs},
                      {"reused", summary.reused},
                      {"cpu_s", summary.cpu_s}});
  // A page that says where the evidence is unclear has done its work: only what failed or is missing is a failure.
  return status == "inconclusive" ? 0 : exit_code_of(status);
}

}  // namespace

/// `plumb report`: the verification report.
void add_report(CLI::App& program, Session& session) {
  const auto options = std::make_shared<reports::ReportOptions>();
  options->root.clear();
  CLI::App& command =
      add_command(program, session,
                  {"report", "the verification report: one HTML page, with the data behind it",
                   "plumb report --only kernels,gradients --out out/report"},
                  {}, [&session, options] { return report(session, *options); });
  command.add_option("--out", options->out, "folder of the report")->type_name("DIR")->capture_default_str();
  command.add_flag_callback(
      "--full", [options] { options->extent = std::max(options->extent, reports::Extent::full); },
      "all sections and levels (a quarter of an hour), not each chapter's core; so are sections named by --only");
  command.add_flag_callback(
      "--long", [options] { options->extent = reports::Extent::long_run; },
      "the studies in the size of the papers too (hours)");
  command.add_option("--only", options->only, "sections to make, by name")
      ->type_name("SECTION")
      ->delimiter(',');
  command.add_option("--root", options->root, "folder that holds verification/scenes")->type_name("DIR");
}

}  // namespace plumb::app
