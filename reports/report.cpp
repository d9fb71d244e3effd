#include "reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "lib/core/error.hpp"
#include "lib/core/sentences.hpp"
#include "lib/output/file.hpp"
#include "lib/output/progress.hpp"
#include "lib/output/sitting.hpp"
#include "lib/output/table.hpp"
#include "reports/page/page.hpp"
#include "reports/run/expected_times.hpp"
#include "reports/run/process.hpp"
#include "reports/run/side_by_side.hpp"
#include "reports/run/store.hpp"
#include "reports/sections.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(fmt::format("the folder \"{}\" cannot be made", folder.string()), error.message(),
                     "Choose another one with --out.");
}

/// Sections that are asked for by name are shown whole.
std::vector<SectionPlan> chosen_plans(const ReportOptions& options) {
  auto plans = section_plans(options.only.empty() ? options.extent : std::max(options.extent, Extent::full));
  std::vector<std::string> ids;
  ids.reserve(plans.size());
  for (const auto& plan : plans) ids.push_back(plan.id);
  for (const auto& id : options.only)
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) throw unknown_name("section", id, ids);
  std::erase_if(plans, [&](const SectionPlan& plan) {
    return options.only.empty()
               ? plan.least > options.extent
               : std::find(options.only.begin(), options.only.end(), plan.id) == options.only.end();
  });
  return plans;
}

/// Titles of the sections that a larger report shows.
std::vector<std::string> titles_left_out(Extent extent) {
  std::vector<std::string> titles;
  for (const auto& plan : section_plans(extent))
    if (plan.least > extent) titles.push_back(plan.title);
  return titles;
}

/// What the sections ask for, in their order, as far as it may run beside others or not.
std::vector<const Job*> jobs_of(const std::vector<SectionPlan>& plans, bool alone) {
  std::vector<const Job*> jobs;
  for (const auto& plan : plans)
    for (const auto& job : plan.jobs)
      if (job.alone == alone) jobs.push_back(&job);
  return jobs;
}

/// Runs the studies: those that measure speed one by one on all cores, the others side by side, each on one.
class JobRunner {
 public:
  JobRunner(const ReportOptions& options, std::size_t total, ReportSummary& summary)
      : options_(options),
        total_(total),
        summary_(summary),
        times_(fs::absolute(options.out) / "store" / "times.json") {}

  void run(const std::vector<const Job*>& jobs, int side_by_side, int threads_of_each) {
    const run::Store store = store_for(threads_of_each);
    run::side_by_side(
        jobs.size(), side_by_side, [&](std::size_t n) { take(*jobs[n], store); }, options_.go_on);
    if (options_.go_on && !options_.go_on())
      throw SittingEnded(
          fmt::format("interrupted: {} of {} studies are finished "
                      "and stored; the same call goes on from there",
                      finished_, total_));
  }
  /// Counts what is to be done, so that the share done is one of time and not of studies.
  void plan(const std::vector<const Job*>& jobs, int threads_of_each) {
    const run::Store store = store_for(threads_of_each);
    std::vector<std::string> all, stored;
    for (const Job* job : jobs) {
      all.push_back(job->id);
      if (store.has(*job)) stored.push_back(job->id);
    }
    times_.plan(all, stored);
  }
  Results results() && { return std::move(results_); }

 private:
  run::Store store_for(int threads_of_each) const {
    return {fs::absolute(options_.out) / "store", options_.program, options_.root, threads_of_each,
            options_.code};
  }
  void take(const Job& job, const run::Store& store) {
    {
      const std::lock_guard lock(mutex_);
      tell(job);
    }
    JobResult result = store.get(job);
    const std::lock_guard lock(mutex_);
    summary_.reused += result.reused ? 1 : 0;
    summary_.cpu_s += result.cpu_s;
    ++summary_.jobs;
    if (result.failure.empty()) {
      ++finished_;
      replace_file(options_.out / "data" / (job.id + ".json"),
                   run::content_of(result.folder / "result.json"));
    }
    times_.finished(job.id, result.failure.empty() ? std::optional(result.cpu_s) : std::nullopt);
    times_.save();
    results_.add(job.id, std::move(result));
    tell(job);
  }
  void tell(const Job& job) const {
    if (options_.progress) options_.progress(times_.fraction(), job.id);
  }

  const ReportOptions& options_;
  std::size_t total_, finished_ = 0;
  std::mutex mutex_;  ///< guards what follows, and finished_
  ReportSummary& summary_;
  run::ExpectedTimes times_;
  Results results_;
};

Results run_jobs(const std::vector<SectionPlan>& plans, const ReportOptions& options,
                 ReportSummary& summary) {
  const auto together = jobs_of(plans, false), alone = jobs_of(plans, true);
  const int cores =
      options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  JobRunner runner(options, together.size() + alone.size(), summary);
  runner.plan(together, 1);
  runner.plan(alone, cores);
  runner.run(together, cores, 1);
  runner.run(alone, 1, cores);
  return std::move(runner).results();
}

