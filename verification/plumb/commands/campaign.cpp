#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "lib/convergence/status.hpp"
#include "lib/core/error.hpp"
#include "lib/output/file.hpp"
#include "lib/output/table.hpp"
#include "reports/picture.hpp"
#include "verification/plumb/commands.hpp"
#include "verification/plumb/fit_text.hpp"
#include "verification/plumb/foreign/campaign_run.hpp"
#include "verification/plumb/foreign/judge_particles.hpp"
#include "verification/plumb/optional_json.hpp"
#include "verification/plumb/run/interrupt.hpp"
#include "verification/plumb/session.hpp"

namespace plumb::app {
namespace {

using Json = nlohmann::ordered_json;

struct CampaignOptions {
  std::string file, out, jobs_as, work_plot;
  std::vector<std::string> overrides;
  int jobs = 1;
  bool judge = false;
};

Json json_of(const CampaignResult& result) {
  Json row{{"folder", result.run.folder}, {"d", result.run.spacing}, {"run", result.run.number}};
  row["dt"] = result.run.steps > 0 ? Json(result.run.step) : Json();
  row["steps"] = result.run.steps > 0 ? Json(result.run.steps) : Json();
  if (result.errors) {
    const Json errors = json_of(*result.errors);
    for (const auto& [key, value] : errors.items())
      if (key != "file") row[key] = value;
  }
  row["wall_s"] = optional_json(result.wall_s);
  row["cpu_s"] = optional_json(result.cpu_s);
  row["peak_rss"] = optional_json(result.peak_rss);
  row["recalled"] = result.recalled;
  row["failure"] = result.failure.empty() ? Json() : Json(result.failure);
  return row;
}

/// The columns that people look at.
Json shown(const std::vector<CampaignResult>& results) {
  Json rows = Json::array();
  for (const CampaignResult& result : results) {
    Json row{{"run", result.run.folder}};
    if (result.errors) {
      row["points"] = result.errors->points;
      for (const auto& [name, value] : result.errors->norms)
        if (name != "l2_inside" && name != "l2_boundary") row[name] = value;
    }
    if (result.cpu_s) row["cpu [s]"] = *result.cpu_s;
    if (result.wall_s) row["wall [s]"] = *result.wall_s;
    if (result.peak_rss) row["memory [MB]"] = *result.peak_rss / 1e6;
    rows.push_back(row);
  }
  return rows;
}

/// Error against CPU time: as the picture of `plumb mms --work-precision`.
void draw_work(const Session& session, const Campaign& campaign, const std::vector<CampaignResult>& results,
               const std::string& file) {
  reports::Picture picture;
  picture.title = campaign.name;
  picture.x = {"CPU time", "s", reports::Scale::log};
  picture.y = {"relative L2 error", "", reports::Scale::log};
  reports::Series series{campaign.name, {}, {}};
  for (const CampaignResult& result : results) {
    if (!result.errors || !result.cpu_s || !(*result.cpu_s > 0)) continue;
    const auto found = result.errors->norms.find("relative_l2");
    if (found == result.errors->norms.end()) continue;
    series.x.push_back(*result.cpu_s);
    series.y.push_back(found->second);
  }
  if (series.x.empty()) return session.warn("no run has both an error and a CPU time: nothing is drawn");
  picture.series.push_back(series);
  for (const auto& dropped : reports::save(picture, file))
    session.warn(fmt::format("{}: {} points not drawn, {}", dropped.series, dropped.points, dropped.why));
}

int judge_results(const Session& session, const Campaign& campaign, const CampaignOptions& options,
                  const std::vector<CampaignResult>& results) {
  std::vector<ForeignErrors> levels;
  Json rows = Json::array();
  bool failed = false;
  for (const CampaignResult& result : results) {
    if (result.errors) levels.push_back(*result.errors);
    failed = failed || !result.failure.empty();
    rows.push_back(json_of(result));
  }
  session.text() << in_words(campaign.solution) << fmt::format(", t = {:g} s\n", campaign.time)
                 << plain_text(table_of(shown(results))) << '\n';
  for (const CampaignResult& result : results)
    if (!result.failure.empty()) session.text() << result.run.folder << ": " << result.failure << '\n';
  std::vector<JudgedColumn> columns;
  if (!levels.empty()) columns = judged_levels(levels, campaign.norms, campaign.expect);
  tell_columns(session, columns);
  const std::string status = failed ? "fail" : status_of(columns);
  const std::vector<std::string> causes = causes_of(levels, columns);
  for (const std::string& cause : causes) session.text() << "  " << cause << '\n';
  session.text() << "status: " << status << '\n';
  session.write_csv(rows);
  session.write_json({{"campaign", campaign.name},
                      {"solution", campaign.solution.name},
                      {"time", campaign.time},
                      {"levels", rows},
                      {"fits", fits_json(columns)},
                      {"causes", causes},
                      {"status", status}});
  draw_columns(session, campaign.name, columns);
  if (!options.work_plot.empty()) draw_work(session, campaign, results, options.work_plot);
  return exit_code_of(status);
}

int campaign_action(const Session& session, const CampaignOptions& options) {
  const Campaign campaign = read_campaign(options.file, options.overrides);
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(options.file).stem().string() + "_campaign" : options.out;
  if (options.judge && !options.jobs_as.empty())
    throw InputError("--judge with --jobs-as", "jobs are written before they are run and judged after it",
                     "leave one out");
  require_folder(out, "--out");
  if (!options.work_plot.empty()) require_writable(options.work_plot, "--work-plot");
  if (!options.jobs_as.empty()) {
    const std::string name = write_jobs(campaign, out, options.jobs_as);
    const std::string start =
        options.jobs_as == "makefile"
            ? fmt::format("make -C {} -j 2", out.string())
            : fmt::format("(cd {} && xargs -d '\\n' -P 2 -n 1 sh -c < {})", out.string(), name);
    session.text() << fmt::format(
        "{} runs are ready in {}. Start them:  {}\n"
        "Then judge them:  plumb campaign {} --judge --out {}\n",
        runs_of(campaign).size(), out.string(), start, options.file, out.string());
    session.write_json(
        {{"campaign", campaign.name}, {"jobs", (out / name).string()}, {"runs", runs_of(campaign).size()}});
    return 0;
  }
  if (options.judge) return judge_results(session, campaign, options, collect_campaign(campaign, out));
  const InterruptGuard guard;
  Progress progress(campaign.name, session.progress());
  double ended = 0;
  const auto count = static_cast<double>(runs_of(campaign).size());
  const auto results = run_campaign(
      campaign, out, options.jobs, [] { return !interrupted(); },
      [&](const CampaignResult& result) {
        ended += 1;
        progress.update(ended / count, result.run.folder);
      });
  progress.finish();
  return judge_results(session, campaign, options, results);
}

}  // namespace

/// `plumb campaign`: a refinement study of another program.
void add_campaign(CLI::App& program, Session& session) {
  const auto options = std::make_shared<CampaignOptions>();
  CLI::App& command = add_command(
      program, session,
      {"campaign", "refinement study of another program: clouds, loads, runs, errors, orders, verdicts",
       "plumb campaign verification/campaigns/finite_elements.toml --jobs 2"},
      {.table = true, .plot = true}, [&session, options] { return campaign_action(session, *options); });
  command.add_option("campaign", options->file, "the campaign file (.toml)")
      ->type_name("CAMPAIGN.toml")
      ->required();
  command.add_option("--out", options->out, "folder of the runs (default: NAME_campaign beside you)")
      ->type_name("DIR");
  command.add_option("--jobs", options->jobs, "runs at a time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--jobs-as", options->jobs_as,
                  "writes all files and the jobs, and runs nothing: makefile, or list, a line of shell for "
                  "each run (xargs -P, GNU "
                  "parallel, a Slurm array)")
      ->check(CLI::IsMember({"makefile", "list"}));
  command.add_flag("--judge", options->judge, "runs nothing: judges what the runs have left in --out");
  command.add_option("--work-plot", options->work_plot, "picture of the error against CPU time")
      ->type_name("FILE.svg|.png");
  command.add_option("--set", options->overrides, "change one value of the file; may be repeated")
      ->type_name("section.key=value");
  point_to_verdicts(command);
}

}  // namespace plumb::app
