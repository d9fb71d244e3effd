#include "reports/comparison/steps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace plumb::reports::comparison {
namespace {

using Json = nlohmann::ordered_json;

/// Why a run is not stable; empty if it is.
std::string trouble(const Json& summary, double energy_within) {
  if (summary.at("failure").is_object())
    return fmt::format("{} at {:.3g} s", text(summary.at("failure"), "cause"),
                       number(summary.at("failure"), "time"));
  const double change = number(summary.at("energy"), "relative_change");
  return std::abs(change) <= energy_within ? "" : fmt::format("its energy changes by {:.3g} %", 100 * change);
}

}  // namespace

std::vector<Job> jobs_of(const StepLadder& ladder, const Scheme& scheme) {
  const Cell cell = cell_of(ladder.cells, scheme.id);
  std::vector<Job> jobs;
  if (!cell.cannot.empty()) return jobs;
  for (std::size_t rung = 0; rung < ladder.cfl.size(); ++rung) {
    Job job{fmt::format("five-step-{}-{}", scheme.id, rung + 1), {"run", ladder.scene}, {ladder.scene}};
    for (const auto* settings : {&ladder.set, &scheme.set, &cell.set})
      for (const auto& one : *settings) job.arguments.insert(job.arguments.end(), {"--set", one});
    job.arguments.insert(job.arguments.end(),
                         {"--set", fmt::format("method.cfl={}", ladder.cfl[rung]), "--out", "{out}"});
    jobs.push_back(job);
  }
  return jobs;
}

LargestStep largest_step(const Results& results, const StepLadder& ladder, const Scheme& scheme) {
  LargestStep found;
  const auto jobs = jobs_of(ladder, scheme);
  found.next = cell_of(ladder.cells, scheme.id).cannot;
  if (jobs.empty()) return found;
  for (std::size_t rung = 0; rung < jobs.size(); ++rung) {
    const Json summary = results.json(jobs[rung].id);
    if (const std::string why = trouble(summary, ladder.energy_within); !why.empty()) {
      found.next = fmt::format("{:.3g}: {}", ladder.cfl[rung], why);
      return found;
    }
    found.cfl = ladder.cfl[rung];
    found.step = number(summary.at("dt"), "first");
  }
  found.at_least = true;
  found.next = "no larger one was tried";
  return found;
}

}  // namespace plumb::reports::comparison
