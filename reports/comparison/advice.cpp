#include "reports/comparison/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace plumb::reports::comparison {
namespace {

struct Runner {
  std::string name;
  double value;
};

bool is_elements(const Scheme& scheme) {
  return scheme.paper == "elements";
}

std::string cost_text(const CostAtError& cost) {
  return fmt::format("{}{:.2g} s", cost.at_most ? "at most " : "", cost.cpu_s);
}

/// Names with a value each, least first: "a (1), b (2)"; "none" without any.
std::string listed(std::vector<Runner> all, const std::function<std::string(double)>& shown) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  std::string out;
  for (const auto& one : all)
    out += fmt::format("{}{} ({})", out.empty() ? "" : "; ", one.name, shown(one.value));
  return out.empty() ? "none" : out;
}

std::string names(const std::vector<Runner>& all) {
  std::string out;
  for (const auto& one : all) out += (out.empty() ? "" : "; ") + one.name;
  return out.empty() ? "none" : out;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : std::sqrt(values[n / 2 - 1] * values[n / 2]);
}

std::optional<Advice> about_momenta(const Table& table, const Outcomes& outcomes, const Problem& problem) {
  // round-off of some hundred steps; what is lost by a scheme is a million times that
  constexpr double kept_to = 1e-11;
  std::vector<Runner> kept, lost;
  for (const auto& scheme : table.schemes)
    if (const auto drift = outcomes.at({problem.id, scheme.id}).angular_drift)
      (*drift <= kept_to ? kept : lost).push_back({scheme.name, *drift});
  if (kept.empty() && lost.empty()) return std::nullopt;
  const auto shown = [](double v) { return fmt::format("{:.1g}", v); };
  return Advice{
      fmt::format("Which keeps angular momentum ({})?", problem.title), names(kept),
      fmt::format("Relative change of those: {}. The others: {}.", listed(kept, shown), listed(lost, shown))};
}

/// The largest share of the energy at the start that nothing accounts for, over the problems of a scheme.
Advice about_energy(const Table& table, const Outcomes& outcomes) {
  std::vector<Runner> all;
  for (const auto& scheme : table.schemes) {
    std::optional<double> worst;
    for (const auto& problem : table.problems)
      if (const auto& energy = outcomes.at({problem.id, scheme.id}).energy)
        worst = std::max(worst.value_or(0), std::abs(energy->unexplained));
    if (worst) all.push_back({scheme.name, *worst});
  }
  std::vector<Runner> good;
  constexpr double accounted = 0.01;
  for (const auto& one : all)
    if (one.value <= accounted) good.push_back(one);
  return {"Which accounts for its energy to 1 %?", names(good),
          fmt::format("Largest unexplained share over the problems that ran: {}.", listed(all, percent))};
}

/// The schemes that reach the error of the harder form, and every error over that of the easier one.
Advice about_harder(const Table& table, const Outcomes& outcomes, const Problem& problem) {
  std::vector<Runner> all, good;
  std::string easier;
  for (const auto& other : table.problems)
    if (other.id == problem.beside) easier = other.title;
  for (const auto& scheme : table.schemes) {
    const auto hard = outcomes.at({problem.id, scheme.id}).finest(),
               easy = outcomes.at({problem.beside, scheme.id}).finest();
    if (!hard) continue;
    if (*hard->error <= problem.equal_error) good.push_back({scheme.name, *hard->error});
    if (easy && *easy->error > 0) all.push_back({scheme.name, *hard->error / *easy->error});
  }
  const auto shown = [](double v) { return fmt::format("{:.2g}", v); };
  return {
      fmt::format("Which bears {}?", problem.asks), names(good),
      fmt::format(
          "Errors of at most {} at the finest spacing of \"{}\": {}. The error over that of \"{}\": {}.",
          percent(problem.equal_error), problem.title, listed(good, percent), easier, listed(all, shown))};
}