/// The section, or what is to be said in its place.
PageSection written(const SectionPlan& plan, const Results& results, ReportSummary& summary) {
  PageSection out{plan.id, plan.title, {}, {}, chapter_of(plan.place)};
  for (const auto& job : plan.jobs) out.jobs.emplace_back(job.id, results.job(job.id));
  const auto give_up = [&](const std::exception& why) {
    out.section.answer = sentences(fmt::format("No answer: {}", why.what()), "", "");
    out.section.checks = {{plan.title, "a result", why.what(), "not-computed"}};
    summary.problems.push_back(fmt::format("{}: {}", plan.id, why.what()));
  };
  try {
    out.section = plan.write(results);
  } catch (const MissingResult& missing) {
    give_up(missing);
  } catch (const nlohmann::json::exception& unexpected) {  // a result of another form than the section knows
    give_up(unexpected);
  }
  return out;
}

Table csv_of(const DataTable& table) {
  Table csv;
  for (const auto& column : table.columns)
    csv.columns.push_back(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]");
  for (const auto& row : table.rows) {
    auto& cells = csv.rows.emplace_back();
    for (const auto& entry : row) {
      if (const auto* value = std::get_if<double>(&entry))
        cells.emplace_back(*value);
      else if (const auto* text = std::get_if<std::string>(&entry))
        cells.emplace_back(*text);
      else
        cells.emplace_back(std::string());
    }
    cells.resize(csv.columns.size(), std::string());
  }
  return csv;
}

/// Writes the data of every figure and table, and the figures, which are kept for the page.
void write_data(PageSection& section, const fs::path& out) {
  for (const auto& figure : section.section.figures) {
    std::string data;
    for (const auto& frame : figure.frames) data += "# " + frame.label + "\n" + data_csv(frame.picture);
    replace_file(out / "data" / (figure.id + ".csv"), data.empty() ? data_csv(figure.picture) : data);
    section.drawn[figure.id] = svg(figure.picture, figure.id);
    replace_file(out / "figures" / (figure.id + ".svg"), section.drawn[figure.id]);
  }
  for (const auto& table : section.section.tables)
    replace_file(out / "data" / ("table-" + table.id + ".csv"), csv_text(csv_of(table)));
}

}  // namespace

std::string chapter_of(int place) {
  static const std::vector<std::string> names{"One dimension",
                                              "Operators",
                                              "Manufactured solutions",
                                              "Error against run time",
                                              "The paper's cases",
                                              "Conservation",
                                              "Stability and spectra",
                                              "Claims and planted faults",
                                              "Speed",
                                              "Bad input"};
  const int chapter = place / 100 - 1;
  return chapter >= 0 && chapter < static_cast<int>(names.size()) ? names[chapter] : "Further";
}

std::vector<SectionPlan> section_plans(Extent extent) {
  auto plans = sections::all(extent);
  std::stable_sort(plans.begin(), plans.end(),
                   [](const auto& a, const auto& b) { return a.place < b.place; });
  return plans;
}

ReportSummary make_report(const ReportOptions& options) {
  const auto plans = chosen_plans(options);
  for (const char* folder : {"data", "figures", "store"}) make_folder(options.out / folder);
  ReportSummary summary;
  summary.page = options.out / "index.html";
  const Results results = run_jobs(plans, options, summary);
  Page page{"Plumbline verification report",
            "Total Lagrangian SPH with corrected kernels and bond-based deformation gradients, "
            "held against mathematics and against what the papers print. The numbers come from "
            "the commands shown with them; three kinds do not and say so: recorded values of the "
            "ledger of claims, the stored score of planted faults, and speeds of other codes.",
            options.facts,
            {}};
  for (const auto& plan : plans) {
    page.sections.push_back(written(plan, results, summary));
    write_data(page.sections.back(), options.out);
  }
  if (options.only.empty() && options.extent == Extent::core)
    page.facts.emplace_back("left to plumb report --full",
                            fmt::format("{}; and finer levels of what is here",
                                        fmt::join(titles_left_out(options.extent), "; ")));
  page.facts.emplace_back("machine", run::machine());
  page.facts.emplace_back(
      "cost of the studies",
      fmt::format("{} of CPU time in {} runs; {} of them were stored, from the same code and files",
                  duration_text(summary.cpu_s), summary.jobs, summary.reused));
  for (const auto& section : page.sections)
    for (const auto& check : section.section.checks) summary.checks.push_back({section.id, check});
  summary.verdicts = count_verdicts(page.sections);
  replace_file(summary.page, html(page));
  return summary;
}

}  // namespace plumb::reports
