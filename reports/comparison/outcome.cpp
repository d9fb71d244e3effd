#include "reports/comparison/outcome.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

namespace plumb::reports::comparison {
namespace {

using Json = nlohmann::ordered_json;
using Columns = std::map<std::string, std::vector<double>>;

std::optional<double> optional_number(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

const std::vector<double>& column(const Columns& series, const std::string& name) {
  const auto found = series.find(name);
  if (found == series.end()) throw MissingResult(fmt::format("a series has no column \"{}\"", name));
  return found->second;
}

/// The turn of a point about the axis between the two directions [degrees], followed from row to row: less
/// than half a turn lies between two rows.
double turned(const std::vector<double>& u, const std::vector<double>& v, const std::vector<double>& from) {
  double sum = 0, before = std::atan2(from[1], from[0]);
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double now = std::atan2(from[1] + v[k], from[0] + u[k]);
    sum += std::remainder(now - before, 2 * std::numbers::pi);
    before = now;
  }
  return std::abs(sum) * 180 / std::numbers::pi;
}

/// Twice the time at which a column first comes back through zero, by a straight line between two rows.
std::optional<double> half_swing(const std::vector<double>& time, const std::vector<double>& value) {
  for (std::size_t k = 1; k < value.size(); ++k)
    if (value[k - 1] * value[k] < 0)
      return 2 * (time[k - 1] + (time[k] - time[k - 1]) * value[k - 1] / (value[k - 1] - value[k]));
  return std::nullopt;
}

EnergyShares shares_of(const Json& energy, double start) {
  EnergyShares shares;
  shares.change = number(energy, "total") / start - 1;
  if (const auto lost = optional_number(energy, "dissipated")) shares.dissipated = *lost / start;
  for (const auto& [name, value] : energy.at("terms").items())
    (name == "plastic work" ? shares.plastic : shares.more) += value.get<double>() / start;
  shares.unexplained = shares.change + shares.dissipated.value_or(0);
  for (const char* work : {"load_work", "damping_work", "support_work"})
    shares.unexplained -= optional_number(energy, work).value_or(0) / start;
  return shares;
}

/// A refusal without what stands before its words: exit code, program, and the place in a file.
std::string words_of(const std::string& failure) {
  static const std::regex before(R"(^.*?plumb: (\S+\.toml(:\d+)?: (\S+: )?)?)");
  return std::regex_replace(failure, before, "");
}

void read_study(Outcome& out, const Json& result) {
  for (const auto& level : result.at("levels")) {
    out.levels.push_back({number(level, "d"), optional_number(level, "relative_l2"),
                          optional_number(level, "cpu_s"), optional_number(level, "steps")});
    const auto status = level.find("status");
    if (status == level.end() || !status->is_string() || out.state == State::unstable) continue;
    out.state = State::unstable;
    out.why = fmt::format("{} with d = {:.3g} m", status->get<std::string>(), number(level, "d"));
  }
}

void read_run(Outcome& out, const Problem& problem, double spacing, const Json& summary,
              const Columns& series) {
  LevelFound level{spacing, std::nullopt, optional_number(summary.at("timing"), "cpu_s"),
                   optional_number(summary, "steps")};
  if (text(summary, "status") == "completed") {
    level.error = error_of(problem.quantity, spacing, summary, series);
    out.bytes_per_particle = optional_number(summary.at("memory"), "bytes_per_particle");
    if (problem.free) {
      out.linear_drift = number(summary, "linear_drift");
      out.angular_drift = number(summary, "angular_drift");
    }
    if (!problem.still) out.energy = shares_of(summary.at("energy"), number(summary.at("energy"), "initial"));
  }
  if (!level.error && out.state != State::unstable) {
    out.state = State::unstable;
    const Json& failure = summary.at("failure");
    out.why = failure.is_object() ? fmt::format("unstable: {} at {:.3g} s with d = {:.3g} m",
                                                text(failure, "cause"), number(failure, "time"), spacing)
                                  : fmt::format("does not come back to rest with d = {:.3g} m", spacing);
  }
  out.levels.push_back(level);
}

void fit(Outcome& out) {
  std::vector<Level> levels;
  for (const auto& level : out.levels)
    if (level.error && *level.error > 0) levels.push_back({level.spacing, *level.error});
  if (!levels.empty()) out.fit = fit_order(levels);
}

}  // namespace

std::optional<LevelFound> Outcome::finest() const {
  return !levels.empty() && levels.back().error ? std::optional(levels.back()) : std::nullopt;
}

std::optional<double> error_of(const Quantity& q, double spacing, const Json& summary,
                               const Columns& series) {
  std::vector<double> found;
  for (const auto& place : q.at) {
    const Json::json_pointer pointer(place);
    if (!summary.contains(pointer)) throw MissingResult(fmt::format("a result has no \"{}\"", place));
    found.push_back(summary.at(pointer).get<double>() + q.plus_spacing * spacing);
  }
  if (!q.turn_of.empty())
    found.push_back(turned(column(series, q.turn_of[0]), column(series, q.turn_of[1]), q.turn_from));
  if (!q.half_swing_of.empty()) {
    const auto period = half_swing(column(series, "time [s]"), column(series, q.half_swing_of));
    if (!period) return std::nullopt;
    found.push_back(*period);
  }
  double square = 0;
  for (std::size_t k = 0; k < found.size(); ++k) square += std::pow(found[k] - q.truth.at(k), 2);
  return std::sqrt(square) / q.scale;
}

Outcome outcome_of(const Results& results, const Problem& problem, const Scheme& scheme) {
  Outcome out;
  const Cell cell = problem.cell(scheme.id);
  out.note = cell.note;
  out.other_law = cell.other_law;
  const auto jobs = jobs_of(problem, scheme);
  for (std::size_t level = 0; level < jobs.size(); ++level) {
    const JobResult& job = results.job(jobs[level].id);
    if (job.exit_code == 2 && job.failure.find(cell.refuses) != std::string::npos && !cell.refuses.empty()) {
      out.state = State::refused;
      out.why = words_of(job.failure);
      return out;
    }
    const Json result = results.json(jobs[level].id);
    out.peak_rss = job.peak_rss;
    if (problem.study)
      read_study(out, result);
    else
      read_run(out, problem, problem.spacings[level], result, results.csv(jobs[level].id, "series.csv"));
  }
  fit(out);
  return out;
}

std::optional<CostAtError> cost_at(const Outcome& outcome, double error) {
  const auto& levels = outcome.levels;
  const auto reached = [&](const LevelFound& level) { return level.error && *level.error <= error; };
  if (levels.empty() || !reached(levels.back())) return std::nullopt;
  std::size_t k = levels.size() - 1;
  while (k > 0 && reached(levels[k - 1])) --k;
  if (!levels[k].cpu_s) return std::nullopt;
  if (k == 0) return CostAtError{*levels[0].cpu_s, true};
  const LevelFound &coarse = levels[k - 1], &fine = levels[k];
  if (!coarse.error || !coarse.cpu_s || !(*fine.error > 0)) return CostAtError{*fine.cpu_s, true};
  const double share = std::log(*coarse.error / error) / std::log(*coarse.error / *fine.error);
  return CostAtError{*coarse.cpu_s * std::pow(*fine.cpu_s / *coarse.cpu_s, share)};
}

}  // namespace plumb::reports::comparison