/// Errors as printed over errors as mended, at the finest spacing of every problem that both ran with its law.
std::optional<Advice> about_mending(const Table& table, const Outcomes& outcomes, const Scheme& printed) {
  const auto mended = std::find_if(table.schemes.begin(), table.schemes.end(), [&](const Scheme& one) {
    return one.paper == printed.paper && !one.printed;
  });
  if (mended == table.schemes.end()) return std::nullopt;
  std::vector<double> ratios;
  std::size_t only_mended = 0;
  for (const auto& problem : table.problems) {
    const Outcome &before = outcomes.at({problem.id, printed.id}),
                  &after = outcomes.at({problem.id, mended->id});
    if (before.other_law || after.other_law) continue;
    const auto a = before.finest(), b = after.finest();
    only_mended += b && !a ? 1 : 0;
    if (a && b && *b->error > 0) ratios.push_back(*a->error / *b->error);
  }
  if (ratios.empty()) return std::nullopt;
  const auto better = std::count_if(ratios.begin(), ratios.end(), [](double r) { return r > 1; });
  const double middle = median(ratios);
  return Advice{
      fmt::format("Paper {}: as printed or mended?", printed.paper), middle > 1 ? mended->name : printed.name,
      fmt::format("The mended form has the smaller error on {} of {} problems that both ran; the printed "
                  "error is {:.2g} times the mended one in the median. {} more ran mended only.",
                  better, ratios.size(), middle, only_mended)};
}

}  // namespace

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

Outcomes outcomes_of(const Results& results, const Table& table) {
  Outcomes all;
  for (const auto& problem : table.problems)
    for (const auto& scheme : table.schemes)
      all[{problem.id, scheme.id}] = outcome_of(results, problem, scheme);
  return all;
}

Advice advice_for(const Table& table, const Outcomes& outcomes, const Problem& problem) {
  struct Candidate {
    std::string name;
    CostAtError cost;
  };
  std::vector<Candidate> reach;
  std::optional<CostAtError> elements;
  std::optional<std::pair<std::string, LevelFound>> closest;
  for (const auto& scheme : table.schemes) {
    const Outcome& outcome = outcomes.at({problem.id, scheme.id});
    const auto cost = cost_at(outcome, problem.equal_error);
    if (is_elements(scheme)) {
      elements = cost;
      continue;
    }
    if (!outcome.sound()) continue;
    if (cost) reach.push_back({scheme.name, *cost});
    if (const auto finest = outcome.finest(); finest && (!closest || *finest->error < *closest->second.error))
      closest = {scheme.name, *finest};
  }
  std::stable_sort(reach.begin(), reach.end(),
                   [](const auto& a, const auto& b) { return a.cost.cpu_s < b.cost.cpu_s; });
  const std::string question = fmt::format("{}: {}?", problem.title, problem.asks);
  if (reach.empty())
    return {question, "none",
            closest
                ? fmt::format("None has an error of {} at these spacings. {} comes closest: {} in {:.2g} s.",
                              percent(problem.equal_error), closest->first, percent(*closest->second.error),
                              closest->second.cpu_s.value_or(0))
                : "None ran to its end."};
  std::string because = fmt::format("An error of {} takes {} of CPU time", percent(problem.equal_error),
                                    cost_text(reach[0].cost));
  if (reach.size() > 1)
    because += fmt::format("; next is {} with {}", reach[1].name, cost_text(reach[1].cost));
  if (elements) because += fmt::format("; finite elements take {}", cost_text(*elements));
  return {question, reach[0].name, because + "."};
}

std::vector<Advice> advice_by_problem(const Table& table, const Outcomes& outcomes) {
  std::vector<Advice> all;
  for (const auto& problem : table.problems) all.push_back(advice_for(table, outcomes, problem));
  return all;
}

std::vector<Advice> advice_over_all(const Table& table, const Outcomes& outcomes) {
  std::vector<Advice> all;
  for (const auto& problem : table.problems)
    if (auto one = about_momenta(table, outcomes, problem)) all.push_back(std::move(*one));
  all.push_back(about_energy(table, outcomes));
  for (const auto& problem : table.problems)
    if (!problem.beside.empty()) all.push_back(about_harder(table, outcomes, problem));
  for (const auto& scheme : table.schemes)
    if (scheme.printed)
      if (auto one = about_mending(table, outcomes, scheme)) all.push_back(std::move(*one));
  return all;
}

std::pair<std::string, std::size_t> most_taken(const Table& table, const Outcomes& outcomes) {
  std::map<std::string, std::size_t> counts;
  std::pair<std::string, std::size_t> best;
  for (const auto& problem : table.problems) ++counts[advice_for(table, outcomes, problem).take];
  for (const auto& scheme : table.schemes)
    if (counts[scheme.name] > best.second) best = {scheme.name, counts[scheme.name]};
  return best;
}

}  // namespace plumb::reports::comparison
